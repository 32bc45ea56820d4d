# Interlocking fig2_2, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout f3d8c7d39b17f0679e55956ff692795c76659650750b638a67408f2f8a1eb4eb
# claims 28fb77ba28fdf5760cc8dd55509bdbb56a16c50d3c1a2d1490233ff24a1a3c04
"""Interlocking fig2_2: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_X1': (0, 2),  # operator: cancel the route from X1
    'CAN_X2': (0, 2),  # operator: cancel the route from X2
    'CAN_X3': (0, 2),  # operator: cancel the route from X3
    'REQ': (0, 5),  # operator: set route number, 0 = none
    'LREQ': (0, 5),  # operator on the spot: set route number, 0 = none
    'CLR_DP': (0, 2),  # section DP reported clear
    'CLR_SA': (0, 2),  # section SA reported clear
    'CLR_SB': (0, 2),  # section SB reported clear
    'CLR_SC': (0, 2),  # section SC reported clear
    'REL_DP': (0, 2),  # operator: release section DP (hold until released)
    'BLK_DP': (1, 2),  # operator: section DP is blocked
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
    'A_R1': False,  # route X1-A active
    'B_R1': False,  # route X1-A locked
    'W_R1': False,  # route X1-A: proceed wanted
    'S_R1': False,  # route X1-A: proceed
    'H_R1': False,  # route X1-A: signal has been open
    'A_R2': False,  # route X1-B active
    'B_R2': False,  # route X1-B locked
    'W_R2': False,  # route X1-B: proceed wanted
    'S_R2': False,  # route X1-B: proceed
    'H_R2': False,  # route X1-B: signal has been open
    'A_R3': False,  # route X2-C active
    'B_R3': False,  # route X2-C locked
    'W_R3': False,  # route X2-C: proceed wanted
    'S_R3': False,  # route X2-C: proceed
    'H_R3': False,  # route X2-C: signal has been open
    'A_R4': False,  # route X3-C active
    'B_R4': False,  # route X3-C locked
    'W_R4': False,  # route X3-C: proceed wanted
    'S_R4': False,  # route X3-C: proceed
    'H_R4': False,  # route X3-C: signal has been open
    'X_X1': False,  # X1: cancelling
    'X_X2': False,  # X2: cancelling
    'X_X3': False,  # X3: cancelling
    'K_DP': True,  # DP: restart lock (R16)
    'L_DP_1': False,  # DP locked from A to C
    'L_DP_2': False,  # DP locked from B to C
    'L_DP_3': False,  # DP locked from C to A
    'L_DP_4': False,  # DP locked from C to B
    'F_DP': False,  # DP firmly locked
    'U_DP': True,  # DP used by a train (R9)
    'P_DP': False,  # DP: the train went on (R9)
    'D_DP': False,  # DP: detection is not relied on, inputs were lost or a train is called on
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_X1': 60000,  # X1: approach locking delay (R8)
    'AT_X2': 60000,  # X2: approach locking delay (R8)
    'AT_X3': 60000,  # X3: approach locking delay (R8)
    'RT_DP': 3000,  # DP: release delay (R9)
    'ST_P1': 13000,  # machine P1: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_P1': False,  # machine P1: normal
    'YR_P1': False,  # machine P1: reverse
    'YA_P1': False,  # alarm: machine P1 not detected in time
    'YT_P1': False,  # alarm: machine P1 was trailed
    'YL_DP': True,  # indication: DP is locked
    'YP_X1': False,  # signal X1: clear (green)
    'YS_X1': True,  # signal X1: stop
    'YP_X2': False,  # signal X2: clear (green)
    'YS_X2': True,  # signal X2: stop
    'YP_X3': False,  # signal X3: clear (green)
    'YS_X3': True,  # signal X3: stop
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
        CAN_X1 = read['CAN_X1']
        CAN_X2 = read['CAN_X2']
        CAN_X3 = read['CAN_X3']
        REQ = read['REQ']
        LREQ = read['LREQ']
        CLR_DP = read['CLR_DP']
        CLR_SA = read['CLR_SA']
        CLR_SB = read['CLR_SB']
        CLR_SC = read['CLR_SC']
        REL_DP = read['REL_DP']
        BLK_DP = read['BLK_DP']
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
        X_X1 = old['X_X1']
        X_X2 = old['X_X2']
        X_X3 = old['X_X3']
        K_DP = old['K_DP']
        L_DP_1 = old['L_DP_1']
        L_DP_2 = old['L_DP_2']
        L_DP_3 = old['L_DP_3']
        L_DP_4 = old['L_DP_4']
        F_DP = old['F_DP']
        U_DP = old['U_DP']
        P_DP = old['P_DP']
        D_DP = old['D_DP']
        OCC_DP = (not CLR_DP) or (not VALID)  # DP counts as occupied
        OCC_SA = (not CLR_SA) or (not VALID)  # SA counts as occupied
        OCC_SB = (not CLR_SB) or (not VALID)  # SB counts as occupied
        OCC_SC = (not CLR_SC) or (not VALID)  # SC counts as occupied
        FREE_DP = (not K_DP) and (not L_DP_1) and (not L_DP_2) and (not L_DP_3) and (not L_DP_4)  # DP is not locked by anybody
        QN_P1 = VALID and DN_P1 and (not DR_P1)  # machine P1 lies N (R10)
        QR_P1 = VALID and DR_P1 and (not DN_P1)  # machine P1 lies R (R10)
        MOV_P1 = VALID and FREE_DP and (not OCC_DP) and True and True  # machine P1 is free to move (R10)
        AVN_P1 = CN_P1 or MOV_P1 or (QN_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded N
        AVR_P1 = CR_P1 or MOV_P1 or (QR_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded R
        WA_DP_1 = AVN_P1 and (not TR_P1)  # DP from A to C: could be locked
        WF_DP_1 = FREE_DP and (not OCC_DP) and (not BLK_DP) and WA_DP_1  # DP from A to C: free for a route (R6)
        WA_DP_2 = AVR_P1 and (not TR_P1)  # DP from B to C: could be locked
        WF_DP_2 = FREE_DP and (not OCC_DP) and (not BLK_DP) and WA_DP_2  # DP from B to C: free for a route (R6)
        WA_DP_3 = AVN_P1 and (not TR_P1)  # DP from C to A: could be locked
        WF_DP_3 = FREE_DP and (not OCC_DP) and (not BLK_DP) and WA_DP_3  # DP from C to A: free for a route (R6)
        WA_DP_4 = AVR_P1 and (not TR_P1)  # DP from C to B: could be locked
        WF_DP_4 = FREE_DP and (not OCC_DP) and (not BLK_DP) and WA_DP_4  # DP from C to B: free for a route (R6)
        WD_DP_1 = QN_P1 and (not TR_P1)  # DP from A to C: its points lie, nothing is foul of it
        WL_DP_1 = (not OCC_DP) and WD_DP_1  # DP from A to C: lies and is clear
        WP_DP_1 = WL_DP_1 and (not BLK_DP)  # DP from A to C: proceed may be shown over it (R3)
        WD_DP_2 = QR_P1 and (not TR_P1)  # DP from B to C: its points lie, nothing is foul of it
        WL_DP_2 = (not OCC_DP) and WD_DP_2  # DP from B to C: lies and is clear
        WP_DP_2 = WL_DP_2 and (not BLK_DP)  # DP from B to C: proceed may be shown over it (R3)
        WD_DP_3 = QN_P1 and (not TR_P1)  # DP from C to A: its points lie, nothing is foul of it
        WL_DP_3 = (not OCC_DP) and WD_DP_3  # DP from C to A: lies and is clear
        WP_DP_3 = WL_DP_3 and (not BLK_DP)  # DP from C to A: proceed may be shown over it (R3)
        WD_DP_4 = QR_P1 and (not TR_P1)  # DP from C to B: its points lie, nothing is foul of it
        WL_DP_4 = (not OCC_DP) and WD_DP_4  # DP from C to B: lies and is clear
        WP_DP_4 = WL_DP_4 and (not BLK_DP)  # DP from C to B: proceed may be shown over it (R3)
        G_R1 = ((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and VALID and WF_DP_3  # grant of route X1-A (R6)
        G_R2 = ((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) and VALID and WF_DP_4  # grant of route X1-B (R6)
        G_R3 = ((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and VALID and WF_DP_1  # grant of route X2-C (R6)
        G_R4 = ((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and VALID and WF_DP_2  # grant of route X3-C (R6)
        GW_DP_1 = G_R3  # DP from A to C: granted
        GW_DP_2 = G_R4  # DP from B to C: granted
        GW_DP_3 = G_R1  # DP from C to A: granted
        GW_DP_4 = G_R2  # DP from C to B: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_X1) and (not CAN_X1) and WL_DP_3  # route X1-A becomes locked (R3)
        CO_R1 = VALID and WP_DP_3 and (not OCC_SA) and (not D_DP)  # conditions of proceed for route X1-A (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_X1) and (not CAN_X1) and WL_DP_4  # route X1-B becomes locked (R3)
        CO_R2 = VALID and WP_DP_4 and (not OCC_SB) and (not D_DP)  # conditions of proceed for route X1-B (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_X2) and (not CAN_X2) and WL_DP_1  # route X2-C becomes locked (R3)
        CO_R3 = VALID and WP_DP_1 and (not OCC_SC) and (not D_DP)  # conditions of proceed for route X2-C (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_X3) and (not CAN_X3) and WL_DP_2  # route X3-C becomes locked (R3)
        CO_R4 = VALID and WP_DP_2 and (not OCC_SC) and (not D_DP)  # conditions of proceed for route X3-C (R3)
        NU_DP_1 = VALID and F_DP and (not D_DP) and (not U_DP) and L_DP_1 and OCC_DP and OCC_SA  # a train comes into DP at A (R9)
        NU_DP_2 = VALID and F_DP and (not D_DP) and (not U_DP) and L_DP_2 and OCC_DP and OCC_SB  # a train comes into DP at B (R9)
        NU_DP_3 = VALID and F_DP and (not D_DP) and (not U_DP) and (L_DP_3 or L_DP_4) and OCC_DP and OCC_SC  # a train comes into DP at C (R9)
        ATI_X1 = X_X1 or ((not (A_R1 or A_R2)) and (L_DP_3 or L_DP_4) and (REL_DP or ((L_DP_3 or L_DP_4) and U_DP and (not OCC_DP))))  # X1 at stop, waiting for a train that may still come (R8)
        ATI_X2 = X_X2 or ((not A_R3) and L_DP_1 and (REL_DP or (L_DP_1 and U_DP and (not OCC_DP))))  # X2 at stop, waiting for a train that may still come (R8)
        ATI_X3 = X_X3 or ((not A_R4) and L_DP_2 and (REL_DP or (L_DP_2 and U_DP and (not OCC_DP))))  # X3 at stop, waiting for a train that may still come (R8)
        AT_X1 = self._timer('AT_X1', ATI_X1, dt_ms)  # X1: approach locking delay (R8)
        AT_X2 = self._timer('AT_X2', ATI_X2, dt_ms)  # X2: approach locking delay (R8)
        AT_X3 = self._timer('AT_X3', ATI_X3, dt_ms)  # X3: approach locking delay (R8)
        CD_X1 = X_X1 and (A_R1 or A_R2) and VALID and (not OCC_DP) and ((not OCC_SC) or AT_X1 or (not (H_R1 or H_R2)))  # the route from X1 is cancelled (R8)
        CD_X2 = X_X2 and A_R3 and VALID and (not OCC_DP) and ((not OCC_SA) or AT_X2 or (not H_R3))  # the route from X2 is cancelled (R8)
        CD_X3 = X_X3 and A_R4 and VALID and (not OCC_DP) and ((not OCC_SB) or AT_X3 or (not H_R4))  # the route from X3 is cancelled (R8)
        EX_DP = P_DP or (L_DP_1 and ((not OCC_SA) or AT_X2)) or (L_DP_2 and ((not OCC_SB) or AT_X3)) or ((L_DP_3 or L_DP_4) and ((not OCC_SC) or AT_X1))  # a train in DP leaves over a boundary, or has passed on
        RTI_DP = VALID and U_DP and (not OCC_DP) and EX_DP  # DP may be released behind the train (R9)
        RT_DP = self._timer('RT_DP', RTI_DP, dt_ms)  # DP: release delay (R9)
        CA_DP = VALID and (not OCC_DP) and (not U_DP) and False  # the lock before DP was withdrawn (R8)
        HR_DP = VALID and (not OCC_DP) and REL_DP and (L_DP_1 or L_DP_2 or L_DP_3 or L_DP_4) and ((not L_DP_1) or ((not A_R3) and ((not OCC_SA) or AT_X2))) and ((not L_DP_2) or ((not A_R4) and ((not OCC_SB) or AT_X3))) and ((not (L_DP_3 or L_DP_4)) or ((not (A_R1 or A_R2)) and ((not OCC_SC) or AT_X1)))  # DP released by hand (R8, section fault release)
        SR_DP = VALID and (not OCC_DP) and K_DP and (REL_DP or RELALL)  # DP released after a restart (R16)
        RLS_DP = RT_DP or CA_DP or CD_X2 or CD_X3 or CD_X1 or HR_DP or SR_DP  # DP is released
        TG_P1 = (GW_DP_1 or GW_DP_2 or GW_DP_3 or GW_DP_4)  # a grant touches machine P1 in this scan
        GPN_P1 = (GW_DP_1 or GW_DP_3)  # a grant needs P1 N
        MAN_P1 = MN_P1 and (not MR_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved N by hand
        GPR_P1 = (GW_DP_2 or GW_DP_4)  # a grant needs P1 R
        MAR_P1 = MR_P1 and (not MN_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved R by hand
        HDN_P1 = CN_P1 and (not GPR_P1) and (not MAR_P1)  # the command N stays
        HDR_P1 = CR_P1 and (not GPN_P1) and (not MAN_P1)  # the command R stays
        STI_P1 = (CN_P1 and (not QN_P1)) or (CR_P1 and (not QR_P1))  # machine P1 is not where it was commanded
        ST_P1 = self._timer('ST_P1', STI_P1, dt_ms)  # machine P1: time-out
        KP_R1 = (not NU_DP_3) and (not CD_X1)  # route X1-A stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_X1) and (not CAN_X1)  # proceed for route X1-A (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route X1-A: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_DP_3) and (not CD_X1)  # route X1-B stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_X1) and (not CAN_X1)  # proceed for route X1-B (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route X1-B: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_DP_1) and (not CD_X2)  # route X2-C stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_X2) and (not CAN_X2)  # proceed for route X2-C (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route X2-C: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_DP_2) and (not CD_X3)  # route X3-C stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_X3) and (not CAN_X3)  # proceed for route X3-C (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route X3-C: a condition was lost; no reopening by itself (R14)
        N_CN_P1 = GPN_P1 or MAN_P1 or HDN_P1  # machine P1 commanded N
        N_CR_P1 = GPR_P1 or MAR_P1 or HDR_P1  # machine P1 commanded R
        N_AL_P1 = ST_P1  # alarm: machine P1 not detected
        N_TH_P1 = ((CN_P1 and QN_P1) or (CR_P1 and QR_P1)) and (not (GPN_P1 or GPR_P1 or MAN_P1 or MAR_P1))  # machine P1 was detected where it is commanded
        N_TR_P1 = (TH_P1 and VALID and ((CN_P1 and (not QN_P1) and (not GPR_P1) and (not MAR_P1)) or (CR_P1 and (not QR_P1) and (not GPN_P1) and (not MAN_P1)))) or (TR_P1 and (not (TC_P1 and VALID and (not OCC_DP))))  # machine P1 was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route X1-A active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route X1-A locked
        N_W_R1 = (W_R1 or LK_R1 or (((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and B_R1)) and (not LS_R1) and KP_R1 and (not X_X1) and (not CAN_X1)  # route X1-A: proceed wanted
        N_S_R1 = PR_R1  # route X1-A: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route X1-A: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route X1-B active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route X1-B locked
        N_W_R2 = (W_R2 or LK_R2 or (((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) and B_R2)) and (not LS_R2) and KP_R2 and (not X_X1) and (not CAN_X1)  # route X1-B: proceed wanted
        N_S_R2 = PR_R2  # route X1-B: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route X1-B: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route X2-C active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route X2-C locked
        N_W_R3 = (W_R3 or LK_R3 or (((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and B_R3)) and (not LS_R3) and KP_R3 and (not X_X2) and (not CAN_X2)  # route X2-C: proceed wanted
        N_S_R3 = PR_R3  # route X2-C: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route X2-C: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route X3-C active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route X3-C locked
        N_W_R4 = (W_R4 or LK_R4 or (((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and B_R4)) and (not LS_R4) and KP_R4 and (not X_X3) and (not CAN_X3)  # route X3-C: proceed wanted
        N_S_R4 = PR_R4  # route X3-C: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route X3-C: signal has been open
        N_X_X1 = (X_X1 or CAN_X1) and (A_R1 or A_R2) and (not CD_X1)  # X1: cancelling
        N_X_X2 = (X_X2 or CAN_X2) and A_R3 and (not CD_X2)  # X2: cancelling
        N_X_X3 = (X_X3 or CAN_X3) and A_R4 and (not CD_X3)  # X3: cancelling
        N_K_DP = K_DP and (not RLS_DP)  # DP: restart lock (R16)
        N_L_DP_1 = (L_DP_1 or GW_DP_1) and (not RLS_DP)  # DP locked from A to C
        N_L_DP_2 = (L_DP_2 or GW_DP_2) and (not RLS_DP)  # DP locked from B to C
        N_L_DP_3 = (L_DP_3 or GW_DP_3) and (not RLS_DP)  # DP locked from C to A
        N_L_DP_4 = (L_DP_4 or GW_DP_4) and (not RLS_DP)  # DP locked from C to B
        N_F_DP = (F_DP or LK_R3 or LK_R4 or LK_R1 or LK_R2) and (not RLS_DP)  # DP firmly locked
        N_U_DP = (U_DP or NU_DP_1 or NU_DP_2 or NU_DP_3) and (not RLS_DP)  # DP used by a train (R9)
        N_P_DP = P_DP and (not RLS_DP)  # DP: the train went on (R9)
        N_D_DP = (D_DP or ((not VALID) and (L_DP_1 or L_DP_2 or L_DP_3 or L_DP_4))) and (not RLS_DP)  # DP: detection is not relied on, inputs were lost or a train is called on
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
            'X_X1': bool(N_X_X1),
            'X_X2': bool(N_X_X2),
            'X_X3': bool(N_X_X3),
            'K_DP': bool(N_K_DP),
            'L_DP_1': bool(N_L_DP_1),
            'L_DP_2': bool(N_L_DP_2),
            'L_DP_3': bool(N_L_DP_3),
            'L_DP_4': bool(N_L_DP_4),
            'F_DP': bool(N_F_DP),
            'U_DP': bool(N_U_DP),
            'P_DP': bool(N_P_DP),
            'D_DP': bool(N_D_DP),
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
        X_X1 = self.state['X_X1']
        X_X2 = self.state['X_X2']
        X_X3 = self.state['X_X3']
        K_DP = self.state['K_DP']
        L_DP_1 = self.state['L_DP_1']
        L_DP_2 = self.state['L_DP_2']
        L_DP_3 = self.state['L_DP_3']
        L_DP_4 = self.state['L_DP_4']
        F_DP = self.state['F_DP']
        U_DP = self.state['U_DP']
        P_DP = self.state['P_DP']
        D_DP = self.state['D_DP']
        return {
            'YN_P1': bool(CN_P1),
            'YR_P1': bool(CR_P1),
            'YA_P1': bool(AL_P1),
            'YT_P1': bool(TR_P1),
            'YL_DP': bool(K_DP or L_DP_1 or L_DP_2 or L_DP_3 or L_DP_4),
            'YP_X1': bool(S_R1 or S_R2),
            'YS_X1': bool((not (S_R1 or S_R2))),
            'YP_X2': bool(S_R3),
            'YS_X2': bool((not S_R3)),
            'YP_X3': bool(S_R4),
            'YS_X3': bool((not S_R4)),
        }
