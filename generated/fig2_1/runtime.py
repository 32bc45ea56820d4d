# Interlocking fig2_1, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout 1e28934bbc05ce7fcb81fed9aff74b1ed683d179bf097f6bba082f636e68cb9b
# claims a835369bc458d9f2579f08809d2119a6b37d99611a483bf57ce9b41356d77df6
"""Interlocking fig2_1: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_SC': (0, 2),  # operator: cancel the route from SC
    'CAN_SD': (0, 2),  # operator: cancel the route from SD
    'CAN_SE': (0, 2),  # operator: cancel the route from SE
    'CAN_SF': (0, 2),  # operator: cancel the route from SF
    'CAN_SG': (0, 2),  # operator: cancel the route from SG
    'CAN_SI': (0, 2),  # operator: cancel the route from SI
    'CAN_SIII': (0, 2),  # operator: cancel the route from SIII
    'CAN_SV': (0, 2),  # operator: cancel the route from SV
    'REQ': (0, 11),  # operator: set route number, 0 = none
    'LREQ': (0, 11),  # operator on the spot: set route number, 0 = none
    'VOY': (0, 3),  # operator: voyage number, 0 = none
    'CLR_A': (0, 2),  # section A reported clear
    'CLR_B': (0, 2),  # section B reported clear
    'CLR_C': (0, 2),  # section C reported clear
    'CLR_D': (0, 2),  # section D reported clear
    'CLR_E': (0, 2),  # section E reported clear
    'CLR_F': (0, 2),  # section F reported clear
    'CLR_G': (0, 2),  # section G reported clear
    'CLR_H': (0, 2),  # section H reported clear
    'CLR_ap_I': (0, 2),  # section ap_I reported clear
    'CLR_ap_II': (0, 2),  # section ap_II reported clear
    'CLR_ap_III': (0, 2),  # section ap_III reported clear
    'CLR_ap_IV': (0, 2),  # section ap_IV reported clear
    'REL_A': (0, 2),  # operator: release section A (hold until released)
    'REL_B': (0, 2),  # operator: release section B (hold until released)
    'REL_C': (0, 2),  # operator: release section C (hold until released)
    'REL_D': (0, 2),  # operator: release section D (hold until released)
    'REL_E': (0, 2),  # operator: release section E (hold until released)
    'REL_F': (0, 2),  # operator: release section F (hold until released)
    'REL_G': (0, 2),  # operator: release section G (hold until released)
    'REL_H': (0, 2),  # operator: release section H (hold until released)
    'REL_ap_II': (0, 2),  # operator: release section ap_II (hold until released)
    'REL_ap_IV': (0, 2),  # operator: release section ap_IV (hold until released)
    'BLK_A': (1, 2),  # operator: section A is blocked
    'BLK_B': (1, 2),  # operator: section B is blocked
    'BLK_C': (1, 2),  # operator: section C is blocked
    'BLK_D': (1, 2),  # operator: section D is blocked
    'BLK_E': (1, 2),  # operator: section E is blocked
    'BLK_F': (1, 2),  # operator: section F is blocked
    'BLK_G': (1, 2),  # operator: section G is blocked
    'BLK_H': (1, 2),  # operator: section H is blocked
    'BLK_ap_II': (1, 2),  # operator: section ap_II is blocked
    'BLK_ap_IV': (1, 2),  # operator: section ap_IV is blocked
    'RELALL': (0, 2),  # operator: release all clear sections after a restart
    'DN_PB': (0, 2),  # machine PB detected normal
    'DR_PB': (0, 2),  # machine PB detected reverse
    'MN_PB': (0, 2),  # operator: move machine PB normal
    'MR_PB': (0, 2),  # operator: move machine PB reverse
    'TC_PB': (0, 2),  # operator: machine PB has been looked at after it was trailed
    'DN_PE': (0, 2),  # machine PE detected normal
    'DR_PE': (0, 2),  # machine PE detected reverse
    'MN_PE': (0, 2),  # operator: move machine PE normal
    'MR_PE': (0, 2),  # operator: move machine PE reverse
    'TC_PE': (0, 2),  # operator: machine PE has been looked at after it was trailed
}
# name: value at a restart, meaning
STATE = {
    'CN_PB': False,  # machine PB commanded N
    'CR_PB': False,  # machine PB commanded R
    'CN_PE': False,  # machine PE commanded N
    'CR_PE': False,  # machine PE commanded R
    'AL_PB': False,  # alarm: machine PB not detected
    'AL_PE': False,  # alarm: machine PE not detected
    'TH_PB': False,  # machine PB was detected where it is commanded
    'TR_PB': False,  # machine PB was trailed
    'TH_PE': False,  # machine PE was detected where it is commanded
    'TR_PE': False,  # machine PE was trailed
    'A_R1': False,  # route SC-III active
    'B_R1': False,  # route SC-III locked
    'W_R1': False,  # route SC-III: proceed wanted
    'S_R1': False,  # route SC-III: proceed
    'H_R1': False,  # route SC-III: signal has been open
    'A_R2': False,  # route SC-SF active
    'B_R2': False,  # route SC-SF locked
    'W_R2': False,  # route SC-SF: proceed wanted
    'S_R2': False,  # route SC-SF: proceed
    'H_R2': False,  # route SC-SF: signal has been open
    'A_R3': False,  # route SD-I active
    'B_R3': False,  # route SD-I locked
    'W_R3': False,  # route SD-I: proceed wanted
    'S_R3': False,  # route SD-I: proceed
    'H_R3': False,  # route SD-I: signal has been open
    'A_R4': False,  # route SD-SG active
    'B_R4': False,  # route SD-SG locked
    'W_R4': False,  # route SD-SG: proceed wanted
    'S_R4': False,  # route SD-SG: proceed
    'H_R4': False,  # route SD-SG: signal has been open
    'A_R5': False,  # route SE-SD active
    'B_R5': False,  # route SE-SD locked
    'W_R5': False,  # route SE-SD: proceed wanted
    'S_R5': False,  # route SE-SD: proceed
    'H_R5': False,  # route SE-SD: signal has been open
    'A_R6': False,  # route SF-II active
    'B_R6': False,  # route SF-II locked
    'W_R6': False,  # route SF-II: proceed wanted
    'S_R6': False,  # route SF-II: proceed
    'H_R6': False,  # route SF-II: signal has been open
    'A_R7': False,  # route SG-IV active
    'B_R7': False,  # route SG-IV locked
    'W_R7': False,  # route SG-IV: proceed wanted
    'S_R7': False,  # route SG-IV: proceed
    'H_R7': False,  # route SG-IV: signal has been open
    'A_R8': False,  # route SI-SV active
    'B_R8': False,  # route SI-SV locked
    'W_R8': False,  # route SI-SV: proceed wanted
    'S_R8': False,  # route SI-SV: proceed
    'H_R8': False,  # route SI-SV: signal has been open
    'A_R9': False,  # route SIII-SE active
    'B_R9': False,  # route SIII-SE locked
    'W_R9': False,  # route SIII-SE: proceed wanted
    'S_R9': False,  # route SIII-SE: proceed
    'H_R9': False,  # route SIII-SE: signal has been open
    'A_R10': False,  # route SV-SC active
    'B_R10': False,  # route SV-SC locked
    'W_R10': False,  # route SV-SC: proceed wanted
    'S_R10': False,  # route SV-SC: proceed
    'H_R10': False,  # route SV-SC: signal has been open
    'X_SC': False,  # SC: cancelling
    'X_SD': False,  # SD: cancelling
    'X_SE': False,  # SE: cancelling
    'X_SF': False,  # SF: cancelling
    'X_SG': False,  # SG: cancelling
    'X_SI': False,  # SI: cancelling
    'X_SIII': False,  # SIII: cancelling
    'X_SV': False,  # SV: cancelling
    'N_R2': False,  # route SC-SF is noted
    'T_R2': True,  # it is the turn of route SC-SF
    'N_R4': False,  # route SD-SG is noted
    'T_R4': False,  # it is the turn of route SD-SG
    'N_R5': False,  # route SE-SD is noted
    'T_R5': False,  # it is the turn of route SE-SD
    'N_R6': False,  # route SF-II is noted
    'T_R6': False,  # it is the turn of route SF-II
    'N_R7': False,  # route SG-IV is noted
    'T_R7': False,  # it is the turn of route SG-IV
    'N_R8': False,  # route SI-SV is noted
    'T_R8': False,  # it is the turn of route SI-SV
    'N_R9': False,  # route SIII-SE is noted
    'T_R9': False,  # it is the turn of route SIII-SE
    'N_R10': False,  # route SV-SC is noted
    'T_R10': False,  # it is the turn of route SV-SC
    'K_A': True,  # A: restart lock (R16)
    'L_A_1': False,  # A locked from A|B@PB.normal to I
    'L_A_2': False,  # A locked from I to A|B@PB.normal
    'F_A': False,  # A firmly locked
    'U_A': True,  # A used by a train (R9)
    'P_A': False,  # A: the train went on (R9)
    'D_A': False,  # A: detection is not relied on, inputs were lost or a train is called on
    'K_B': True,  # B: restart lock (R16)
    'L_B_1': False,  # B locked from A|B@PB.normal to B|C@PB.toe
    'L_B_2': False,  # B locked from B|C@PB.toe to A|B@PB.normal
    'L_B_3': False,  # B locked from B|C@PB.toe to B|G@PB.reverse
    'F_B': False,  # B firmly locked
    'U_B': True,  # B used by a train (R9)
    'P_B': False,  # B: the train went on (R9)
    'D_B': False,  # B: detection is not relied on, inputs were lost or a train is called on
    'K_C': True,  # C: restart lock (R16)
    'L_C_1': False,  # C locked from B|C@PB.toe to C|D@line.0
    'L_C_2': False,  # C locked from C|D@line.0 to B|C@PB.toe
    'F_C': False,  # C firmly locked
    'U_C': True,  # C used by a train (R9)
    'P_C': False,  # C: the train went on (R9)
    'D_C': False,  # C: detection is not relied on, inputs were lost or a train is called on
    'K_D': True,  # D: restart lock (R16)
    'L_D_1': False,  # D locked from C|D@line.0 to D|E@PE.toe
    'L_D_2': False,  # D locked from D|E@PE.toe to C|D@line.0
    'F_D': False,  # D firmly locked
    'U_D': True,  # D used by a train (R9)
    'P_D': False,  # D: the train went on (R9)
    'D_D': False,  # D: detection is not relied on, inputs were lost or a train is called on
    'K_E': True,  # E: restart lock (R16)
    'L_E_1': False,  # E locked from D|E@PE.toe to E|F@PE.normal
    'L_E_2': False,  # E locked from D|E@PE.toe to E|H@PE.reverse
    'L_E_4': False,  # E locked from E|H@PE.reverse to D|E@PE.toe
    'F_E': False,  # E firmly locked
    'U_E': True,  # E used by a train (R9)
    'P_E': False,  # E: the train went on (R9)
    'D_E': False,  # E: detection is not relied on, inputs were lost or a train is called on
    'K_F': True,  # F: restart lock (R16)
    'L_F_1': False,  # F locked from E|F@PE.normal to F|ap_II@two.0
    'F_F': False,  # F firmly locked
    'U_F': True,  # F used by a train (R9)
    'P_F': False,  # F: the train went on (R9)
    'D_F': False,  # F: detection is not relied on, inputs were lost or a train is called on
    'K_G': True,  # G: restart lock (R16)
    'L_G_1': False,  # G locked from B|G@PB.reverse to G|ap_IV@four.0
    'F_G': False,  # G firmly locked
    'U_G': True,  # G used by a train (R9)
    'P_G': False,  # G: the train went on (R9)
    'D_G': False,  # G: detection is not relied on, inputs were lost or a train is called on
    'K_H': True,  # H: restart lock (R16)
    'L_H_1': False,  # H locked from E|H@PE.reverse to III
    'L_H_2': False,  # H locked from III to E|H@PE.reverse
    'F_H': False,  # H firmly locked
    'U_H': True,  # H used by a train (R9)
    'P_H': False,  # H: the train went on (R9)
    'D_H': False,  # H: detection is not relied on, inputs were lost or a train is called on
    'K_ap_II': True,  # ap_II: restart lock (R16)
    'L_ap_II_1': False,  # ap_II locked from F|ap_II@two.0 to II
    'F_ap_II': False,  # ap_II firmly locked
    'U_ap_II': True,  # ap_II used by a train (R9)
    'P_ap_II': False,  # ap_II: the train went on (R9)
    'D_ap_II': False,  # ap_II: detection is not relied on, inputs were lost or a train is called on
    'K_ap_IV': True,  # ap_IV: restart lock (R16)
    'L_ap_IV_1': False,  # ap_IV locked from G|ap_IV@four.0 to IV
    'F_ap_IV': False,  # ap_IV firmly locked
    'U_ap_IV': True,  # ap_IV used by a train (R9)
    'P_ap_IV': False,  # ap_IV: the train went on (R9)
    'D_ap_IV': False,  # ap_IV: detection is not relied on, inputs were lost or a train is called on
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_SC': 60000,  # SC: approach locking delay (R8)
    'AT_SD': 60000,  # SD: approach locking delay (R8)
    'AT_SE': 60000,  # SE: approach locking delay (R8)
    'AT_SF': 60000,  # SF: approach locking delay (R8)
    'AT_SG': 60000,  # SG: approach locking delay (R8)
    'AT_SI': 60000,  # SI: approach locking delay (R8)
    'AT_SIII': 60000,  # SIII: approach locking delay (R8)
    'AT_SV': 60000,  # SV: approach locking delay (R8)
    'RT_A': 3000,  # A: release delay (R9)
    'RT_B': 3000,  # B: release delay (R9)
    'RT_C': 3000,  # C: release delay (R9)
    'RT_D': 3000,  # D: release delay (R9)
    'RT_E': 3000,  # E: release delay (R9)
    'RT_F': 3000,  # F: release delay (R9)
    'RT_G': 3000,  # G: release delay (R9)
    'RT_H': 3000,  # H: release delay (R9)
    'RT_ap_II': 3000,  # ap_II: release delay (R9)
    'RT_ap_IV': 3000,  # ap_IV: release delay (R9)
    'ST_PB': 13000,  # machine PB: time-out
    'ST_PE': 13000,  # machine PE: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_PB': False,  # machine PB: normal
    'YR_PB': False,  # machine PB: reverse
    'YN_PE': False,  # machine PE: normal
    'YR_PE': False,  # machine PE: reverse
    'YA_PB': False,  # alarm: machine PB not detected in time
    'YA_PE': False,  # alarm: machine PE not detected in time
    'YT_PB': False,  # alarm: machine PB was trailed
    'YT_PE': False,  # alarm: machine PE was trailed
    'YL_A': True,  # indication: A is locked
    'YL_B': True,  # indication: B is locked
    'YL_C': True,  # indication: C is locked
    'YL_D': True,  # indication: D is locked
    'YL_E': True,  # indication: E is locked
    'YL_F': True,  # indication: F is locked
    'YL_G': True,  # indication: G is locked
    'YL_H': True,  # indication: H is locked
    'YL_ap_II': True,  # indication: ap_II is locked
    'YL_ap_IV': True,  # indication: ap_IV is locked
    'YP_SC': False,  # signal SC: clear (green)
    'YS_SC': True,  # signal SC: stop
    'YP_SD': False,  # signal SD: clear (green)
    'YS_SD': True,  # signal SD: stop
    'YP_SE': False,  # signal SE: clear (green)
    'YS_SE': True,  # signal SE: stop
    'YP_SF': False,  # signal SF: clear (green)
    'YS_SF': True,  # signal SF: stop
    'YP_SG': False,  # signal SG: clear (green)
    'YS_SG': True,  # signal SG: stop
    'YP_SI': False,  # signal SI: clear (green)
    'YS_SI': True,  # signal SI: stop
    'YP_SIII': False,  # signal SIII: clear (green)
    'YS_SIII': True,  # signal SIII: stop
    'YP_SV': False,  # signal SV: clear (green)
    'YS_SV': True,  # signal SV: stop
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
        CAN_SC = read['CAN_SC']
        CAN_SD = read['CAN_SD']
        CAN_SE = read['CAN_SE']
        CAN_SF = read['CAN_SF']
        CAN_SG = read['CAN_SG']
        CAN_SI = read['CAN_SI']
        CAN_SIII = read['CAN_SIII']
        CAN_SV = read['CAN_SV']
        REQ = read['REQ']
        LREQ = read['LREQ']
        VOY = read['VOY']
        CLR_A = read['CLR_A']
        CLR_B = read['CLR_B']
        CLR_C = read['CLR_C']
        CLR_D = read['CLR_D']
        CLR_E = read['CLR_E']
        CLR_F = read['CLR_F']
        CLR_G = read['CLR_G']
        CLR_H = read['CLR_H']
        CLR_ap_I = read['CLR_ap_I']
        CLR_ap_II = read['CLR_ap_II']
        CLR_ap_III = read['CLR_ap_III']
        CLR_ap_IV = read['CLR_ap_IV']
        REL_A = read['REL_A']
        REL_B = read['REL_B']
        REL_C = read['REL_C']
        REL_D = read['REL_D']
        REL_E = read['REL_E']
        REL_F = read['REL_F']
        REL_G = read['REL_G']
        REL_H = read['REL_H']
        REL_ap_II = read['REL_ap_II']
        REL_ap_IV = read['REL_ap_IV']
        BLK_A = read['BLK_A']
        BLK_B = read['BLK_B']
        BLK_C = read['BLK_C']
        BLK_D = read['BLK_D']
        BLK_E = read['BLK_E']
        BLK_F = read['BLK_F']
        BLK_G = read['BLK_G']
        BLK_H = read['BLK_H']
        BLK_ap_II = read['BLK_ap_II']
        BLK_ap_IV = read['BLK_ap_IV']
        RELALL = read['RELALL']
        DN_PB = read['DN_PB']
        DR_PB = read['DR_PB']
        MN_PB = read['MN_PB']
        MR_PB = read['MR_PB']
        TC_PB = read['TC_PB']
        DN_PE = read['DN_PE']
        DR_PE = read['DR_PE']
        MN_PE = read['MN_PE']
        MR_PE = read['MR_PE']
        TC_PE = read['TC_PE']
        CN_PB = old['CN_PB']
        CR_PB = old['CR_PB']
        CN_PE = old['CN_PE']
        CR_PE = old['CR_PE']
        AL_PB = old['AL_PB']
        AL_PE = old['AL_PE']
        TH_PB = old['TH_PB']
        TR_PB = old['TR_PB']
        TH_PE = old['TH_PE']
        TR_PE = old['TR_PE']
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
        A_R5 = old['A_R5']
        B_R5 = old['B_R5']
        W_R5 = old['W_R5']
        S_R5 = old['S_R5']
        H_R5 = old['H_R5']
        A_R6 = old['A_R6']
        B_R6 = old['B_R6']
        W_R6 = old['W_R6']
        S_R6 = old['S_R6']
        H_R6 = old['H_R6']
        A_R7 = old['A_R7']
        B_R7 = old['B_R7']
        W_R7 = old['W_R7']
        S_R7 = old['S_R7']
        H_R7 = old['H_R7']
        A_R8 = old['A_R8']
        B_R8 = old['B_R8']
        W_R8 = old['W_R8']
        S_R8 = old['S_R8']
        H_R8 = old['H_R8']
        A_R9 = old['A_R9']
        B_R9 = old['B_R9']
        W_R9 = old['W_R9']
        S_R9 = old['S_R9']
        H_R9 = old['H_R9']
        A_R10 = old['A_R10']
        B_R10 = old['B_R10']
        W_R10 = old['W_R10']
        S_R10 = old['S_R10']
        H_R10 = old['H_R10']
        X_SC = old['X_SC']
        X_SD = old['X_SD']
        X_SE = old['X_SE']
        X_SF = old['X_SF']
        X_SG = old['X_SG']
        X_SI = old['X_SI']
        X_SIII = old['X_SIII']
        X_SV = old['X_SV']
        N_R2 = old['N_R2']
        T_R2 = old['T_R2']
        N_R4 = old['N_R4']
        T_R4 = old['T_R4']
        N_R5 = old['N_R5']
        T_R5 = old['T_R5']
        N_R6 = old['N_R6']
        T_R6 = old['T_R6']
        N_R7 = old['N_R7']
        T_R7 = old['T_R7']
        N_R8 = old['N_R8']
        T_R8 = old['T_R8']
        N_R9 = old['N_R9']
        T_R9 = old['T_R9']
        N_R10 = old['N_R10']
        T_R10 = old['T_R10']
        K_A = old['K_A']
        L_A_1 = old['L_A_1']
        L_A_2 = old['L_A_2']
        F_A = old['F_A']
        U_A = old['U_A']
        P_A = old['P_A']
        D_A = old['D_A']
        K_B = old['K_B']
        L_B_1 = old['L_B_1']
        L_B_2 = old['L_B_2']
        L_B_3 = old['L_B_3']
        F_B = old['F_B']
        U_B = old['U_B']
        P_B = old['P_B']
        D_B = old['D_B']
        K_C = old['K_C']
        L_C_1 = old['L_C_1']
        L_C_2 = old['L_C_2']
        F_C = old['F_C']
        U_C = old['U_C']
        P_C = old['P_C']
        D_C = old['D_C']
        K_D = old['K_D']
        L_D_1 = old['L_D_1']
        L_D_2 = old['L_D_2']
        F_D = old['F_D']
        U_D = old['U_D']
        P_D = old['P_D']
        D_D = old['D_D']
        K_E = old['K_E']
        L_E_1 = old['L_E_1']
        L_E_2 = old['L_E_2']
        L_E_4 = old['L_E_4']
        F_E = old['F_E']
        U_E = old['U_E']
        P_E = old['P_E']
        D_E = old['D_E']
        K_F = old['K_F']
        L_F_1 = old['L_F_1']
        F_F = old['F_F']
        U_F = old['U_F']
        P_F = old['P_F']
        D_F = old['D_F']
        K_G = old['K_G']
        L_G_1 = old['L_G_1']
        F_G = old['F_G']
        U_G = old['U_G']
        P_G = old['P_G']
        D_G = old['D_G']
        K_H = old['K_H']
        L_H_1 = old['L_H_1']
        L_H_2 = old['L_H_2']
        F_H = old['F_H']
        U_H = old['U_H']
        P_H = old['P_H']
        D_H = old['D_H']
        K_ap_II = old['K_ap_II']
        L_ap_II_1 = old['L_ap_II_1']
        F_ap_II = old['F_ap_II']
        U_ap_II = old['U_ap_II']
        P_ap_II = old['P_ap_II']
        D_ap_II = old['D_ap_II']
        K_ap_IV = old['K_ap_IV']
        L_ap_IV_1 = old['L_ap_IV_1']
        F_ap_IV = old['F_ap_IV']
        U_ap_IV = old['U_ap_IV']
        P_ap_IV = old['P_ap_IV']
        D_ap_IV = old['D_ap_IV']
        OCC_A = (not CLR_A) or (not VALID)  # A counts as occupied
        OCC_B = (not CLR_B) or (not VALID)  # B counts as occupied
        OCC_C = (not CLR_C) or (not VALID)  # C counts as occupied
        OCC_D = (not CLR_D) or (not VALID)  # D counts as occupied
        OCC_E = (not CLR_E) or (not VALID)  # E counts as occupied
        OCC_F = (not CLR_F) or (not VALID)  # F counts as occupied
        OCC_G = (not CLR_G) or (not VALID)  # G counts as occupied
        OCC_H = (not CLR_H) or (not VALID)  # H counts as occupied
        OCC_ap_I = (not CLR_ap_I) or (not VALID)  # ap_I counts as occupied
        OCC_ap_II = (not CLR_ap_II) or (not VALID)  # ap_II counts as occupied
        OCC_ap_III = (not CLR_ap_III) or (not VALID)  # ap_III counts as occupied
        OCC_ap_IV = (not CLR_ap_IV) or (not VALID)  # ap_IV counts as occupied
        FREE_A = (not K_A) and (not L_A_1) and (not L_A_2)  # A is not locked by anybody
        FREE_B = (not K_B) and (not L_B_1) and (not L_B_2) and (not L_B_3)  # B is not locked by anybody
        FREE_C = (not K_C) and (not L_C_1) and (not L_C_2)  # C is not locked by anybody
        FREE_D = (not K_D) and (not L_D_1) and (not L_D_2)  # D is not locked by anybody
        FREE_E = (not K_E) and (not L_E_1) and (not L_E_2) and (not L_E_4)  # E is not locked by anybody
        FREE_F = (not K_F) and (not L_F_1)  # F is not locked by anybody
        FREE_G = (not K_G) and (not L_G_1)  # G is not locked by anybody
        FREE_H = (not K_H) and (not L_H_1) and (not L_H_2)  # H is not locked by anybody
        FREE_ap_II = (not K_ap_II) and (not L_ap_II_1)  # ap_II is not locked by anybody
        FREE_ap_IV = (not K_ap_IV) and (not L_ap_IV_1)  # ap_IV is not locked by anybody
        QN_PB = VALID and DN_PB and (not DR_PB)  # machine PB lies N (R10)
        QR_PB = VALID and DR_PB and (not DN_PB)  # machine PB lies R (R10)
        QN_PE = VALID and DN_PE and (not DR_PE)  # machine PE lies N (R10)
        QR_PE = VALID and DR_PE and (not DN_PE)  # machine PE lies R (R10)
        MOV_PB = VALID and FREE_B and (not OCC_B) and True and True  # machine PB is free to move (R10)
        AVN_PB = CN_PB or MOV_PB or (QN_PB and (not CN_PB) and (not CR_PB))  # machine PB can be demanded N
        AVR_PB = CR_PB or MOV_PB or (QR_PB and (not CN_PB) and (not CR_PB))  # machine PB can be demanded R
        MOV_PE = VALID and FREE_E and (not OCC_E) and True and True  # machine PE is free to move (R10)
        AVN_PE = CN_PE or MOV_PE or (QN_PE and (not CN_PE) and (not CR_PE))  # machine PE can be demanded N
        AVR_PE = CR_PE or MOV_PE or (QR_PE and (not CN_PE) and (not CR_PE))  # machine PE can be demanded R
        WF_A_1 = FREE_A and (not OCC_A) and (not BLK_A)  # A from A|B@PB.normal to I: free for a route (R6)
        WF_A_2 = FREE_A and (not OCC_A) and (not BLK_A)  # A from I to A|B@PB.normal: free for a route (R6)
        WA_B_1 = AVN_PB and (not TR_PB)  # B from A|B@PB.normal to B|C@PB.toe: could be locked
        WF_B_1 = FREE_B and (not OCC_B) and (not BLK_B) and WA_B_1  # B from A|B@PB.normal to B|C@PB.toe: free for a route (R6)
        WA_B_2 = AVN_PB and (not TR_PB)  # B from B|C@PB.toe to A|B@PB.normal: could be locked
        WF_B_2 = FREE_B and (not OCC_B) and (not BLK_B) and WA_B_2  # B from B|C@PB.toe to A|B@PB.normal: free for a route (R6)
        WA_B_3 = AVR_PB and (not TR_PB)  # B from B|C@PB.toe to B|G@PB.reverse: could be locked
        WF_B_3 = FREE_B and (not OCC_B) and (not BLK_B) and WA_B_3  # B from B|C@PB.toe to B|G@PB.reverse: free for a route (R6)
        WF_C_1 = FREE_C and (not OCC_C) and (not BLK_C)  # C from B|C@PB.toe to C|D@line.0: free for a route (R6)
        WF_C_2 = FREE_C and (not OCC_C) and (not BLK_C)  # C from C|D@line.0 to B|C@PB.toe: free for a route (R6)
        WF_D_1 = FREE_D and (not OCC_D) and (not BLK_D)  # D from C|D@line.0 to D|E@PE.toe: free for a route (R6)
        WF_D_2 = FREE_D and (not OCC_D) and (not BLK_D)  # D from D|E@PE.toe to C|D@line.0: free for a route (R6)
        WA_E_1 = AVN_PE and (not TR_PE)  # E from D|E@PE.toe to E|F@PE.normal: could be locked
        WF_E_1 = FREE_E and (not OCC_E) and (not BLK_E) and WA_E_1  # E from D|E@PE.toe to E|F@PE.normal: free for a route (R6)
        WA_E_2 = AVR_PE and (not TR_PE)  # E from D|E@PE.toe to E|H@PE.reverse: could be locked
        WF_E_2 = FREE_E and (not OCC_E) and (not BLK_E) and WA_E_2  # E from D|E@PE.toe to E|H@PE.reverse: free for a route (R6)
        WA_E_4 = AVR_PE and (not TR_PE)  # E from E|H@PE.reverse to D|E@PE.toe: could be locked
        WF_E_4 = FREE_E and (not OCC_E) and (not BLK_E) and WA_E_4  # E from E|H@PE.reverse to D|E@PE.toe: free for a route (R6)
        WF_F_1 = FREE_F and (not OCC_F) and (not BLK_F)  # F from E|F@PE.normal to F|ap_II@two.0: free for a route (R6)
        WF_G_1 = FREE_G and (not OCC_G) and (not BLK_G)  # G from B|G@PB.reverse to G|ap_IV@four.0: free for a route (R6)
        WF_H_1 = FREE_H and (not OCC_H) and (not BLK_H)  # H from E|H@PE.reverse to III: free for a route (R6)
        WF_H_2 = FREE_H and (not OCC_H) and (not BLK_H)  # H from III to E|H@PE.reverse: free for a route (R6)
        WF_ap_II_1 = FREE_ap_II and (not OCC_ap_II) and (not BLK_ap_II)  # ap_II from F|ap_II@two.0 to II: free for a route (R6)
        WF_ap_IV_1 = FREE_ap_IV and (not OCC_ap_IV) and (not BLK_ap_IV)  # ap_IV from G|ap_IV@four.0 to IV: free for a route (R6)
        WL_A_1 = (not OCC_A)  # A from A|B@PB.normal to I: lies and is clear
        WP_A_1 = WL_A_1 and (not BLK_A)  # A from A|B@PB.normal to I: proceed may be shown over it (R3)
        WL_A_2 = (not OCC_A)  # A from I to A|B@PB.normal: lies and is clear
        WP_A_2 = WL_A_2 and (not BLK_A)  # A from I to A|B@PB.normal: proceed may be shown over it (R3)
        WD_B_1 = QN_PB and (not TR_PB)  # B from A|B@PB.normal to B|C@PB.toe: its points lie, nothing is foul of it
        WL_B_1 = (not OCC_B) and WD_B_1  # B from A|B@PB.normal to B|C@PB.toe: lies and is clear
        WP_B_1 = WL_B_1 and (not BLK_B)  # B from A|B@PB.normal to B|C@PB.toe: proceed may be shown over it (R3)
        WD_B_2 = QN_PB and (not TR_PB)  # B from B|C@PB.toe to A|B@PB.normal: its points lie, nothing is foul of it
        WL_B_2 = (not OCC_B) and WD_B_2  # B from B|C@PB.toe to A|B@PB.normal: lies and is clear
        WP_B_2 = WL_B_2 and (not BLK_B)  # B from B|C@PB.toe to A|B@PB.normal: proceed may be shown over it (R3)
        WD_B_3 = QR_PB and (not TR_PB)  # B from B|C@PB.toe to B|G@PB.reverse: its points lie, nothing is foul of it
        WL_B_3 = (not OCC_B) and WD_B_3  # B from B|C@PB.toe to B|G@PB.reverse: lies and is clear
        WP_B_3 = WL_B_3 and (not BLK_B)  # B from B|C@PB.toe to B|G@PB.reverse: proceed may be shown over it (R3)
        WL_C_1 = (not OCC_C)  # C from B|C@PB.toe to C|D@line.0: lies and is clear
        WP_C_1 = WL_C_1 and (not BLK_C)  # C from B|C@PB.toe to C|D@line.0: proceed may be shown over it (R3)
        WL_C_2 = (not OCC_C)  # C from C|D@line.0 to B|C@PB.toe: lies and is clear
        WP_C_2 = WL_C_2 and (not BLK_C)  # C from C|D@line.0 to B|C@PB.toe: proceed may be shown over it (R3)
        WL_D_1 = (not OCC_D)  # D from C|D@line.0 to D|E@PE.toe: lies and is clear
        WP_D_1 = WL_D_1 and (not BLK_D)  # D from C|D@line.0 to D|E@PE.toe: proceed may be shown over it (R3)
        WL_D_2 = (not OCC_D)  # D from D|E@PE.toe to C|D@line.0: lies and is clear
        WP_D_2 = WL_D_2 and (not BLK_D)  # D from D|E@PE.toe to C|D@line.0: proceed may be shown over it (R3)
        WD_E_1 = QN_PE and (not TR_PE)  # E from D|E@PE.toe to E|F@PE.normal: its points lie, nothing is foul of it
        WL_E_1 = (not OCC_E) and WD_E_1  # E from D|E@PE.toe to E|F@PE.normal: lies and is clear
        WP_E_1 = WL_E_1 and (not BLK_E)  # E from D|E@PE.toe to E|F@PE.normal: proceed may be shown over it (R3)
        WD_E_2 = QR_PE and (not TR_PE)  # E from D|E@PE.toe to E|H@PE.reverse: its points lie, nothing is foul of it
        WL_E_2 = (not OCC_E) and WD_E_2  # E from D|E@PE.toe to E|H@PE.reverse: lies and is clear
        WP_E_2 = WL_E_2 and (not BLK_E)  # E from D|E@PE.toe to E|H@PE.reverse: proceed may be shown over it (R3)
        WD_E_4 = QR_PE and (not TR_PE)  # E from E|H@PE.reverse to D|E@PE.toe: its points lie, nothing is foul of it
        WL_E_4 = (not OCC_E) and WD_E_4  # E from E|H@PE.reverse to D|E@PE.toe: lies and is clear
        WP_E_4 = WL_E_4 and (not BLK_E)  # E from E|H@PE.reverse to D|E@PE.toe: proceed may be shown over it (R3)
        WL_F_1 = (not OCC_F)  # F from E|F@PE.normal to F|ap_II@two.0: lies and is clear
        WP_F_1 = WL_F_1 and (not BLK_F)  # F from E|F@PE.normal to F|ap_II@two.0: proceed may be shown over it (R3)
        WL_G_1 = (not OCC_G)  # G from B|G@PB.reverse to G|ap_IV@four.0: lies and is clear
        WP_G_1 = WL_G_1 and (not BLK_G)  # G from B|G@PB.reverse to G|ap_IV@four.0: proceed may be shown over it (R3)
        WL_H_1 = (not OCC_H)  # H from E|H@PE.reverse to III: lies and is clear
        WP_H_1 = WL_H_1 and (not BLK_H)  # H from E|H@PE.reverse to III: proceed may be shown over it (R3)
        WL_H_2 = (not OCC_H)  # H from III to E|H@PE.reverse: lies and is clear
        WP_H_2 = WL_H_2 and (not BLK_H)  # H from III to E|H@PE.reverse: proceed may be shown over it (R3)
        WL_ap_II_1 = (not OCC_ap_II)  # ap_II from F|ap_II@two.0 to II: lies and is clear
        WP_ap_II_1 = WL_ap_II_1 and (not BLK_ap_II)  # ap_II from F|ap_II@two.0 to II: proceed may be shown over it (R3)
        WL_ap_IV_1 = (not OCC_ap_IV)  # ap_IV from G|ap_IV@four.0 to IV: lies and is clear
        WP_ap_IV_1 = WL_ap_IV_1 and (not BLK_ap_IV)  # ap_IV from G|ap_IV@four.0 to IV: proceed may be shown over it (R3)
        RQ_R2 = ((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) or ((LREQ == 0) and (REQ == 0) and T_R2 and N_R2 and (not L_B_3) and (not L_C_2) and (not L_D_2) and (not L_E_4))  # route SC-SF is asked for (R14, R18)
        RQ_R4 = ((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) or ((LREQ == 0) and (REQ == 0) and T_R4 and N_R4 and (not L_B_1) and (not L_C_1) and (not L_D_1) and (not L_E_1))  # route SD-SG is asked for (R14, R18)
        RQ_R5 = ((LREQ == 5) or ((LREQ == 0) and (REQ == 5))) or ((LREQ == 0) and (REQ == 0) and T_R5 and N_R5 and (not L_B_1) and (not L_C_1) and (not L_D_1) and (not L_E_1))  # route SE-SD is asked for (R14, R18)
        RQ_R6 = ((LREQ == 6) or ((LREQ == 0) and (REQ == 6))) or ((LREQ == 0) and (REQ == 0) and T_R6 and N_R6)  # route SF-II is asked for (R14, R18)
        RQ_R7 = ((LREQ == 7) or ((LREQ == 0) and (REQ == 7))) or ((LREQ == 0) and (REQ == 0) and T_R7 and N_R7)  # route SG-IV is asked for (R14, R18)
        RQ_R8 = ((LREQ == 8) or ((LREQ == 0) and (REQ == 8))) or ((LREQ == 0) and (REQ == 0) and T_R8 and N_R8)  # route SI-SV is asked for (R14, R18)
        RQ_R9 = ((LREQ == 9) or ((LREQ == 0) and (REQ == 9))) or ((LREQ == 0) and (REQ == 0) and T_R9 and N_R9)  # route SIII-SE is asked for (R14, R18)
        RQ_R10 = ((LREQ == 10) or ((LREQ == 0) and (REQ == 10))) or ((LREQ == 0) and (REQ == 0) and T_R10 and N_R10 and (not L_B_3) and (not L_C_2) and (not L_D_2) and (not L_E_4))  # route SV-SC is asked for (R14, R18)
        G_R1 = ((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and VALID and WF_D_1 and WF_E_2 and WF_H_1  # grant of route SC-III (R6)
        G_R2 = RQ_R2 and VALID and WF_D_1 and WF_E_1 and WF_F_1  # grant of route SC-SF (R6)
        G_R3 = ((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and VALID and WF_C_2 and WF_B_2 and WF_A_1  # grant of route SD-I (R6)
        G_R4 = RQ_R4 and VALID and WF_C_2 and WF_B_3 and WF_G_1  # grant of route SD-SG (R6)
        G_R5 = RQ_R5 and VALID and WF_E_4 and WF_D_2  # grant of route SE-SD (R6)
        G_R6 = RQ_R6 and VALID and WF_ap_II_1  # grant of route SF-II (R6)
        G_R7 = RQ_R7 and VALID and WF_ap_IV_1  # grant of route SG-IV (R6)
        G_R8 = RQ_R8 and VALID and WF_A_2  # grant of route SI-SV (R6)
        G_R9 = RQ_R9 and VALID and WF_H_2  # grant of route SIII-SE (R6)
        G_R10 = RQ_R10 and VALID and WF_B_1 and WF_C_1  # grant of route SV-SC (R6)
        GW_A_1 = G_R3  # A from A|B@PB.normal to I: granted
        GW_A_2 = G_R8  # A from I to A|B@PB.normal: granted
        GW_B_1 = G_R10  # B from A|B@PB.normal to B|C@PB.toe: granted
        GW_B_2 = G_R3  # B from B|C@PB.toe to A|B@PB.normal: granted
        GW_B_3 = G_R4  # B from B|C@PB.toe to B|G@PB.reverse: granted
        GW_C_1 = G_R10  # C from B|C@PB.toe to C|D@line.0: granted
        GW_C_2 = G_R3 or G_R4  # C from C|D@line.0 to B|C@PB.toe: granted
        GW_D_1 = G_R1 or G_R2  # D from C|D@line.0 to D|E@PE.toe: granted
        GW_D_2 = G_R5  # D from D|E@PE.toe to C|D@line.0: granted
        GW_E_1 = G_R2  # E from D|E@PE.toe to E|F@PE.normal: granted
        GW_E_2 = G_R1  # E from D|E@PE.toe to E|H@PE.reverse: granted
        GW_E_4 = G_R5  # E from E|H@PE.reverse to D|E@PE.toe: granted
        GW_F_1 = G_R2  # F from E|F@PE.normal to F|ap_II@two.0: granted
        GW_G_1 = G_R4  # G from B|G@PB.reverse to G|ap_IV@four.0: granted
        GW_H_1 = G_R1  # H from E|H@PE.reverse to III: granted
        GW_H_2 = G_R9  # H from III to E|H@PE.reverse: granted
        GW_ap_II_1 = G_R6  # ap_II from F|ap_II@two.0 to II: granted
        GW_ap_IV_1 = G_R7  # ap_IV from G|ap_IV@four.0 to IV: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_SC) and (not CAN_SC) and WL_D_1 and WL_E_2 and WL_H_1  # route SC-III becomes locked (R3)
        CO_R1 = VALID and WP_D_1 and WP_E_2 and WP_H_1 and (not OCC_ap_III) and (not D_D)  # conditions of proceed for route SC-III (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_SC) and (not CAN_SC) and WL_D_1 and WL_E_1 and WL_F_1  # route SC-SF becomes locked (R3)
        CO_R2 = VALID and WP_D_1 and WP_E_1 and WP_F_1 and (not D_D)  # conditions of proceed for route SC-SF (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_SD) and (not CAN_SD) and WL_C_2 and WL_B_2 and WL_A_1  # route SD-I becomes locked (R3)
        CO_R3 = VALID and WP_C_2 and WP_B_2 and WP_A_1 and (not OCC_ap_I) and (not D_C)  # conditions of proceed for route SD-I (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_SD) and (not CAN_SD) and WL_C_2 and WL_B_3 and WL_G_1  # route SD-SG becomes locked (R3)
        CO_R4 = VALID and WP_C_2 and WP_B_3 and WP_G_1 and (not D_C)  # conditions of proceed for route SD-SG (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_SE) and (not CAN_SE) and WL_E_4 and WL_D_2  # route SE-SD becomes locked (R3)
        CO_R5 = VALID and WP_E_4 and WP_D_2 and (not D_E)  # conditions of proceed for route SE-SD (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_SF) and (not CAN_SF) and WL_ap_II_1  # route SF-II becomes locked (R3)
        CO_R6 = VALID and WP_ap_II_1 and (not D_ap_II)  # conditions of proceed for route SF-II (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_SG) and (not CAN_SG) and WL_ap_IV_1  # route SG-IV becomes locked (R3)
        CO_R7 = VALID and WP_ap_IV_1 and (not D_ap_IV)  # conditions of proceed for route SG-IV (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_SI) and (not CAN_SI) and WL_A_2  # route SI-SV becomes locked (R3)
        CO_R8 = VALID and WP_A_2 and (not D_A)  # conditions of proceed for route SI-SV (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_SIII) and (not CAN_SIII) and WL_H_2  # route SIII-SE becomes locked (R3)
        CO_R9 = VALID and WP_H_2 and (not D_H)  # conditions of proceed for route SIII-SE (R3)
        LK_R10 = A_R10 and (not B_R10) and VALID and (not X_SV) and (not CAN_SV) and WL_B_1 and WL_C_1  # route SV-SC becomes locked (R3)
        CO_R10 = VALID and WP_B_1 and WP_C_1 and (not D_B)  # conditions of proceed for route SV-SC (R3)
        NU_A_1 = VALID and F_A and (not D_A) and (not U_A) and L_A_1 and OCC_A and OCC_B and U_B and L_B_2  # a train comes into A at A|B@PB.normal (R9)
        NU_A_2 = VALID and F_A and (not D_A) and (not U_A) and L_A_2 and OCC_A and OCC_ap_I  # a train comes into A at I (R9)
        NU_B_1 = VALID and F_B and (not D_B) and (not U_B) and L_B_1 and OCC_B and OCC_A  # a train comes into B at A|B@PB.normal (R9)
        NU_B_2 = VALID and F_B and (not D_B) and (not U_B) and (L_B_2 or L_B_3) and OCC_B and OCC_C and U_C and L_C_2  # a train comes into B at B|C@PB.toe (R9)
        NU_C_1 = VALID and F_C and (not D_C) and (not U_C) and L_C_1 and OCC_C and OCC_B and U_B and L_B_1  # a train comes into C at B|C@PB.toe (R9)
        NU_C_2 = VALID and F_C and (not D_C) and (not U_C) and L_C_2 and OCC_C and OCC_D  # a train comes into C at C|D@line.0 (R9)
        NU_D_1 = VALID and F_D and (not D_D) and (not U_D) and L_D_1 and OCC_D and OCC_C  # a train comes into D at C|D@line.0 (R9)
        NU_D_2 = VALID and F_D and (not D_D) and (not U_D) and L_D_2 and OCC_D and OCC_E and U_E and L_E_4  # a train comes into D at D|E@PE.toe (R9)
        NU_E_1 = VALID and F_E and (not D_E) and (not U_E) and (L_E_1 or L_E_2) and OCC_E and OCC_D and U_D and L_D_1  # a train comes into E at D|E@PE.toe (R9)
        NU_E_3 = VALID and F_E and (not D_E) and (not U_E) and L_E_4 and OCC_E and OCC_H  # a train comes into E at E|H@PE.reverse (R9)
        NU_F_1 = VALID and F_F and (not D_F) and (not U_F) and L_F_1 and OCC_F and OCC_E and U_E and L_E_1  # a train comes into F at E|F@PE.normal (R9)
        NU_G_1 = VALID and F_G and (not D_G) and (not U_G) and L_G_1 and OCC_G and OCC_B and U_B and L_B_3  # a train comes into G at B|G@PB.reverse (R9)
        NU_H_1 = VALID and F_H and (not D_H) and (not U_H) and L_H_1 and OCC_H and OCC_E and U_E and L_E_2  # a train comes into H at E|H@PE.reverse (R9)
        NU_H_2 = VALID and F_H and (not D_H) and (not U_H) and L_H_2 and OCC_H and OCC_ap_III  # a train comes into H at III (R9)
        NU_ap_II_1 = VALID and F_ap_II and (not D_ap_II) and (not U_ap_II) and L_ap_II_1 and OCC_ap_II and OCC_F  # a train comes into ap_II at F|ap_II@two.0 (R9)
        NU_ap_IV_1 = VALID and F_ap_IV and (not D_ap_IV) and (not U_ap_IV) and L_ap_IV_1 and OCC_ap_IV and OCC_G  # a train comes into ap_IV at G|ap_IV@four.0 (R9)
        ATI_SC = X_SC or ((not (A_R1 or A_R2)) and L_D_1 and REL_D)  # SC at stop, waiting for a train that may still come (R8)
        ATI_SD = X_SD or ((not (A_R3 or A_R4)) and L_C_2 and REL_C)  # SD at stop, waiting for a train that may still come (R8)
        ATI_SE = X_SE or ((not A_R5) and L_E_4 and REL_E)  # SE at stop, waiting for a train that may still come (R8)
        ATI_SF = X_SF or ((not A_R6) and L_ap_II_1 and (REL_ap_II or (L_ap_II_1 and U_ap_II and (not OCC_ap_II))))  # SF at stop, waiting for a train that may still come (R8)
        ATI_SG = X_SG or ((not A_R7) and L_ap_IV_1 and (REL_ap_IV or (L_ap_IV_1 and U_ap_IV and (not OCC_ap_IV))))  # SG at stop, waiting for a train that may still come (R8)
        ATI_SI = X_SI or ((not A_R8) and L_A_2 and REL_A)  # SI at stop, waiting for a train that may still come (R8)
        ATI_SIII = X_SIII or ((not A_R9) and L_H_2 and REL_H)  # SIII at stop, waiting for a train that may still come (R8)
        ATI_SV = X_SV or ((not A_R10) and L_B_1 and REL_B)  # SV at stop, waiting for a train that may still come (R8)
        AT_SC = self._timer('AT_SC', ATI_SC, dt_ms)  # SC: approach locking delay (R8)
        AT_SD = self._timer('AT_SD', ATI_SD, dt_ms)  # SD: approach locking delay (R8)
        AT_SE = self._timer('AT_SE', ATI_SE, dt_ms)  # SE: approach locking delay (R8)
        AT_SF = self._timer('AT_SF', ATI_SF, dt_ms)  # SF: approach locking delay (R8)
        AT_SG = self._timer('AT_SG', ATI_SG, dt_ms)  # SG: approach locking delay (R8)
        AT_SI = self._timer('AT_SI', ATI_SI, dt_ms)  # SI: approach locking delay (R8)
        AT_SIII = self._timer('AT_SIII', ATI_SIII, dt_ms)  # SIII: approach locking delay (R8)
        AT_SV = self._timer('AT_SV', ATI_SV, dt_ms)  # SV: approach locking delay (R8)
        CD_SC = X_SC and (A_R1 or A_R2) and VALID and (not OCC_D) and ((not OCC_C) or AT_SC or (not (H_R1 or H_R2)))  # the route from SC is cancelled (R8)
        CD_SD = X_SD and (A_R3 or A_R4) and VALID and (not OCC_C) and ((not OCC_D) or AT_SD or (not (H_R3 or H_R4)))  # the route from SD is cancelled (R8)
        CD_SE = X_SE and A_R5 and VALID and (not OCC_E) and ((not OCC_H) or AT_SE or (not H_R5))  # the route from SE is cancelled (R8)
        CD_SF = X_SF and A_R6 and VALID and (not OCC_ap_II) and ((not OCC_F) or AT_SF or (not H_R6))  # the route from SF is cancelled (R8)
        CD_SG = X_SG and A_R7 and VALID and (not OCC_ap_IV) and ((not OCC_G) or AT_SG or (not H_R7))  # the route from SG is cancelled (R8)
        CD_SI = X_SI and A_R8 and VALID and (not OCC_A) and ((not OCC_ap_I) or AT_SI or (not H_R8))  # the route from SI is cancelled (R8)
        CD_SIII = X_SIII and A_R9 and VALID and (not OCC_H) and ((not OCC_ap_III) or AT_SIII or (not H_R9))  # the route from SIII is cancelled (R8)
        CD_SV = X_SV and A_R10 and VALID and (not OCC_B) and ((not OCC_A) or AT_SV or (not H_R10))  # the route from SV is cancelled (R8)
        EX_A = P_A or L_A_1  # a train in A leaves over a boundary, or has passed on
        RTI_A = VALID and U_A and (not OCC_A) and (not (L_A_1 and L_B_2)) and EX_A  # A may be released behind the train (R9)
        EX_B = P_B  # a train in B leaves over a boundary, or has passed on
        RTI_B = VALID and U_B and (not OCC_B) and (not ((L_B_2 or L_B_3) and L_C_2)) and EX_B  # B may be released behind the train (R9)
        EX_C = P_C  # a train in C leaves over a boundary, or has passed on
        RTI_C = VALID and U_C and (not OCC_C) and (not (L_C_1 and L_B_1)) and EX_C  # C may be released behind the train (R9)
        EX_D = P_D  # a train in D leaves over a boundary, or has passed on
        RTI_D = VALID and U_D and (not OCC_D) and (not (L_D_2 and L_E_4)) and EX_D  # D may be released behind the train (R9)
        EX_E = P_E  # a train in E leaves over a boundary, or has passed on
        RTI_E = VALID and U_E and (not OCC_E) and (not ((L_E_1 or L_E_2) and L_D_1)) and EX_E  # E may be released behind the train (R9)
        EX_F = P_F  # a train in F leaves over a boundary, or has passed on
        RTI_F = VALID and U_F and (not OCC_F) and (not (L_F_1 and L_E_1)) and EX_F  # F may be released behind the train (R9)
        EX_G = P_G  # a train in G leaves over a boundary, or has passed on
        RTI_G = VALID and U_G and (not OCC_G) and (not (L_G_1 and L_B_3)) and EX_G  # G may be released behind the train (R9)
        EX_H = P_H or L_H_1  # a train in H leaves over a boundary, or has passed on
        RTI_H = VALID and U_H and (not OCC_H) and (not (L_H_1 and L_E_2)) and EX_H  # H may be released behind the train (R9)
        EX_ap_II = P_ap_II or (L_ap_II_1 and ((not OCC_F) or AT_SF))  # a train in ap_II leaves over a boundary, or has passed on
        RTI_ap_II = VALID and U_ap_II and (not OCC_ap_II) and EX_ap_II  # ap_II may be released behind the train (R9)
        EX_ap_IV = P_ap_IV or (L_ap_IV_1 and ((not OCC_G) or AT_SG))  # a train in ap_IV leaves over a boundary, or has passed on
        RTI_ap_IV = VALID and U_ap_IV and (not OCC_ap_IV) and EX_ap_IV  # ap_IV may be released behind the train (R9)
        RT_A = self._timer('RT_A', RTI_A, dt_ms)  # A: release delay (R9)
        RT_B = self._timer('RT_B', RTI_B, dt_ms)  # B: release delay (R9)
        RT_C = self._timer('RT_C', RTI_C, dt_ms)  # C: release delay (R9)
        RT_D = self._timer('RT_D', RTI_D, dt_ms)  # D: release delay (R9)
        RT_E = self._timer('RT_E', RTI_E, dt_ms)  # E: release delay (R9)
        RT_F = self._timer('RT_F', RTI_F, dt_ms)  # F: release delay (R9)
        RT_G = self._timer('RT_G', RTI_G, dt_ms)  # G: release delay (R9)
        RT_H = self._timer('RT_H', RTI_H, dt_ms)  # H: release delay (R9)
        RT_ap_II = self._timer('RT_ap_II', RTI_ap_II, dt_ms)  # ap_II: release delay (R9)
        RT_ap_IV = self._timer('RT_ap_IV', RTI_ap_IV, dt_ms)  # ap_IV: release delay (R9)
        CA_A = VALID and (not OCC_A) and (not U_A) and L_A_1 and (not (L_A_1 and L_B_2))  # the lock before A was withdrawn (R8)
        HR_A = VALID and (not OCC_A) and (not (L_A_1 and L_B_2)) and REL_A and (L_A_1 or L_A_2) and ((not L_A_2) or ((not A_R8) and ((not OCC_ap_I) or AT_SI)))  # A released by hand (R8, section fault release)
        SR_A = VALID and (not OCC_A) and K_A and (REL_A or RELALL)  # A released after a restart (R16)
        RLS_A = RT_A or CA_A or CD_SI or HR_A or SR_A  # A is released
        CA_B = VALID and (not OCC_B) and (not U_B) and (L_B_2 or L_B_3) and (not ((L_B_2 or L_B_3) and L_C_2))  # the lock before B was withdrawn (R8)
        HR_B = VALID and (not OCC_B) and (not ((L_B_2 or L_B_3) and L_C_2)) and REL_B and (L_B_1 or L_B_2 or L_B_3) and ((not L_B_1) or ((not A_R10) and ((not OCC_A) or AT_SV)))  # B released by hand (R8, section fault release)
        SR_B = VALID and (not OCC_B) and K_B and (REL_B or RELALL)  # B released after a restart (R16)
        RLS_B = RT_B or CA_B or CD_SV or HR_B or SR_B  # B is released
        CA_C = VALID and (not OCC_C) and (not U_C) and L_C_1 and (not (L_C_1 and L_B_1))  # the lock before C was withdrawn (R8)
        HR_C = VALID and (not OCC_C) and (not (L_C_1 and L_B_1)) and REL_C and (L_C_1 or L_C_2) and ((not L_C_2) or ((not (A_R3 or A_R4)) and ((not OCC_D) or AT_SD)))  # C released by hand (R8, section fault release)
        SR_C = VALID and (not OCC_C) and K_C and (REL_C or RELALL)  # C released after a restart (R16)
        RLS_C = RT_C or CA_C or CD_SD or HR_C or SR_C  # C is released
        CA_D = VALID and (not OCC_D) and (not U_D) and L_D_2 and (not (L_D_2 and L_E_4))  # the lock before D was withdrawn (R8)
        HR_D = VALID and (not OCC_D) and (not (L_D_2 and L_E_4)) and REL_D and (L_D_1 or L_D_2) and ((not L_D_1) or ((not (A_R1 or A_R2)) and ((not OCC_C) or AT_SC)))  # D released by hand (R8, section fault release)
        SR_D = VALID and (not OCC_D) and K_D and (REL_D or RELALL)  # D released after a restart (R16)
        RLS_D = RT_D or CA_D or CD_SC or HR_D or SR_D  # D is released
        CA_E = VALID and (not OCC_E) and (not U_E) and (L_E_1 or L_E_2) and (not ((L_E_1 or L_E_2) and L_D_1))  # the lock before E was withdrawn (R8)
        HR_E = VALID and (not OCC_E) and (not ((L_E_1 or L_E_2) and L_D_1)) and REL_E and (L_E_1 or L_E_2 or L_E_4) and ((not L_E_4) or ((not A_R5) and ((not OCC_H) or AT_SE)))  # E released by hand (R8, section fault release)
        SR_E = VALID and (not OCC_E) and K_E and (REL_E or RELALL)  # E released after a restart (R16)
        RLS_E = RT_E or CA_E or CD_SE or HR_E or SR_E  # E is released
        CA_F = VALID and (not OCC_F) and (not U_F) and L_F_1 and (not (L_F_1 and L_E_1))  # the lock before F was withdrawn (R8)
        HR_F = VALID and (not OCC_F) and (not (L_F_1 and L_E_1)) and REL_F and L_F_1  # F released by hand (R8, section fault release)
        SR_F = VALID and (not OCC_F) and K_F and (REL_F or RELALL)  # F released after a restart (R16)
        RLS_F = RT_F or CA_F or HR_F or SR_F  # F is released
        CA_G = VALID and (not OCC_G) and (not U_G) and L_G_1 and (not (L_G_1 and L_B_3))  # the lock before G was withdrawn (R8)
        HR_G = VALID and (not OCC_G) and (not (L_G_1 and L_B_3)) and REL_G and L_G_1  # G released by hand (R8, section fault release)
        SR_G = VALID and (not OCC_G) and K_G and (REL_G or RELALL)  # G released after a restart (R16)
        RLS_G = RT_G or CA_G or HR_G or SR_G  # G is released
        CA_H = VALID and (not OCC_H) and (not U_H) and L_H_1 and (not (L_H_1 and L_E_2))  # the lock before H was withdrawn (R8)
        HR_H = VALID and (not OCC_H) and (not (L_H_1 and L_E_2)) and REL_H and (L_H_1 or L_H_2) and ((not L_H_2) or ((not A_R9) and ((not OCC_ap_III) or AT_SIII)))  # H released by hand (R8, section fault release)
        SR_H = VALID and (not OCC_H) and K_H and (REL_H or RELALL)  # H released after a restart (R16)
        RLS_H = RT_H or CA_H or CD_SIII or HR_H or SR_H  # H is released
        CA_ap_II = VALID and (not OCC_ap_II) and (not U_ap_II) and False  # the lock before ap_II was withdrawn (R8)
        HR_ap_II = VALID and (not OCC_ap_II) and REL_ap_II and L_ap_II_1 and ((not L_ap_II_1) or ((not A_R6) and ((not OCC_F) or AT_SF)))  # ap_II released by hand (R8, section fault release)
        SR_ap_II = VALID and (not OCC_ap_II) and K_ap_II and (REL_ap_II or RELALL)  # ap_II released after a restart (R16)
        RLS_ap_II = RT_ap_II or CA_ap_II or CD_SF or HR_ap_II or SR_ap_II  # ap_II is released
        CA_ap_IV = VALID and (not OCC_ap_IV) and (not U_ap_IV) and False  # the lock before ap_IV was withdrawn (R8)
        HR_ap_IV = VALID and (not OCC_ap_IV) and REL_ap_IV and L_ap_IV_1 and ((not L_ap_IV_1) or ((not A_R7) and ((not OCC_G) or AT_SG)))  # ap_IV released by hand (R8, section fault release)
        SR_ap_IV = VALID and (not OCC_ap_IV) and K_ap_IV and (REL_ap_IV or RELALL)  # ap_IV released after a restart (R16)
        RLS_ap_IV = RT_ap_IV or CA_ap_IV or CD_SG or HR_ap_IV or SR_ap_IV  # ap_IV is released
        TG_PB = (GW_B_1 or GW_B_2 or GW_B_3)  # a grant touches machine PB in this scan
        GPN_PB = (GW_B_1 or GW_B_2)  # a grant needs PB N
        MAN_PB = MN_PB and (not MR_PB) and MOV_PB and (not TG_PB)  # machine PB moved N by hand
        GPR_PB = GW_B_3  # a grant needs PB R
        MAR_PB = MR_PB and (not MN_PB) and MOV_PB and (not TG_PB)  # machine PB moved R by hand
        HDN_PB = CN_PB and (not GPR_PB) and (not MAR_PB)  # the command N stays
        HDR_PB = CR_PB and (not GPN_PB) and (not MAN_PB)  # the command R stays
        TG_PE = (GW_E_1 or GW_E_2 or GW_E_4)  # a grant touches machine PE in this scan
        GPN_PE = GW_E_1  # a grant needs PE N
        MAN_PE = MN_PE and (not MR_PE) and MOV_PE and (not TG_PE)  # machine PE moved N by hand
        GPR_PE = (GW_E_2 or GW_E_4)  # a grant needs PE R
        MAR_PE = MR_PE and (not MN_PE) and MOV_PE and (not TG_PE)  # machine PE moved R by hand
        HDN_PE = CN_PE and (not GPR_PE) and (not MAR_PE)  # the command N stays
        HDR_PE = CR_PE and (not GPN_PE) and (not MAN_PE)  # the command R stays
        STI_PB = (CN_PB and (not QN_PB)) or (CR_PB and (not QR_PB))  # machine PB is not where it was commanded
        STI_PE = (CN_PE and (not QN_PE)) or (CR_PE and (not QR_PE))  # machine PE is not where it was commanded
        ST_PB = self._timer('ST_PB', STI_PB, dt_ms)  # machine PB: time-out
        ST_PE = self._timer('ST_PE', STI_PE, dt_ms)  # machine PE: time-out
        KP_R1 = (not NU_D_1) and (not CD_SC)  # route SC-III stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_SC) and (not CAN_SC)  # proceed for route SC-III (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route SC-III: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_D_1) and (not CD_SC)  # route SC-SF stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_SC) and (not CAN_SC)  # proceed for route SC-SF (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route SC-SF: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_C_2) and (not CD_SD)  # route SD-I stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_SD) and (not CAN_SD)  # proceed for route SD-I (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route SD-I: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_C_2) and (not CD_SD)  # route SD-SG stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_SD) and (not CAN_SD)  # proceed for route SD-SG (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route SD-SG: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_E_3) and (not CD_SE)  # route SE-SD stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_SE) and (not CAN_SE)  # proceed for route SE-SD (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route SE-SD: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_ap_II_1) and (not CD_SF)  # route SF-II stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_SF) and (not CAN_SF)  # proceed for route SF-II (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route SF-II: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_ap_IV_1) and (not CD_SG)  # route SG-IV stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_SG) and (not CAN_SG)  # proceed for route SG-IV (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route SG-IV: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_A_2) and (not CD_SI)  # route SI-SV stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_SI) and (not CAN_SI)  # proceed for route SI-SV (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route SI-SV: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_H_2) and (not CD_SIII)  # route SIII-SE stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_SIII) and (not CAN_SIII)  # proceed for route SIII-SE (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route SIII-SE: a condition was lost; no reopening by itself (R14)
        KP_R10 = (not NU_B_1) and (not CD_SV)  # route SV-SC stays set
        PR_R10 = A_R10 and B_R10 and W_R10 and CO_R10 and KP_R10 and (not X_SV) and (not CAN_SV)  # proceed for route SV-SC (R3, R11)
        LS_R10 = S_R10 and (not CO_R10)  # route SV-SC: a condition was lost; no reopening by itself (R14)
        N_CN_PB = GPN_PB or MAN_PB or HDN_PB  # machine PB commanded N
        N_CR_PB = GPR_PB or MAR_PB or HDR_PB  # machine PB commanded R
        N_CN_PE = GPN_PE or MAN_PE or HDN_PE  # machine PE commanded N
        N_CR_PE = GPR_PE or MAR_PE or HDR_PE  # machine PE commanded R
        N_AL_PB = ST_PB  # alarm: machine PB not detected
        N_AL_PE = ST_PE  # alarm: machine PE not detected
        N_TH_PB = ((CN_PB and QN_PB) or (CR_PB and QR_PB)) and (not (GPN_PB or GPR_PB or MAN_PB or MAR_PB))  # machine PB was detected where it is commanded
        N_TR_PB = (TH_PB and VALID and ((CN_PB and (not QN_PB) and (not GPR_PB) and (not MAR_PB)) or (CR_PB and (not QR_PB) and (not GPN_PB) and (not MAN_PB)))) or (TR_PB and (not (TC_PB and VALID and (not OCC_B))))  # machine PB was trailed
        N_TH_PE = ((CN_PE and QN_PE) or (CR_PE and QR_PE)) and (not (GPN_PE or GPR_PE or MAN_PE or MAR_PE))  # machine PE was detected where it is commanded
        N_TR_PE = (TH_PE and VALID and ((CN_PE and (not QN_PE) and (not GPR_PE) and (not MAR_PE)) or (CR_PE and (not QR_PE) and (not GPN_PE) and (not MAN_PE)))) or (TR_PE and (not (TC_PE and VALID and (not OCC_E))))  # machine PE was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route SC-III active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route SC-III locked
        N_W_R1 = (W_R1 or LK_R1 or (((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and B_R1)) and (not LS_R1) and KP_R1 and (not X_SC) and (not CAN_SC)  # route SC-III: proceed wanted
        N_S_R1 = PR_R1  # route SC-III: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route SC-III: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route SC-SF active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route SC-SF locked
        N_W_R2 = (W_R2 or LK_R2 or (((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) and B_R2)) and (not LS_R2) and KP_R2 and (not X_SC) and (not CAN_SC)  # route SC-SF: proceed wanted
        N_S_R2 = PR_R2  # route SC-SF: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route SC-SF: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route SD-I active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route SD-I locked
        N_W_R3 = (W_R3 or LK_R3 or (((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and B_R3)) and (not LS_R3) and KP_R3 and (not X_SD) and (not CAN_SD)  # route SD-I: proceed wanted
        N_S_R3 = PR_R3  # route SD-I: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route SD-I: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route SD-SG active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route SD-SG locked
        N_W_R4 = (W_R4 or LK_R4 or (((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and B_R4)) and (not LS_R4) and KP_R4 and (not X_SD) and (not CAN_SD)  # route SD-SG: proceed wanted
        N_S_R4 = PR_R4  # route SD-SG: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route SD-SG: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route SE-SD active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route SE-SD locked
        N_W_R5 = (W_R5 or LK_R5 or (((LREQ == 5) or ((LREQ == 0) and (REQ == 5))) and B_R5)) and (not LS_R5) and KP_R5 and (not X_SE) and (not CAN_SE)  # route SE-SD: proceed wanted
        N_S_R5 = PR_R5  # route SE-SD: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route SE-SD: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route SF-II active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route SF-II locked
        N_W_R6 = (W_R6 or LK_R6 or (((LREQ == 6) or ((LREQ == 0) and (REQ == 6))) and B_R6)) and (not LS_R6) and KP_R6 and (not X_SF) and (not CAN_SF)  # route SF-II: proceed wanted
        N_S_R6 = PR_R6  # route SF-II: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route SF-II: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route SG-IV active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route SG-IV locked
        N_W_R7 = (W_R7 or LK_R7 or (((LREQ == 7) or ((LREQ == 0) and (REQ == 7))) and B_R7)) and (not LS_R7) and KP_R7 and (not X_SG) and (not CAN_SG)  # route SG-IV: proceed wanted
        N_S_R7 = PR_R7  # route SG-IV: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route SG-IV: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route SI-SV active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route SI-SV locked
        N_W_R8 = (W_R8 or LK_R8 or (((LREQ == 8) or ((LREQ == 0) and (REQ == 8))) and B_R8)) and (not LS_R8) and KP_R8 and (not X_SI) and (not CAN_SI)  # route SI-SV: proceed wanted
        N_S_R8 = PR_R8  # route SI-SV: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route SI-SV: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route SIII-SE active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route SIII-SE locked
        N_W_R9 = (W_R9 or LK_R9 or (((LREQ == 9) or ((LREQ == 0) and (REQ == 9))) and B_R9)) and (not LS_R9) and KP_R9 and (not X_SIII) and (not CAN_SIII)  # route SIII-SE: proceed wanted
        N_S_R9 = PR_R9  # route SIII-SE: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route SIII-SE: signal has been open
        N_A_R10 = (A_R10 or G_R10) and KP_R10  # route SV-SC active
        N_B_R10 = (B_R10 or LK_R10) and KP_R10  # route SV-SC locked
        N_W_R10 = (W_R10 or LK_R10 or (((LREQ == 10) or ((LREQ == 0) and (REQ == 10))) and B_R10)) and (not LS_R10) and KP_R10 and (not X_SV) and (not CAN_SV)  # route SV-SC: proceed wanted
        N_S_R10 = PR_R10  # route SV-SC: proceed
        N_H_R10 = (H_R10 or PR_R10) and KP_R10  # route SV-SC: signal has been open
        N_X_SC = (X_SC or CAN_SC) and (A_R1 or A_R2) and (not CD_SC)  # SC: cancelling
        N_X_SD = (X_SD or CAN_SD) and (A_R3 or A_R4) and (not CD_SD)  # SD: cancelling
        N_X_SE = (X_SE or CAN_SE) and A_R5 and (not CD_SE)  # SE: cancelling
        N_X_SF = (X_SF or CAN_SF) and A_R6 and (not CD_SF)  # SF: cancelling
        N_X_SG = (X_SG or CAN_SG) and A_R7 and (not CD_SG)  # SG: cancelling
        N_X_SI = (X_SI or CAN_SI) and A_R8 and (not CD_SI)  # SI: cancelling
        N_X_SIII = (X_SIII or CAN_SIII) and A_R9 and (not CD_SIII)  # SIII: cancelling
        N_X_SV = (X_SV or CAN_SV) and A_R10 and (not CD_SV)  # SV: cancelling
        N_N_R2 = (N_R2 or (VOY == 1)) and (not G_R2) and (not CAN_SC)  # route SC-SF is noted
        N_T_R2 = T_R10  # it is the turn of route SC-SF
        N_N_R4 = (N_R4 or (VOY == 2)) and (not G_R4) and (not CAN_SD)  # route SD-SG is noted
        N_T_R4 = T_R2  # it is the turn of route SD-SG
        N_N_R5 = (N_R5 or (VOY == 2)) and (not G_R5) and (not CAN_SE)  # route SE-SD is noted
        N_T_R5 = T_R4  # it is the turn of route SE-SD
        N_N_R6 = (N_R6 or (VOY == 1)) and (not G_R6) and (not CAN_SF)  # route SF-II is noted
        N_T_R6 = T_R5  # it is the turn of route SF-II
        N_N_R7 = (N_R7 or (VOY == 2)) and (not G_R7) and (not CAN_SG)  # route SG-IV is noted
        N_T_R7 = T_R6  # it is the turn of route SG-IV
        N_N_R8 = (N_R8 or (VOY == 1)) and (not G_R8) and (not CAN_SI)  # route SI-SV is noted
        N_T_R8 = T_R7  # it is the turn of route SI-SV
        N_N_R9 = (N_R9 or (VOY == 2)) and (not G_R9) and (not CAN_SIII)  # route SIII-SE is noted
        N_T_R9 = T_R8  # it is the turn of route SIII-SE
        N_N_R10 = (N_R10 or (VOY == 1)) and (not G_R10) and (not CAN_SV)  # route SV-SC is noted
        N_T_R10 = T_R9  # it is the turn of route SV-SC
        N_K_A = K_A and (not RLS_A)  # A: restart lock (R16)
        N_L_A_1 = (L_A_1 or GW_A_1) and (not RLS_A)  # A locked from A|B@PB.normal to I
        N_L_A_2 = (L_A_2 or GW_A_2) and (not RLS_A)  # A locked from I to A|B@PB.normal
        N_F_A = (F_A or LK_R3 or LK_R8) and (not RLS_A)  # A firmly locked
        N_U_A = (U_A or NU_A_1 or NU_A_2) and (not RLS_A)  # A used by a train (R9)
        N_P_A = (P_A or (U_A and OCC_A and NU_B_1)) and (not RLS_A)  # A: the train went on (R9)
        N_D_A = (D_A or ((not VALID) and (L_A_1 or L_A_2))) and (not RLS_A)  # A: detection is not relied on, inputs were lost or a train is called on
        N_K_B = K_B and (not RLS_B)  # B: restart lock (R16)
        N_L_B_1 = (L_B_1 or GW_B_1) and (not RLS_B)  # B locked from A|B@PB.normal to B|C@PB.toe
        N_L_B_2 = (L_B_2 or GW_B_2) and (not RLS_B)  # B locked from B|C@PB.toe to A|B@PB.normal
        N_L_B_3 = (L_B_3 or GW_B_3) and (not RLS_B)  # B locked from B|C@PB.toe to B|G@PB.reverse
        N_F_B = (F_B or LK_R10 or LK_R3 or LK_R4) and (not RLS_B)  # B firmly locked
        N_U_B = (U_B or NU_B_1 or NU_B_2) and (not RLS_B)  # B used by a train (R9)
        N_P_B = (P_B or (U_B and OCC_B and (NU_A_1 or NU_C_1 or NU_G_1))) and (not RLS_B)  # B: the train went on (R9)
        N_D_B = (D_B or ((not VALID) and (L_B_1 or L_B_2 or L_B_3))) and (not RLS_B)  # B: detection is not relied on, inputs were lost or a train is called on
        N_K_C = K_C and (not RLS_C)  # C: restart lock (R16)
        N_L_C_1 = (L_C_1 or GW_C_1) and (not RLS_C)  # C locked from B|C@PB.toe to C|D@line.0
        N_L_C_2 = (L_C_2 or GW_C_2) and (not RLS_C)  # C locked from C|D@line.0 to B|C@PB.toe
        N_F_C = (F_C or LK_R10 or LK_R3 or LK_R4) and (not RLS_C)  # C firmly locked
        N_U_C = (U_C or NU_C_1 or NU_C_2) and (not RLS_C)  # C used by a train (R9)
        N_P_C = (P_C or (U_C and OCC_C and (NU_B_2 or NU_D_1))) and (not RLS_C)  # C: the train went on (R9)
        N_D_C = (D_C or ((not VALID) and (L_C_1 or L_C_2))) and (not RLS_C)  # C: detection is not relied on, inputs were lost or a train is called on
        N_K_D = K_D and (not RLS_D)  # D: restart lock (R16)
        N_L_D_1 = (L_D_1 or GW_D_1) and (not RLS_D)  # D locked from C|D@line.0 to D|E@PE.toe
        N_L_D_2 = (L_D_2 or GW_D_2) and (not RLS_D)  # D locked from D|E@PE.toe to C|D@line.0
        N_F_D = (F_D or LK_R1 or LK_R2 or LK_R5) and (not RLS_D)  # D firmly locked
        N_U_D = (U_D or NU_D_1 or NU_D_2) and (not RLS_D)  # D used by a train (R9)
        N_P_D = (P_D or (U_D and OCC_D and (NU_C_2 or NU_E_1))) and (not RLS_D)  # D: the train went on (R9)
        N_D_D = (D_D or ((not VALID) and (L_D_1 or L_D_2))) and (not RLS_D)  # D: detection is not relied on, inputs were lost or a train is called on
        N_K_E = K_E and (not RLS_E)  # E: restart lock (R16)
        N_L_E_1 = (L_E_1 or GW_E_1) and (not RLS_E)  # E locked from D|E@PE.toe to E|F@PE.normal
        N_L_E_2 = (L_E_2 or GW_E_2) and (not RLS_E)  # E locked from D|E@PE.toe to E|H@PE.reverse
        N_L_E_4 = (L_E_4 or GW_E_4) and (not RLS_E)  # E locked from E|H@PE.reverse to D|E@PE.toe
        N_F_E = (F_E or LK_R2 or LK_R1 or LK_R5) and (not RLS_E)  # E firmly locked
        N_U_E = (U_E or NU_E_1 or NU_E_3) and (not RLS_E)  # E used by a train (R9)
        N_P_E = (P_E or (U_E and OCC_E and (NU_D_2 or NU_F_1 or NU_H_1))) and (not RLS_E)  # E: the train went on (R9)
        N_D_E = (D_E or ((not VALID) and (L_E_1 or L_E_2 or L_E_4))) and (not RLS_E)  # E: detection is not relied on, inputs were lost or a train is called on
        N_K_F = K_F and (not RLS_F)  # F: restart lock (R16)
        N_L_F_1 = (L_F_1 or GW_F_1) and (not RLS_F)  # F locked from E|F@PE.normal to F|ap_II@two.0
        N_F_F = (F_F or LK_R2) and (not RLS_F)  # F firmly locked
        N_U_F = (U_F or NU_F_1) and (not RLS_F)  # F used by a train (R9)
        N_P_F = (P_F or (U_F and OCC_F and NU_ap_II_1)) and (not RLS_F)  # F: the train went on (R9)
        N_D_F = (D_F or ((not VALID) and L_F_1)) and (not RLS_F)  # F: detection is not relied on, inputs were lost or a train is called on
        N_K_G = K_G and (not RLS_G)  # G: restart lock (R16)
        N_L_G_1 = (L_G_1 or GW_G_1) and (not RLS_G)  # G locked from B|G@PB.reverse to G|ap_IV@four.0
        N_F_G = (F_G or LK_R4) and (not RLS_G)  # G firmly locked
        N_U_G = (U_G or NU_G_1) and (not RLS_G)  # G used by a train (R9)
        N_P_G = (P_G or (U_G and OCC_G and NU_ap_IV_1)) and (not RLS_G)  # G: the train went on (R9)
        N_D_G = (D_G or ((not VALID) and L_G_1)) and (not RLS_G)  # G: detection is not relied on, inputs were lost or a train is called on
        N_K_H = K_H and (not RLS_H)  # H: restart lock (R16)
        N_L_H_1 = (L_H_1 or GW_H_1) and (not RLS_H)  # H locked from E|H@PE.reverse to III
        N_L_H_2 = (L_H_2 or GW_H_2) and (not RLS_H)  # H locked from III to E|H@PE.reverse
        N_F_H = (F_H or LK_R1 or LK_R9) and (not RLS_H)  # H firmly locked
        N_U_H = (U_H or NU_H_1 or NU_H_2) and (not RLS_H)  # H used by a train (R9)
        N_P_H = (P_H or (U_H and OCC_H and NU_E_3)) and (not RLS_H)  # H: the train went on (R9)
        N_D_H = (D_H or ((not VALID) and (L_H_1 or L_H_2))) and (not RLS_H)  # H: detection is not relied on, inputs were lost or a train is called on
        N_K_ap_II = K_ap_II and (not RLS_ap_II)  # ap_II: restart lock (R16)
        N_L_ap_II_1 = (L_ap_II_1 or GW_ap_II_1) and (not RLS_ap_II)  # ap_II locked from F|ap_II@two.0 to II
        N_F_ap_II = (F_ap_II or LK_R6) and (not RLS_ap_II)  # ap_II firmly locked
        N_U_ap_II = (U_ap_II or NU_ap_II_1) and (not RLS_ap_II)  # ap_II used by a train (R9)
        N_P_ap_II = P_ap_II and (not RLS_ap_II)  # ap_II: the train went on (R9)
        N_D_ap_II = (D_ap_II or ((not VALID) and L_ap_II_1)) and (not RLS_ap_II)  # ap_II: detection is not relied on, inputs were lost or a train is called on
        N_K_ap_IV = K_ap_IV and (not RLS_ap_IV)  # ap_IV: restart lock (R16)
        N_L_ap_IV_1 = (L_ap_IV_1 or GW_ap_IV_1) and (not RLS_ap_IV)  # ap_IV locked from G|ap_IV@four.0 to IV
        N_F_ap_IV = (F_ap_IV or LK_R7) and (not RLS_ap_IV)  # ap_IV firmly locked
        N_U_ap_IV = (U_ap_IV or NU_ap_IV_1) and (not RLS_ap_IV)  # ap_IV used by a train (R9)
        N_P_ap_IV = P_ap_IV and (not RLS_ap_IV)  # ap_IV: the train went on (R9)
        N_D_ap_IV = (D_ap_IV or ((not VALID) and L_ap_IV_1)) and (not RLS_ap_IV)  # ap_IV: detection is not relied on, inputs were lost or a train is called on
        self.state = {
            'CN_PB': bool(N_CN_PB),
            'CR_PB': bool(N_CR_PB),
            'CN_PE': bool(N_CN_PE),
            'CR_PE': bool(N_CR_PE),
            'AL_PB': bool(N_AL_PB),
            'AL_PE': bool(N_AL_PE),
            'TH_PB': bool(N_TH_PB),
            'TR_PB': bool(N_TR_PB),
            'TH_PE': bool(N_TH_PE),
            'TR_PE': bool(N_TR_PE),
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
            'A_R5': bool(N_A_R5),
            'B_R5': bool(N_B_R5),
            'W_R5': bool(N_W_R5),
            'S_R5': bool(N_S_R5),
            'H_R5': bool(N_H_R5),
            'A_R6': bool(N_A_R6),
            'B_R6': bool(N_B_R6),
            'W_R6': bool(N_W_R6),
            'S_R6': bool(N_S_R6),
            'H_R6': bool(N_H_R6),
            'A_R7': bool(N_A_R7),
            'B_R7': bool(N_B_R7),
            'W_R7': bool(N_W_R7),
            'S_R7': bool(N_S_R7),
            'H_R7': bool(N_H_R7),
            'A_R8': bool(N_A_R8),
            'B_R8': bool(N_B_R8),
            'W_R8': bool(N_W_R8),
            'S_R8': bool(N_S_R8),
            'H_R8': bool(N_H_R8),
            'A_R9': bool(N_A_R9),
            'B_R9': bool(N_B_R9),
            'W_R9': bool(N_W_R9),
            'S_R9': bool(N_S_R9),
            'H_R9': bool(N_H_R9),
            'A_R10': bool(N_A_R10),
            'B_R10': bool(N_B_R10),
            'W_R10': bool(N_W_R10),
            'S_R10': bool(N_S_R10),
            'H_R10': bool(N_H_R10),
            'X_SC': bool(N_X_SC),
            'X_SD': bool(N_X_SD),
            'X_SE': bool(N_X_SE),
            'X_SF': bool(N_X_SF),
            'X_SG': bool(N_X_SG),
            'X_SI': bool(N_X_SI),
            'X_SIII': bool(N_X_SIII),
            'X_SV': bool(N_X_SV),
            'N_R2': bool(N_N_R2),
            'T_R2': bool(N_T_R2),
            'N_R4': bool(N_N_R4),
            'T_R4': bool(N_T_R4),
            'N_R5': bool(N_N_R5),
            'T_R5': bool(N_T_R5),
            'N_R6': bool(N_N_R6),
            'T_R6': bool(N_T_R6),
            'N_R7': bool(N_N_R7),
            'T_R7': bool(N_T_R7),
            'N_R8': bool(N_N_R8),
            'T_R8': bool(N_T_R8),
            'N_R9': bool(N_N_R9),
            'T_R9': bool(N_T_R9),
            'N_R10': bool(N_N_R10),
            'T_R10': bool(N_T_R10),
            'K_A': bool(N_K_A),
            'L_A_1': bool(N_L_A_1),
            'L_A_2': bool(N_L_A_2),
            'F_A': bool(N_F_A),
            'U_A': bool(N_U_A),
            'P_A': bool(N_P_A),
            'D_A': bool(N_D_A),
            'K_B': bool(N_K_B),
            'L_B_1': bool(N_L_B_1),
            'L_B_2': bool(N_L_B_2),
            'L_B_3': bool(N_L_B_3),
            'F_B': bool(N_F_B),
            'U_B': bool(N_U_B),
            'P_B': bool(N_P_B),
            'D_B': bool(N_D_B),
            'K_C': bool(N_K_C),
            'L_C_1': bool(N_L_C_1),
            'L_C_2': bool(N_L_C_2),
            'F_C': bool(N_F_C),
            'U_C': bool(N_U_C),
            'P_C': bool(N_P_C),
            'D_C': bool(N_D_C),
            'K_D': bool(N_K_D),
            'L_D_1': bool(N_L_D_1),
            'L_D_2': bool(N_L_D_2),
            'F_D': bool(N_F_D),
            'U_D': bool(N_U_D),
            'P_D': bool(N_P_D),
            'D_D': bool(N_D_D),
            'K_E': bool(N_K_E),
            'L_E_1': bool(N_L_E_1),
            'L_E_2': bool(N_L_E_2),
            'L_E_4': bool(N_L_E_4),
            'F_E': bool(N_F_E),
            'U_E': bool(N_U_E),
            'P_E': bool(N_P_E),
            'D_E': bool(N_D_E),
            'K_F': bool(N_K_F),
            'L_F_1': bool(N_L_F_1),
            'F_F': bool(N_F_F),
            'U_F': bool(N_U_F),
            'P_F': bool(N_P_F),
            'D_F': bool(N_D_F),
            'K_G': bool(N_K_G),
            'L_G_1': bool(N_L_G_1),
            'F_G': bool(N_F_G),
            'U_G': bool(N_U_G),
            'P_G': bool(N_P_G),
            'D_G': bool(N_D_G),
            'K_H': bool(N_K_H),
            'L_H_1': bool(N_L_H_1),
            'L_H_2': bool(N_L_H_2),
            'F_H': bool(N_F_H),
            'U_H': bool(N_U_H),
            'P_H': bool(N_P_H),
            'D_H': bool(N_D_H),
            'K_ap_II': bool(N_K_ap_II),
            'L_ap_II_1': bool(N_L_ap_II_1),
            'F_ap_II': bool(N_F_ap_II),
            'U_ap_II': bool(N_U_ap_II),
            'P_ap_II': bool(N_P_ap_II),
            'D_ap_II': bool(N_D_ap_II),
            'K_ap_IV': bool(N_K_ap_IV),
            'L_ap_IV_1': bool(N_L_ap_IV_1),
            'F_ap_IV': bool(N_F_ap_IV),
            'U_ap_IV': bool(N_U_ap_IV),
            'P_ap_IV': bool(N_P_ap_IV),
            'D_ap_IV': bool(N_D_ap_IV),
        }
        CN_PB = self.state['CN_PB']
        CR_PB = self.state['CR_PB']
        CN_PE = self.state['CN_PE']
        CR_PE = self.state['CR_PE']
        AL_PB = self.state['AL_PB']
        AL_PE = self.state['AL_PE']
        TH_PB = self.state['TH_PB']
        TR_PB = self.state['TR_PB']
        TH_PE = self.state['TH_PE']
        TR_PE = self.state['TR_PE']
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
        A_R5 = self.state['A_R5']
        B_R5 = self.state['B_R5']
        W_R5 = self.state['W_R5']
        S_R5 = self.state['S_R5']
        H_R5 = self.state['H_R5']
        A_R6 = self.state['A_R6']
        B_R6 = self.state['B_R6']
        W_R6 = self.state['W_R6']
        S_R6 = self.state['S_R6']
        H_R6 = self.state['H_R6']
        A_R7 = self.state['A_R7']
        B_R7 = self.state['B_R7']
        W_R7 = self.state['W_R7']
        S_R7 = self.state['S_R7']
        H_R7 = self.state['H_R7']
        A_R8 = self.state['A_R8']
        B_R8 = self.state['B_R8']
        W_R8 = self.state['W_R8']
        S_R8 = self.state['S_R8']
        H_R8 = self.state['H_R8']
        A_R9 = self.state['A_R9']
        B_R9 = self.state['B_R9']
        W_R9 = self.state['W_R9']
        S_R9 = self.state['S_R9']
        H_R9 = self.state['H_R9']
        A_R10 = self.state['A_R10']
        B_R10 = self.state['B_R10']
        W_R10 = self.state['W_R10']
        S_R10 = self.state['S_R10']
        H_R10 = self.state['H_R10']
        X_SC = self.state['X_SC']
        X_SD = self.state['X_SD']
        X_SE = self.state['X_SE']
        X_SF = self.state['X_SF']
        X_SG = self.state['X_SG']
        X_SI = self.state['X_SI']
        X_SIII = self.state['X_SIII']
        X_SV = self.state['X_SV']
        N_R2 = self.state['N_R2']
        T_R2 = self.state['T_R2']
        N_R4 = self.state['N_R4']
        T_R4 = self.state['T_R4']
        N_R5 = self.state['N_R5']
        T_R5 = self.state['T_R5']
        N_R6 = self.state['N_R6']
        T_R6 = self.state['T_R6']
        N_R7 = self.state['N_R7']
        T_R7 = self.state['T_R7']
        N_R8 = self.state['N_R8']
        T_R8 = self.state['T_R8']
        N_R9 = self.state['N_R9']
        T_R9 = self.state['T_R9']
        N_R10 = self.state['N_R10']
        T_R10 = self.state['T_R10']
        K_A = self.state['K_A']
        L_A_1 = self.state['L_A_1']
        L_A_2 = self.state['L_A_2']
        F_A = self.state['F_A']
        U_A = self.state['U_A']
        P_A = self.state['P_A']
        D_A = self.state['D_A']
        K_B = self.state['K_B']
        L_B_1 = self.state['L_B_1']
        L_B_2 = self.state['L_B_2']
        L_B_3 = self.state['L_B_3']
        F_B = self.state['F_B']
        U_B = self.state['U_B']
        P_B = self.state['P_B']
        D_B = self.state['D_B']
        K_C = self.state['K_C']
        L_C_1 = self.state['L_C_1']
        L_C_2 = self.state['L_C_2']
        F_C = self.state['F_C']
        U_C = self.state['U_C']
        P_C = self.state['P_C']
        D_C = self.state['D_C']
        K_D = self.state['K_D']
        L_D_1 = self.state['L_D_1']
        L_D_2 = self.state['L_D_2']
        F_D = self.state['F_D']
        U_D = self.state['U_D']
        P_D = self.state['P_D']
        D_D = self.state['D_D']
        K_E = self.state['K_E']
        L_E_1 = self.state['L_E_1']
        L_E_2 = self.state['L_E_2']
        L_E_4 = self.state['L_E_4']
        F_E = self.state['F_E']
        U_E = self.state['U_E']
        P_E = self.state['P_E']
        D_E = self.state['D_E']
        K_F = self.state['K_F']
        L_F_1 = self.state['L_F_1']
        F_F = self.state['F_F']
        U_F = self.state['U_F']
        P_F = self.state['P_F']
        D_F = self.state['D_F']
        K_G = self.state['K_G']
        L_G_1 = self.state['L_G_1']
        F_G = self.state['F_G']
        U_G = self.state['U_G']
        P_G = self.state['P_G']
        D_G = self.state['D_G']
        K_H = self.state['K_H']
        L_H_1 = self.state['L_H_1']
        L_H_2 = self.state['L_H_2']
        F_H = self.state['F_H']
        U_H = self.state['U_H']
        P_H = self.state['P_H']
        D_H = self.state['D_H']
        K_ap_II = self.state['K_ap_II']
        L_ap_II_1 = self.state['L_ap_II_1']
        F_ap_II = self.state['F_ap_II']
        U_ap_II = self.state['U_ap_II']
        P_ap_II = self.state['P_ap_II']
        D_ap_II = self.state['D_ap_II']
        K_ap_IV = self.state['K_ap_IV']
        L_ap_IV_1 = self.state['L_ap_IV_1']
        F_ap_IV = self.state['F_ap_IV']
        U_ap_IV = self.state['U_ap_IV']
        P_ap_IV = self.state['P_ap_IV']
        D_ap_IV = self.state['D_ap_IV']
        return {
            'YN_PB': bool(CN_PB),
            'YR_PB': bool(CR_PB),
            'YN_PE': bool(CN_PE),
            'YR_PE': bool(CR_PE),
            'YA_PB': bool(AL_PB),
            'YA_PE': bool(AL_PE),
            'YT_PB': bool(TR_PB),
            'YT_PE': bool(TR_PE),
            'YL_A': bool(K_A or L_A_1 or L_A_2),
            'YL_B': bool(K_B or L_B_1 or L_B_2 or L_B_3),
            'YL_C': bool(K_C or L_C_1 or L_C_2),
            'YL_D': bool(K_D or L_D_1 or L_D_2),
            'YL_E': bool(K_E or L_E_1 or L_E_2 or L_E_4),
            'YL_F': bool(K_F or L_F_1),
            'YL_G': bool(K_G or L_G_1),
            'YL_H': bool(K_H or L_H_1 or L_H_2),
            'YL_ap_II': bool(K_ap_II or L_ap_II_1),
            'YL_ap_IV': bool(K_ap_IV or L_ap_IV_1),
            'YP_SC': bool(S_R1 or S_R2),
            'YS_SC': bool((not (S_R1 or S_R2))),
            'YP_SD': bool(S_R3 or S_R4),
            'YS_SD': bool((not (S_R3 or S_R4))),
            'YP_SE': bool(S_R5),
            'YS_SE': bool((not S_R5)),
            'YP_SF': bool(S_R6),
            'YS_SF': bool((not S_R6)),
            'YP_SG': bool(S_R7),
            'YS_SG': bool((not S_R7)),
            'YP_SI': bool(S_R8),
            'YS_SI': bool((not S_R8)),
            'YP_SIII': bool(S_R9),
            'YS_SIII': bool((not S_R9)),
            'YP_SV': bool(S_R10),
            'YS_SV': bool((not S_R10)),
        }
