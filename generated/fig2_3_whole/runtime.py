# Interlocking fig2_3_whole, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout 3589f3b4f15624e2d7955ca104f194dc05e926516f34128dd071d86db8c8c1fb
# claims c0f3f888eef56e7bd66ea1731f7827616ceb98febf62f0641ce634def82f3acf
"""Interlocking fig2_3_whole: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_X3': (0, 2),  # operator: cancel the route from X3
    'CAN_X4': (0, 2),  # operator: cancel the route from X4
    'CAN_X5': (0, 2),  # operator: cancel the route from X5
    'REQ': (0, 5),  # operator: set route number, 0 = none
    'LREQ': (0, 5),  # operator on the spot: set route number, 0 = none
    'CLR_III': (0, 2),  # section III reported clear
    'CLR_SB': (0, 2),  # section SB reported clear
    'CLR_SC': (0, 2),  # section SC reported clear
    'CLR_SD': (0, 2),  # section SD reported clear
    'REL_III': (0, 2),  # operator: release section III (hold until released)
    'REL_SC': (0, 2),  # operator: release section SC (hold until released)
    'BLK_III': (1, 2),  # operator: section III is blocked
    'BLK_SC': (1, 2),  # operator: section SC is blocked
    'RELALL': (0, 2),  # operator: release all clear sections after a restart
    'DN_P1': (0, 2),  # machine P1 detected normal
    'DR_P1': (0, 2),  # machine P1 detected reverse
    'MN_P1': (0, 2),  # operator: move machine P1 normal
    'MR_P1': (0, 2),  # operator: move machine P1 reverse
    'TC_P1': (0, 2),  # operator: machine P1 has been looked at after it was trailed
}
# name: value at a restart, meaning
STATE = {
    'CN_P1': False,  # machine P1 commanded N
    'CR_P1': False,  # machine P1 commanded R
    'AL_P1': False,  # alarm: machine P1 not detected
    'TH_P1': False,  # machine P1 was detected where it is commanded
    'TR_P1': False,  # machine P1 was trailed
    'A_R1': False,  # route X3-D active
    'B_R1': False,  # route X3-D locked
    'W_R1': False,  # route X3-D: proceed wanted
    'S_R1': False,  # route X3-D: proceed
    'H_R1': False,  # route X3-D: signal has been open
    'A_R2': False,  # route X3-X5 active
    'B_R2': False,  # route X3-X5 locked
    'W_R2': False,  # route X3-X5: proceed wanted
    'S_R2': False,  # route X3-X5: proceed
    'H_R2': False,  # route X3-X5: signal has been open
    'A_R3': False,  # route X4-B active
    'B_R3': False,  # route X4-B locked
    'W_R3': False,  # route X4-B: proceed wanted
    'S_R3': False,  # route X4-B: proceed
    'H_R3': False,  # route X4-B: signal has been open
    'A_R4': False,  # route X5-C active
    'B_R4': False,  # route X5-C locked
    'W_R4': False,  # route X5-C: proceed wanted
    'S_R4': False,  # route X5-C: proceed
    'H_R4': False,  # route X5-C: signal has been open
    'X_X3': False,  # X3: cancelling
    'X_X4': False,  # X4: cancelling
    'X_X5': False,  # X5: cancelling
    'K_III': True,  # III: restart lock (R16)
    'L_III_1': False,  # III locked from B to D
    'L_III_2': False,  # III locked from B to III|SC@main.0
    'L_III_3': False,  # III locked from D to B
    'F_III': False,  # III firmly locked
    'U_III': True,  # III used by a train (R9)
    'P_III': False,  # III: the train went on (R9)
    'D_III': False,  # III: detection is not relied on, inputs were lost or a train is called on
    'K_SC': True,  # SC: restart lock (R16)
    'L_SC_2': False,  # SC locked from III|SC@main.0 to C
    'F_SC': False,  # SC firmly locked
    'U_SC': True,  # SC used by a train (R9)
    'P_SC': False,  # SC: the train went on (R9)
    'D_SC': False,  # SC: detection is not relied on, inputs were lost or a train is called on
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_X3': 60000,  # X3: approach locking delay (R8)
    'AT_X4': 60000,  # X4: approach locking delay (R8)
    'AT_X5': 60000,  # X5: approach locking delay (R8)
    'RT_III': 3000,  # III: release delay (R9)
    'RT_SC': 3000,  # SC: release delay (R9)
    'ST_P1': 13000,  # machine P1: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_P1': False,  # machine P1: normal
    'YR_P1': False,  # machine P1: reverse
    'YA_P1': False,  # alarm: machine P1 not detected in time
    'YT_P1': False,  # alarm: machine P1 was trailed
    'YL_III': True,  # indication: III is locked
    'YL_SC': True,  # indication: SC is locked
    'YP_X3': False,  # signal X3: clear (green)
    'YS_X3': True,  # signal X3: stop
    'YP_X4': False,  # signal X4: clear (green)
    'YS_X4': True,  # signal X4: stop
    'YP_X5': False,  # signal X5: clear (green)
    'YS_X5': True,  # signal X5: stop
}


class Controller:
    """A running controller; `state` and `elapsed` are all that it remembers."""

    def __init__(self):
        self.state = dict(STATE)
        self.elapsed = dict.fromkeys(TIMERS, 0)

    def _timer(self, name, on, dt_ms):
        if not on:
            self.elapsed[name] = 0
            return False
        self.elapsed[name] = min(self.elapsed[name] + dt_ms, TIMERS[name])
        return self.elapsed[name] >= TIMERS[name]

    def scan(self, inputs, dt_ms):
        """One scan, `dt_ms` milliseconds after the last; returns the outputs."""
        read = {}
        for name, (restrictive, size) in INPUTS.items():
            value = int(inputs.get(name, restrictive))
            read[name] = value if 0 <= value < size else restrictive
        old = self.state
        VALID = read['VALID']
        CAN_X3 = read['CAN_X3']
        CAN_X4 = read['CAN_X4']
        CAN_X5 = read['CAN_X5']
        REQ = read['REQ']
        LREQ = read['LREQ']
        CLR_III = read['CLR_III']
        CLR_SB = read['CLR_SB']
        CLR_SC = read['CLR_SC']
        CLR_SD = read['CLR_SD']
        REL_III = read['REL_III']
        REL_SC = read['REL_SC']
        BLK_III = read['BLK_III']
        BLK_SC = read['BLK_SC']
        RELALL = read['RELALL']
        DN_P1 = read['DN_P1']
        DR_P1 = read['DR_P1']
        MN_P1 = read['MN_P1']
        MR_P1 = read['MR_P1']
        TC_P1 = read['TC_P1']
        CN_P1 = old['CN_P1']
        CR_P1 = old['CR_P1']
        AL_P1 = old['AL_P1']
        TH_P1 = old['TH_P1']
        TR_P1 = old['TR_P1']
        A_R1 = old['A_R1']
        B_R1 = old['B_R1']
        W_R1 = old['W_R1']
        S_R1 = old['S_R1']
        H_R1 = old['H_R1']
        A_R2 = old['A_R2']
        B_R2 = old['B_R2']
        W_R2 = old['W_R2']
        S_R2 = old['S_R2']
        H_R2 = old['H_R2']
        A_R3 = old['A_R3']
        B_R3 = old['B_R3']
        W_R3 = old['W_R3']
        S_R3 = old['S_R3']
        H_R3 = old['H_R3']
        A_R4 = old['A_R4']
        B_R4 = old['B_R4']
        W_R4 = old['W_R4']
        S_R4 = old['S_R4']
        H_R4 = old['H_R4']
        X_X3 = old['X_X3']
        X_X4 = old['X_X4']
        X_X5 = old['X_X5']
        K_III = old['K_III']
        L_III_1 = old['L_III_1']
        L_III_2 = old['L_III_2']
        L_III_3 = old['L_III_3']
        F_III = old['F_III']
        U_III = old['U_III']
        P_III = old['P_III']
        D_III = old['D_III']
        K_SC = old['K_SC']
        L_SC_2 = old['L_SC_2']
        F_SC = old['F_SC']
        U_SC = old['U_SC']
        P_SC = old['P_SC']
        D_SC = old['D_SC']
        OCC_III = (not CLR_III) or (not VALID)  # III counts as occupied
        OCC_SB = (not CLR_SB) or (not VALID)  # SB counts as occupied
        OCC_SC = (not CLR_SC) or (not VALID)  # SC counts as occupied
        OCC_SD = (not CLR_SD) or (not VALID)  # SD counts as occupied
        FREE_III = (not K_III) and (not L_III_1) and (not L_III_2) and (not L_III_3)  # III is not locked by anybody
        FREE_SC = (not K_SC) and (not L_SC_2)  # SC is not locked by anybody
        QN_P1 = VALID and DN_P1 and (not DR_P1)  # machine P1 lies N (R10)
        QR_P1 = VALID and DR_P1 and (not DN_P1)  # machine P1 lies R (R10)
        MOV_P1 = VALID and FREE_III and (not OCC_III) and True and True  # machine P1 is free to move (R10)
        AVN_P1 = CN_P1 or MOV_P1 or (QN_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded N
        AVR_P1 = CR_P1 or MOV_P1 or (QR_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded R
        WA_III_1 = AVR_P1 and (not TR_P1)  # III from B to D: could be locked
        WF_III_1 = FREE_III and (not OCC_III) and (not BLK_III) and WA_III_1  # III from B to D: free for a route (R6)
        WA_III_2 = AVN_P1 and (not TR_P1)  # III from B to III|SC@main.0: could be locked
        WF_III_2 = FREE_III and (not OCC_III) and (not BLK_III) and WA_III_2  # III from B to III|SC@main.0: free for a route (R6)
        WA_III_3 = AVR_P1 and (not TR_P1)  # III from D to B: could be locked
        WF_III_3 = FREE_III and (not OCC_III) and (not BLK_III) and WA_III_3  # III from D to B: free for a route (R6)
        WF_SC_2 = FREE_SC and (not OCC_SC) and (not BLK_SC)  # SC from III|SC@main.0 to C: free for a route (R6)
        WD_III_1 = QR_P1 and (not TR_P1)  # III from B to D: its points lie, nothing is foul of it
        WL_III_1 = (not OCC_III) and WD_III_1  # III from B to D: lies and is clear
        WP_III_1 = WL_III_1 and (not BLK_III)  # III from B to D: proceed may be shown over it (R3)
        WD_III_2 = QN_P1 and (not TR_P1)  # III from B to III|SC@main.0: its points lie, nothing is foul of it
        WL_III_2 = (not OCC_III) and WD_III_2  # III from B to III|SC@main.0: lies and is clear
        WP_III_2 = WL_III_2 and (not BLK_III)  # III from B to III|SC@main.0: proceed may be shown over it (R3)
        WD_III_3 = QR_P1 and (not TR_P1)  # III from D to B: its points lie, nothing is foul of it
        WL_III_3 = (not OCC_III) and WD_III_3  # III from D to B: lies and is clear
        WP_III_3 = WL_III_3 and (not BLK_III)  # III from D to B: proceed may be shown over it (R3)
        WL_SC_2 = (not OCC_SC)  # SC from III|SC@main.0 to C: lies and is clear
        WP_SC_2 = WL_SC_2 and (not BLK_SC)  # SC from III|SC@main.0 to C: proceed may be shown over it (R3)
        G_R1 = ((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and VALID and WF_III_1  # grant of route X3-D (R6)
        G_R2 = ((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) and VALID and WF_III_2  # grant of route X3-X5 (R6)
        G_R3 = ((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and VALID and WF_III_3  # grant of route X4-B (R6)
        G_R4 = ((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and VALID and WF_SC_2  # grant of route X5-C (R6)
        GW_III_1 = G_R1  # III from B to D: granted
        GW_III_2 = G_R2  # III from B to III|SC@main.0: granted
        GW_III_3 = G_R3  # III from D to B: granted
        GW_SC_2 = G_R4  # SC from III|SC@main.0 to C: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_X3) and (not CAN_X3) and WL_III_1  # route X3-D becomes locked (R3)
        CO_R1 = VALID and WP_III_1 and (not OCC_SD) and (not D_III)  # conditions of proceed for route X3-D (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_X3) and (not CAN_X3) and WL_III_2  # route X3-X5 becomes locked (R3)
        CO_R2 = VALID and WP_III_2 and (not D_III)  # conditions of proceed for route X3-X5 (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_X4) and (not CAN_X4) and WL_III_3  # route X4-B becomes locked (R3)
        CO_R3 = VALID and WP_III_3 and (not OCC_SB) and (not D_III)  # conditions of proceed for route X4-B (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_X5) and (not CAN_X5) and WL_SC_2  # route X5-C becomes locked (R3)
        CO_R4 = VALID and WP_SC_2 and (not D_SC)  # conditions of proceed for route X5-C (R3)
        NU_III_1 = VALID and F_III and (not D_III) and (not U_III) and (L_III_1 or L_III_2) and OCC_III and OCC_SB  # a train comes into III at B (R9)
        NU_III_2 = VALID and F_III and (not D_III) and (not U_III) and L_III_3 and OCC_III and OCC_SD  # a train comes into III at D (R9)
        NU_SC_2 = VALID and F_SC and (not D_SC) and (not U_SC) and L_SC_2 and OCC_SC and OCC_III  # a train comes into SC at III|SC@main.0 (R9)
        ATI_X3 = X_X3 or ((not (A_R1 or A_R2)) and (L_III_1 or L_III_2) and (REL_III or (L_III_1 and U_III and (not OCC_III))))  # X3 at stop, waiting for a train that may still come (R8)
        ATI_X4 = X_X4 or ((not A_R3) and L_III_3 and (REL_III or (L_III_3 and U_III and (not OCC_III))))  # X4 at stop, waiting for a train that may still come (R8)
        ATI_X5 = X_X5 or ((not A_R4) and L_SC_2 and (REL_SC or (L_SC_2 and U_SC and (not OCC_SC))))  # X5 at stop, waiting for a train that may still come (R8)
        AT_X3 = self._timer('AT_X3', ATI_X3, dt_ms)  # X3: approach locking delay (R8)
        AT_X4 = self._timer('AT_X4', ATI_X4, dt_ms)  # X4: approach locking delay (R8)
        AT_X5 = self._timer('AT_X5', ATI_X5, dt_ms)  # X5: approach locking delay (R8)
        CD_X3 = X_X3 and (A_R1 or A_R2) and VALID and (not OCC_III) and ((not OCC_SB) or AT_X3 or (not (H_R1 or H_R2)))  # the route from X3 is cancelled (R8)
        CD_X4 = X_X4 and A_R3 and VALID and (not OCC_III) and ((not OCC_SD) or AT_X4 or (not H_R3))  # the route from X4 is cancelled (R8)
        CD_X5 = X_X5 and A_R4 and VALID and (not OCC_SC) and ((not OCC_III) or AT_X5 or (not H_R4))  # the route from X5 is cancelled (R8)
        EX_III = P_III or (L_III_1 and ((not OCC_SB) or AT_X3)) or (L_III_3 and ((not OCC_SD) or AT_X4))  # a train in III leaves over a boundary, or has passed on
        RTI_III = VALID and U_III and (not OCC_III) and EX_III  # III may be released behind the train (R9)
        EX_SC = P_SC or (L_SC_2 and ((not OCC_III) or AT_X5))  # a train in SC leaves over a boundary, or has passed on
        RTI_SC = VALID and U_SC and (not OCC_SC) and EX_SC  # SC may be released behind the train (R9)
        RT_III = self._timer('RT_III', RTI_III, dt_ms)  # III: release delay (R9)
        RT_SC = self._timer('RT_SC', RTI_SC, dt_ms)  # SC: release delay (R9)
        CA_III = VALID and (not OCC_III) and (not U_III) and False  # the lock before III was withdrawn (R8)
        HR_III = VALID and (not OCC_III) and REL_III and (L_III_1 or L_III_2 or L_III_3) and ((not (L_III_1 or L_III_2)) or ((not (A_R1 or A_R2)) and ((not OCC_SB) or AT_X3))) and ((not L_III_3) or ((not A_R3) and ((not OCC_SD) or AT_X4)))  # III released by hand (R8, section fault release)
        SR_III = VALID and (not OCC_III) and K_III and (REL_III or RELALL)  # III released after a restart (R16)
        RLS_III = RT_III or CA_III or CD_X3 or CD_X4 or HR_III or SR_III  # III is released
        CA_SC = VALID and (not OCC_SC) and (not U_SC) and False  # the lock before SC was withdrawn (R8)
        HR_SC = VALID and (not OCC_SC) and REL_SC and L_SC_2 and ((not L_SC_2) or ((not A_R4) and ((not OCC_III) or AT_X5)))  # SC released by hand (R8, section fault release)
        SR_SC = VALID and (not OCC_SC) and K_SC and (REL_SC or RELALL)  # SC released after a restart (R16)
        RLS_SC = RT_SC or CA_SC or CD_X5 or HR_SC or SR_SC  # SC is released
        TG_P1 = (GW_III_1 or GW_III_2 or GW_III_3)  # a grant touches machine P1 in this scan
        GPN_P1 = GW_III_2  # a grant needs P1 N
        MAN_P1 = MN_P1 and (not MR_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved N by hand
        GPR_P1 = (GW_III_1 or GW_III_3)  # a grant needs P1 R
        MAR_P1 = MR_P1 and (not MN_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved R by hand
        HDN_P1 = CN_P1 and (not GPR_P1) and (not MAR_P1)  # the command N stays
        HDR_P1 = CR_P1 and (not GPN_P1) and (not MAN_P1)  # the command R stays
        STI_P1 = (CN_P1 and (not QN_P1)) or (CR_P1 and (not QR_P1))  # machine P1 is not where it was commanded
        ST_P1 = self._timer('ST_P1', STI_P1, dt_ms)  # machine P1: time-out
        KP_R1 = (not NU_III_1) and (not CD_X3)  # route X3-D stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_X3) and (not CAN_X3)  # proceed for route X3-D (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route X3-D: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_III_1) and (not CD_X3)  # route X3-X5 stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_X3) and (not CAN_X3)  # proceed for route X3-X5 (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route X3-X5: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_III_2) and (not CD_X4)  # route X4-B stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_X4) and (not CAN_X4)  # proceed for route X4-B (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route X4-B: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_SC_2) and (not CD_X5)  # route X5-C stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_X5) and (not CAN_X5)  # proceed for route X5-C (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route X5-C: a condition was lost; no reopening by itself (R14)
        N_CN_P1 = GPN_P1 or MAN_P1 or HDN_P1  # machine P1 commanded N
        N_CR_P1 = GPR_P1 or MAR_P1 or HDR_P1  # machine P1 commanded R
        N_AL_P1 = ST_P1  # alarm: machine P1 not detected
        N_TH_P1 = ((CN_P1 and QN_P1) or (CR_P1 and QR_P1)) and (not (GPN_P1 or GPR_P1 or MAN_P1 or MAR_P1))  # machine P1 was detected where it is commanded
        N_TR_P1 = (TH_P1 and VALID and ((CN_P1 and (not QN_P1) and (not GPR_P1) and (not MAR_P1)) or (CR_P1 and (not QR_P1) and (not GPN_P1) and (not MAN_P1)))) or (TR_P1 and (not (TC_P1 and VALID and (not OCC_III))))  # machine P1 was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route X3-D active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route X3-D locked
        N_W_R1 = (W_R1 or LK_R1 or (((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and B_R1)) and (not LS_R1) and KP_R1 and (not X_X3) and (not CAN_X3)  # route X3-D: proceed wanted
        N_S_R1 = PR_R1  # route X3-D: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route X3-D: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route X3-X5 active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route X3-X5 locked
        N_W_R2 = (W_R2 or LK_R2 or (((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) and B_R2)) and (not LS_R2) and KP_R2 and (not X_X3) and (not CAN_X3)  # route X3-X5: proceed wanted
        N_S_R2 = PR_R2  # route X3-X5: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route X3-X5: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route X4-B active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route X4-B locked
        N_W_R3 = (W_R3 or LK_R3 or (((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and B_R3)) and (not LS_R3) and KP_R3 and (not X_X4) and (not CAN_X4)  # route X4-B: proceed wanted
        N_S_R3 = PR_R3  # route X4-B: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route X4-B: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route X5-C active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route X5-C locked
        N_W_R4 = (W_R4 or LK_R4 or (((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and B_R4)) and (not LS_R4) and KP_R4 and (not X_X5) and (not CAN_X5)  # route X5-C: proceed wanted
        N_S_R4 = PR_R4  # route X5-C: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route X5-C: signal has been open
        N_X_X3 = (X_X3 or CAN_X3) and (A_R1 or A_R2) and (not CD_X3)  # X3: cancelling
        N_X_X4 = (X_X4 or CAN_X4) and A_R3 and (not CD_X4)  # X4: cancelling
        N_X_X5 = (X_X5 or CAN_X5) and A_R4 and (not CD_X5)  # X5: cancelling
        N_K_III = K_III and (not RLS_III)  # III: restart lock (R16)
        N_L_III_1 = (L_III_1 or GW_III_1) and (not RLS_III)  # III locked from B to D
        N_L_III_2 = (L_III_2 or GW_III_2) and (not RLS_III)  # III locked from B to III|SC@main.0
        N_L_III_3 = (L_III_3 or GW_III_3) and (not RLS_III)  # III locked from D to B
        N_F_III = (F_III or LK_R1 or LK_R2 or LK_R3) and (not RLS_III)  # III firmly locked
        N_U_III = (U_III or NU_III_1 or NU_III_2) and (not RLS_III)  # III used by a train (R9)
        N_P_III = (P_III or (U_III and OCC_III and NU_SC_2)) and (not RLS_III)  # III: the train went on (R9)
        N_D_III = (D_III or ((not VALID) and (L_III_1 or L_III_2 or L_III_3))) and (not RLS_III)  # III: detection is not relied on, inputs were lost or a train is called on
        N_K_SC = K_SC and (not RLS_SC)  # SC: restart lock (R16)
        N_L_SC_2 = (L_SC_2 or GW_SC_2) and (not RLS_SC)  # SC locked from III|SC@main.0 to C
        N_F_SC = (F_SC or LK_R4) and (not RLS_SC)  # SC firmly locked
        N_U_SC = (U_SC or NU_SC_2) and (not RLS_SC)  # SC used by a train (R9)
        N_P_SC = P_SC and (not RLS_SC)  # SC: the train went on (R9)
        N_D_SC = (D_SC or ((not VALID) and L_SC_2)) and (not RLS_SC)  # SC: detection is not relied on, inputs were lost or a train is called on
        self.state = {
            'CN_P1': bool(N_CN_P1),
            'CR_P1': bool(N_CR_P1),
            'AL_P1': bool(N_AL_P1),
            'TH_P1': bool(N_TH_P1),
            'TR_P1': bool(N_TR_P1),
            'A_R1': bool(N_A_R1),
            'B_R1': bool(N_B_R1),
            'W_R1': bool(N_W_R1),
            'S_R1': bool(N_S_R1),
            'H_R1': bool(N_H_R1),
            'A_R2': bool(N_A_R2),
            'B_R2': bool(N_B_R2),
            'W_R2': bool(N_W_R2),
            'S_R2': bool(N_S_R2),
            'H_R2': bool(N_H_R2),
            'A_R3': bool(N_A_R3),
            'B_R3': bool(N_B_R3),
            'W_R3': bool(N_W_R3),
            'S_R3': bool(N_S_R3),
            'H_R3': bool(N_H_R3),
            'A_R4': bool(N_A_R4),
            'B_R4': bool(N_B_R4),
            'W_R4': bool(N_W_R4),
            'S_R4': bool(N_S_R4),
            'H_R4': bool(N_H_R4),
            'X_X3': bool(N_X_X3),
            'X_X4': bool(N_X_X4),
            'X_X5': bool(N_X_X5),
            'K_III': bool(N_K_III),
            'L_III_1': bool(N_L_III_1),
            'L_III_2': bool(N_L_III_2),
            'L_III_3': bool(N_L_III_3),
            'F_III': bool(N_F_III),
            'U_III': bool(N_U_III),
            'P_III': bool(N_P_III),
            'D_III': bool(N_D_III),
            'K_SC': bool(N_K_SC),
            'L_SC_2': bool(N_L_SC_2),
            'F_SC': bool(N_F_SC),
            'U_SC': bool(N_U_SC),
            'P_SC': bool(N_P_SC),
            'D_SC': bool(N_D_SC),
        }
        CN_P1 = self.state['CN_P1']
        CR_P1 = self.state['CR_P1']
        AL_P1 = self.state['AL_P1']
        TH_P1 = self.state['TH_P1']
        TR_P1 = self.state['TR_P1']
        A_R1 = self.state['A_R1']
        B_R1 = self.state['B_R1']
        W_R1 = self.state['W_R1']
        S_R1 = self.state['S_R1']
        H_R1 = self.state['H_R1']
        A_R2 = self.state['A_R2']
        B_R2 = self.state['B_R2']
        W_R2 = self.state['W_R2']
        S_R2 = self.state['S_R2']
        H_R2 = self.state['H_R2']
        A_R3 = self.state['A_R3']
        B_R3 = self.state['B_R3']
        W_R3 = self.state['W_R3']
        S_R3 = self.state['S_R3']
        H_R3 = self.state['H_R3']
        A_R4 = self.state['A_R4']
        B_R4 = self.state['B_R4']
        W_R4 = self.state['W_R4']
        S_R4 = self.state['S_R4']
        H_R4 = self.state['H_R4']
        X_X3 = self.state['X_X3']
        X_X4 = self.state['X_X4']
        X_X5 = self.state['X_X5']
        K_III = self.state['K_III']
        L_III_1 = self.state['L_III_1']
        L_III_2 = self.state['L_III_2']
        L_III_3 = self.state['L_III_3']
        F_III = self.state['F_III']
        U_III = self.state['U_III']
        P_III = self.state['P_III']
        D_III = self.state['D_III']
        K_SC = self.state['K_SC']
        L_SC_2 = self.state['L_SC_2']
        F_SC = self.state['F_SC']
        U_SC = self.state['U_SC']
        P_SC = self.state['P_SC']
        D_SC = self.state['D_SC']
        return {
            'YN_P1': bool(CN_P1),
            'YR_P1': bool(CR_P1),
            'YA_P1': bool(AL_P1),
            'YT_P1': bool(TR_P1),
            'YL_III': bool(K_III or L_III_1 or L_III_2 or L_III_3),
            'YL_SC': bool(K_SC or L_SC_2),
            'YP_X3': bool(S_R1 or S_R2),
            'YS_X3': bool((not (S_R1 or S_R2))),
            'YP_X4': bool(S_R3),
            'YS_X4': bool((not S_R3)),
            'YP_X5': bool(S_R4),
            'YS_X5': bool((not S_R4)),
        }
