# Interlocking passing_loop, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout c1587e4fd30475cf820a1df78f6f80d45f552b7a9270cd7265778147239f3ce7
# claims 175fd49f3314a02e2a7b2b5b375eaf67e58dcbc177c6603996b90f3dad17d095
"""Interlocking passing_loop: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_S': (0, 2),  # operator: cancel the route from S
    'CAN_S1': (0, 2),  # operator: cancel the route from S1
    'CAN_S3': (0, 2),  # operator: cancel the route from S3
    'CAN_X': (0, 2),  # operator: cancel the route from X
    'CAN_X1': (0, 2),  # operator: cancel the route from X1
    'CAN_X3': (0, 2),  # operator: cancel the route from X3
    'E_BF_E': (0, 2),  # external condition BF/E: block towards E free, direction ours
    'REQ': (0, 13),  # operator: set route number, 0 = none
    'CLR_1DG': (0, 2),  # section 1DG reported clear
    'CLR_2DG': (0, 2),  # section 2DG reported clear
    'CLR_3G': (0, 2),  # section 3G reported clear
    'CLR_IAG': (0, 2),  # section IAG reported clear
    'CLR_IG': (0, 2),  # section IG reported clear
    'CLR_IIAG': (0, 2),  # section IIAG reported clear
    'CLR_SJG': (0, 2),  # section SJG reported clear
    'CLR_XJG': (0, 2),  # section XJG reported clear
    'REL_1DG': (0, 2),  # operator: release section 1DG (hold until released)
    'REL_2DG': (0, 2),  # operator: release section 2DG (hold until released)
    'REL_3G': (0, 2),  # operator: release section 3G (hold until released)
    'REL_IAG': (0, 2),  # operator: release section IAG (hold until released)
    'REL_IG': (0, 2),  # operator: release section IG (hold until released)
    'REL_IIAG': (0, 2),  # operator: release section IIAG (hold until released)
    'BLK_1DG': (1, 2),  # operator: section 1DG is blocked
    'BLK_2DG': (1, 2),  # operator: section 2DG is blocked
    'BLK_3G': (1, 2),  # operator: section 3G is blocked
    'BLK_IAG': (1, 2),  # operator: section IAG is blocked
    'BLK_IG': (1, 2),  # operator: section IG is blocked
    'BLK_IIAG': (1, 2),  # operator: section IIAG is blocked
    'RELALL': (0, 2),  # operator: release all clear sections after a restart
    'DN_1': (0, 2),  # machine 1 detected normal
    'DR_1': (0, 2),  # machine 1 detected reverse
    'MN_1': (0, 2),  # operator: move machine 1 normal
    'MR_1': (0, 2),  # operator: move machine 1 reverse
    'TC_1': (0, 2),  # operator: machine 1 has been looked at after it was trailed
    'DN_2': (0, 2),  # machine 2 detected normal
    'DR_2': (0, 2),  # machine 2 detected reverse
    'MN_2': (0, 2),  # operator: move machine 2 normal
    'MR_2': (0, 2),  # operator: move machine 2 reverse
    'TC_2': (0, 2),  # operator: machine 2 has been looked at after it was trailed
    'NR_W': (0, 2),  # neighbour at W asks for the direction
    'NG_W': (0, 2),  # neighbour at W gives the direction
    'NN_W': (0, 2),  # neighbour at W does not give the direction
    'NH_W': (0, 2),  # neighbour at W has the direction
    'LC_W': (0, 2),  # the whole line beyond W reported clear
    'TKN_W': (0, 2),  # operator: take the direction at W (agreed by telephone; hold)
}
# name: value at a restart, meaning
STATE = {
    'CN_1': False,  # machine 1 commanded N
    'CR_1': False,  # machine 1 commanded R
    'CN_2': False,  # machine 2 commanded N
    'CR_2': False,  # machine 2 commanded R
    'AL_1': False,  # alarm: machine 1 not detected
    'AL_2': False,  # alarm: machine 2 not detected
    'TH_1': False,  # machine 1 was detected where it is commanded
    'TR_1': False,  # machine 1 was trailed
    'TH_2': False,  # machine 2 was detected where it is commanded
    'TR_2': False,  # machine 2 was trailed
    'A_R1': False,  # route S-S1 active
    'B_R1': False,  # route S-S1 locked
    'W_R1': False,  # route S-S1: proceed wanted
    'S_R1': False,  # route S-S1: proceed
    'H_R1': False,  # route S-S1: signal has been open
    'A_R2': False,  # route S-S3 active
    'B_R2': False,  # route S-S3 locked
    'W_R2': False,  # route S-S3: proceed wanted
    'S_R2': False,  # route S-S3: proceed
    'H_R2': False,  # route S-S3: signal has been open
    'A_R3': False,  # route S-S1.c active
    'B_R3': False,  # route S-S1.c locked
    'W_R3': False,  # route S-S1.c: proceed wanted
    'S_R3': False,  # route S-S1.c: proceed
    'H_R3': False,  # route S-S1.c: signal has been open
    'A_R4': False,  # route S-S3.c active
    'B_R4': False,  # route S-S3.c locked
    'W_R4': False,  # route S-S3.c: proceed wanted
    'S_R4': False,  # route S-S3.c: proceed
    'H_R4': False,  # route S-S3.c: signal has been open
    'A_R5': False,  # route S1-W active
    'B_R5': False,  # route S1-W locked
    'W_R5': False,  # route S1-W: proceed wanted
    'S_R5': False,  # route S1-W: proceed
    'H_R5': False,  # route S1-W: signal has been open
    'A_R6': False,  # route S3-W active
    'B_R6': False,  # route S3-W locked
    'W_R6': False,  # route S3-W: proceed wanted
    'S_R6': False,  # route S3-W: proceed
    'H_R6': False,  # route S3-W: signal has been open
    'A_R7': False,  # route X-X1 active
    'B_R7': False,  # route X-X1 locked
    'W_R7': False,  # route X-X1: proceed wanted
    'S_R7': False,  # route X-X1: proceed
    'H_R7': False,  # route X-X1: signal has been open
    'A_R8': False,  # route X-X3 active
    'B_R8': False,  # route X-X3 locked
    'W_R8': False,  # route X-X3: proceed wanted
    'S_R8': False,  # route X-X3: proceed
    'H_R8': False,  # route X-X3: signal has been open
    'A_R9': False,  # route X-X1.c active
    'B_R9': False,  # route X-X1.c locked
    'W_R9': False,  # route X-X1.c: proceed wanted
    'S_R9': False,  # route X-X1.c: proceed
    'H_R9': False,  # route X-X1.c: signal has been open
    'A_R10': False,  # route X-X3.c active
    'B_R10': False,  # route X-X3.c locked
    'W_R10': False,  # route X-X3.c: proceed wanted
    'S_R10': False,  # route X-X3.c: proceed
    'H_R10': False,  # route X-X3.c: signal has been open
    'A_R11': False,  # route X1-E active
    'B_R11': False,  # route X1-E locked
    'W_R11': False,  # route X1-E: proceed wanted
    'S_R11': False,  # route X1-E: proceed
    'H_R11': False,  # route X1-E: signal has been open
    'A_R12': False,  # route X3-E active
    'B_R12': False,  # route X3-E locked
    'W_R12': False,  # route X3-E: proceed wanted
    'S_R12': False,  # route X3-E: proceed
    'H_R12': False,  # route X3-E: signal has been open
    'X_S': False,  # S: cancelling
    'X_S1': False,  # S1: cancelling
    'X_S3': False,  # S3: cancelling
    'X_X': False,  # X: cancelling
    'X_X1': False,  # X1: cancelling
    'X_X3': False,  # X3: cancelling
    'K_1DG': True,  # 1DG: restart lock (R16)
    'L_1DG_1': False,  # 1DG locked from 1DG|3G@1.reverse to 1DG|IAG@1.toe
    'L_1DG_2': False,  # 1DG locked from 1DG|IAG@1.toe to 1DG|3G@1.reverse
    'L_1DG_3': False,  # 1DG locked from 1DG|IAG@1.toe to 1DG|IG@1.normal
    'L_1DG_4': False,  # 1DG locked from 1DG|IG@1.normal to 1DG|IAG@1.toe
    'F_1DG': False,  # 1DG firmly locked
    'U_1DG': True,  # 1DG used by a train (R9)
    'P_1DG': False,  # 1DG: the train went on (R9)
    'D_1DG': False,  # 1DG: detection is not relied on, inputs were lost or a train is called on
    'K_2DG': True,  # 2DG: restart lock (R16)
    'L_2DG_1': False,  # 2DG locked from 2DG|3G@2.reverse to 2DG|IIAG@2.toe
    'L_2DG_2': False,  # 2DG locked from 2DG|IG@2.normal to 2DG|IIAG@2.toe
    'L_2DG_3': False,  # 2DG locked from 2DG|IIAG@2.toe to 2DG|3G@2.reverse
    'L_2DG_4': False,  # 2DG locked from 2DG|IIAG@2.toe to 2DG|IG@2.normal
    'F_2DG': False,  # 2DG firmly locked
    'U_2DG': True,  # 2DG used by a train (R9)
    'P_2DG': False,  # 2DG: the train went on (R9)
    'D_2DG': False,  # 2DG: detection is not relied on, inputs were lost or a train is called on
    'K_3G': True,  # 3G: restart lock (R16)
    'L_3G_1': False,  # 3G locked from 1DG|3G@1.reverse to 2DG|3G@2.reverse
    'L_3G_2': False,  # 3G locked from 2DG|3G@2.reverse to 1DG|3G@1.reverse
    'F_3G': False,  # 3G firmly locked
    'U_3G': True,  # 3G used by a train (R9)
    'P_3G': False,  # 3G: the train went on (R9)
    'D_3G': False,  # 3G: detection is not relied on, inputs were lost or a train is called on
    'K_IAG': True,  # IAG: restart lock (R16)
    'L_IAG_1': False,  # IAG locked from 1DG|IAG@1.toe to W
    'L_IAG_2': False,  # IAG locked from W to 1DG|IAG@1.toe
    'F_IAG': False,  # IAG firmly locked
    'U_IAG': True,  # IAG used by a train (R9)
    'P_IAG': False,  # IAG: the train went on (R9)
    'D_IAG': False,  # IAG: detection is not relied on, inputs were lost or a train is called on
    'K_IG': True,  # IG: restart lock (R16)
    'L_IG_1': False,  # IG locked from 1DG|IG@1.normal to 2DG|IG@2.normal
    'L_IG_2': False,  # IG locked from 2DG|IG@2.normal to 1DG|IG@1.normal
    'F_IG': False,  # IG firmly locked
    'U_IG': True,  # IG used by a train (R9)
    'P_IG': False,  # IG: the train went on (R9)
    'D_IG': False,  # IG: detection is not relied on, inputs were lost or a train is called on
    'K_IIAG': True,  # IIAG: restart lock (R16)
    'L_IIAG_1': False,  # IIAG locked from 2DG|IIAG@2.toe to E
    'L_IIAG_2': False,  # IIAG locked from E to 2DG|IIAG@2.toe
    'F_IIAG': False,  # IIAG firmly locked
    'U_IIAG': True,  # IIAG used by a train (R9)
    'P_IIAG': False,  # IIAG: the train went on (R9)
    'D_IIAG': False,  # IIAG: detection is not relied on, inputs were lost or a train is called on
    'BH_W': False,  # the direction at W is ours
    'BG_W': False,  # the direction at W is given
    'BY_W': False,  # the direction at W is not given
    'BN_W': False,  # the neighbour at W told that he does not give the direction
    'C_S': False,  # S shows clear
    'C_S1': False,  # S1 shows clear
    'C_S3': False,  # S3 shows clear
    'C_X': False,  # X shows clear
    'C_X1': False,  # X1 shows clear
    'C_X3': False,  # X3 shows clear
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_S': 180000,  # S: approach locking delay (R8)
    'AT_S1': 180000,  # S1: approach locking delay (R8)
    'AT_S3': 180000,  # S3: approach locking delay (R8)
    'AT_X': 180000,  # X: approach locking delay (R8)
    'AT_X1': 180000,  # X1: approach locking delay (R8)
    'AT_X3': 180000,  # X3: approach locking delay (R8)
    'RT_1DG': 3000,  # 1DG: release delay (R9)
    'RT_2DG': 3000,  # 2DG: release delay (R9)
    'RT_3G': 3000,  # 3G: release delay (R9)
    'RT_IAG': 3000,  # IAG: release delay (R9)
    'RT_IG': 3000,  # IG: release delay (R9)
    'RT_IIAG': 3000,  # IIAG: release delay (R9)
    'BT_W': 60000,  # W: special manual change (R12)
    'ST_1': 13000,  # machine 1: time-out
    'ST_2': 13000,  # machine 2: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_1': False,  # machine 1: normal
    'YR_1': False,  # machine 1: reverse
    'YN_2': False,  # machine 2: normal
    'YR_2': False,  # machine 2: reverse
    'YA_1': False,  # alarm: machine 1 not detected in time
    'YA_2': False,  # alarm: machine 2 not detected in time
    'YT_1': False,  # alarm: machine 1 was trailed
    'YT_2': False,  # alarm: machine 2 was trailed
    'YL_1DG': True,  # indication: 1DG is locked
    'YL_2DG': True,  # indication: 2DG is locked
    'YL_3G': True,  # indication: 3G is locked
    'YL_IAG': True,  # indication: IAG is locked
    'YL_IG': True,  # indication: IG is locked
    'YL_IIAG': True,  # indication: IIAG is locked
    'YTA_W': False,  # to the neighbour at W: direction asked for
    'YTG_W': False,  # to the neighbour at W: direction given
    'YTN_W': False,  # to the neighbour at W: direction not given
    'YTH_W': False,  # to the neighbour at W: direction is here
    'YP_S': False,  # signal S: clear (green)
    'YY_S': False,  # signal S: caution (yellow)
    'YO_S': False,  # signal S: call-on, beside stop
    'YS_S': True,  # signal S: stop
    'YP_S1': False,  # signal S1: clear (green)
    'YY_S1': False,  # signal S1: caution (yellow)
    'YS_S1': True,  # signal S1: stop
    'YP_S3': False,  # signal S3: clear (green)
    'YY_S3': False,  # signal S3: caution (yellow)
    'YS_S3': True,  # signal S3: stop
    'YP_X': False,  # signal X: clear (green)
    'YY_X': False,  # signal X: caution (yellow)
    'YO_X': False,  # signal X: call-on, beside stop
    'YS_X': True,  # signal X: stop
    'YP_X1': False,  # signal X1: clear (green)
    'YY_X1': False,  # signal X1: caution (yellow)
    'YS_X1': True,  # signal X1: stop
    'YP_X3': False,  # signal X3: clear (green)
    'YY_X3': False,  # signal X3: caution (yellow)
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
        CAN_S = read['CAN_S']
        CAN_S1 = read['CAN_S1']
        CAN_S3 = read['CAN_S3']
        CAN_X = read['CAN_X']
        CAN_X1 = read['CAN_X1']
        CAN_X3 = read['CAN_X3']
        E_BF_E = read['E_BF_E']
        REQ = read['REQ']
        CLR_1DG = read['CLR_1DG']
        CLR_2DG = read['CLR_2DG']
        CLR_3G = read['CLR_3G']
        CLR_IAG = read['CLR_IAG']
        CLR_IG = read['CLR_IG']
        CLR_IIAG = read['CLR_IIAG']
        CLR_SJG = read['CLR_SJG']
        CLR_XJG = read['CLR_XJG']
        REL_1DG = read['REL_1DG']
        REL_2DG = read['REL_2DG']
        REL_3G = read['REL_3G']
        REL_IAG = read['REL_IAG']
        REL_IG = read['REL_IG']
        REL_IIAG = read['REL_IIAG']
        BLK_1DG = read['BLK_1DG']
        BLK_2DG = read['BLK_2DG']
        BLK_3G = read['BLK_3G']
        BLK_IAG = read['BLK_IAG']
        BLK_IG = read['BLK_IG']
        BLK_IIAG = read['BLK_IIAG']
        RELALL = read['RELALL']
        DN_1 = read['DN_1']
        DR_1 = read['DR_1']
        MN_1 = read['MN_1']
        MR_1 = read['MR_1']
        TC_1 = read['TC_1']
        DN_2 = read['DN_2']
        DR_2 = read['DR_2']
        MN_2 = read['MN_2']
        MR_2 = read['MR_2']
        TC_2 = read['TC_2']
        NR_W = read['NR_W']
        NG_W = read['NG_W']
        NN_W = read['NN_W']
        NH_W = read['NH_W']
        LC_W = read['LC_W']
        TKN_W = read['TKN_W']
        CN_1 = old['CN_1']
        CR_1 = old['CR_1']
        CN_2 = old['CN_2']
        CR_2 = old['CR_2']
        AL_1 = old['AL_1']
        AL_2 = old['AL_2']
        TH_1 = old['TH_1']
        TR_1 = old['TR_1']
        TH_2 = old['TH_2']
        TR_2 = old['TR_2']
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
        A_R11 = old['A_R11']
        B_R11 = old['B_R11']
        W_R11 = old['W_R11']
        S_R11 = old['S_R11']
        H_R11 = old['H_R11']
        A_R12 = old['A_R12']
        B_R12 = old['B_R12']
        W_R12 = old['W_R12']
        S_R12 = old['S_R12']
        H_R12 = old['H_R12']
        X_S = old['X_S']
        X_S1 = old['X_S1']
        X_S3 = old['X_S3']
        X_X = old['X_X']
        X_X1 = old['X_X1']
        X_X3 = old['X_X3']
        K_1DG = old['K_1DG']
        L_1DG_1 = old['L_1DG_1']
        L_1DG_2 = old['L_1DG_2']
        L_1DG_3 = old['L_1DG_3']
        L_1DG_4 = old['L_1DG_4']
        F_1DG = old['F_1DG']
        U_1DG = old['U_1DG']
        P_1DG = old['P_1DG']
        D_1DG = old['D_1DG']
        K_2DG = old['K_2DG']
        L_2DG_1 = old['L_2DG_1']
        L_2DG_2 = old['L_2DG_2']
        L_2DG_3 = old['L_2DG_3']
        L_2DG_4 = old['L_2DG_4']
        F_2DG = old['F_2DG']
        U_2DG = old['U_2DG']
        P_2DG = old['P_2DG']
        D_2DG = old['D_2DG']
        K_3G = old['K_3G']
        L_3G_1 = old['L_3G_1']
        L_3G_2 = old['L_3G_2']
        F_3G = old['F_3G']
        U_3G = old['U_3G']
        P_3G = old['P_3G']
        D_3G = old['D_3G']
        K_IAG = old['K_IAG']
        L_IAG_1 = old['L_IAG_1']
        L_IAG_2 = old['L_IAG_2']
        F_IAG = old['F_IAG']
        U_IAG = old['U_IAG']
        P_IAG = old['P_IAG']
        D_IAG = old['D_IAG']
        K_IG = old['K_IG']
        L_IG_1 = old['L_IG_1']
        L_IG_2 = old['L_IG_2']
        F_IG = old['F_IG']
        U_IG = old['U_IG']
        P_IG = old['P_IG']
        D_IG = old['D_IG']
        K_IIAG = old['K_IIAG']
        L_IIAG_1 = old['L_IIAG_1']
        L_IIAG_2 = old['L_IIAG_2']
        F_IIAG = old['F_IIAG']
        U_IIAG = old['U_IIAG']
        P_IIAG = old['P_IIAG']
        D_IIAG = old['D_IIAG']
        BH_W = old['BH_W']
        BG_W = old['BG_W']
        BY_W = old['BY_W']
        BN_W = old['BN_W']
        C_S = old['C_S']
        C_S1 = old['C_S1']
        C_S3 = old['C_S3']
        C_X = old['C_X']
        C_X1 = old['C_X1']
        C_X3 = old['C_X3']
        OCC_1DG = (not CLR_1DG) or (not VALID)  # 1DG counts as occupied
        OCC_2DG = (not CLR_2DG) or (not VALID)  # 2DG counts as occupied
        OCC_3G = (not CLR_3G) or (not VALID)  # 3G counts as occupied
        OCC_IAG = (not CLR_IAG) or (not VALID)  # IAG counts as occupied
        OCC_IG = (not CLR_IG) or (not VALID)  # IG counts as occupied
        OCC_IIAG = (not CLR_IIAG) or (not VALID)  # IIAG counts as occupied
        OCC_SJG = (not CLR_SJG) or (not VALID)  # SJG counts as occupied
        OCC_XJG = (not CLR_XJG) or (not VALID)  # XJG counts as occupied
        FREE_1DG = (not K_1DG) and (not L_1DG_1) and (not L_1DG_2) and (not L_1DG_3) and (not L_1DG_4)  # 1DG is not locked by anybody
        FREE_2DG = (not K_2DG) and (not L_2DG_1) and (not L_2DG_2) and (not L_2DG_3) and (not L_2DG_4)  # 2DG is not locked by anybody
        FREE_3G = (not K_3G) and (not L_3G_1) and (not L_3G_2)  # 3G is not locked by anybody
        FREE_IAG = (not K_IAG) and (not L_IAG_1) and (not L_IAG_2)  # IAG is not locked by anybody
        FREE_IG = (not K_IG) and (not L_IG_1) and (not L_IG_2)  # IG is not locked by anybody
        FREE_IIAG = (not K_IIAG) and (not L_IIAG_1) and (not L_IIAG_2)  # IIAG is not locked by anybody
        QN_1 = VALID and DN_1 and (not DR_1)  # machine 1 lies N (R10)
        QR_1 = VALID and DR_1 and (not DN_1)  # machine 1 lies R (R10)
        QN_2 = VALID and DN_2 and (not DR_2)  # machine 2 lies N (R10)
        QR_2 = VALID and DR_2 and (not DN_2)  # machine 2 lies R (R10)
        MOV_1 = VALID and FREE_1DG and (not OCC_1DG) and True and True  # machine 1 is free to move (R10)
        AVN_1 = CN_1 or MOV_1 or (QN_1 and (not CN_1) and (not CR_1))  # machine 1 can be demanded N
        AVR_1 = CR_1 or MOV_1 or (QR_1 and (not CN_1) and (not CR_1))  # machine 1 can be demanded R
        MOV_2 = VALID and FREE_2DG and (not OCC_2DG) and True and True  # machine 2 is free to move (R10)
        AVN_2 = CN_2 or MOV_2 or (QN_2 and (not CN_2) and (not CR_2))  # machine 2 can be demanded N
        AVR_2 = CR_2 or MOV_2 or (QR_2 and (not CN_2) and (not CR_2))  # machine 2 can be demanded R
        WA_1DG_1 = AVR_1 and (not TR_1)  # 1DG from 1DG|3G@1.reverse to 1DG|IAG@1.toe: could be locked
        WF_1DG_1 = FREE_1DG and (not OCC_1DG) and (not BLK_1DG) and WA_1DG_1  # 1DG from 1DG|3G@1.reverse to 1DG|IAG@1.toe: free for a route (R6)
        WA_1DG_2 = AVR_1 and (not TR_1)  # 1DG from 1DG|IAG@1.toe to 1DG|3G@1.reverse: could be locked
        WF_1DG_2 = FREE_1DG and (not OCC_1DG) and (not BLK_1DG) and WA_1DG_2  # 1DG from 1DG|IAG@1.toe to 1DG|3G@1.reverse: free for a route (R6)
        WA_1DG_3 = AVN_1 and (not TR_1)  # 1DG from 1DG|IAG@1.toe to 1DG|IG@1.normal: could be locked
        WF_1DG_3 = FREE_1DG and (not OCC_1DG) and (not BLK_1DG) and WA_1DG_3  # 1DG from 1DG|IAG@1.toe to 1DG|IG@1.normal: free for a route (R6)
        WA_1DG_4 = AVN_1 and (not TR_1)  # 1DG from 1DG|IG@1.normal to 1DG|IAG@1.toe: could be locked
        WF_1DG_4 = FREE_1DG and (not OCC_1DG) and (not BLK_1DG) and WA_1DG_4  # 1DG from 1DG|IG@1.normal to 1DG|IAG@1.toe: free for a route (R6)
        WA_2DG_1 = AVR_2 and (not TR_2)  # 2DG from 2DG|3G@2.reverse to 2DG|IIAG@2.toe: could be locked
        WF_2DG_1 = FREE_2DG and (not OCC_2DG) and (not BLK_2DG) and WA_2DG_1  # 2DG from 2DG|3G@2.reverse to 2DG|IIAG@2.toe: free for a route (R6)
        WA_2DG_2 = AVN_2 and (not TR_2)  # 2DG from 2DG|IG@2.normal to 2DG|IIAG@2.toe: could be locked
        WF_2DG_2 = FREE_2DG and (not OCC_2DG) and (not BLK_2DG) and WA_2DG_2  # 2DG from 2DG|IG@2.normal to 2DG|IIAG@2.toe: free for a route (R6)
        WA_2DG_3 = AVR_2 and (not TR_2)  # 2DG from 2DG|IIAG@2.toe to 2DG|3G@2.reverse: could be locked
        WF_2DG_3 = FREE_2DG and (not OCC_2DG) and (not BLK_2DG) and WA_2DG_3  # 2DG from 2DG|IIAG@2.toe to 2DG|3G@2.reverse: free for a route (R6)
        WA_2DG_4 = AVN_2 and (not TR_2)  # 2DG from 2DG|IIAG@2.toe to 2DG|IG@2.normal: could be locked
        WF_2DG_4 = FREE_2DG and (not OCC_2DG) and (not BLK_2DG) and WA_2DG_4  # 2DG from 2DG|IIAG@2.toe to 2DG|IG@2.normal: free for a route (R6)
        WF_3G_1 = FREE_3G and (not OCC_3G) and (not BLK_3G)  # 3G from 1DG|3G@1.reverse to 2DG|3G@2.reverse: free for a route (R6)
        WF_3G_2 = FREE_3G and (not OCC_3G) and (not BLK_3G)  # 3G from 2DG|3G@2.reverse to 1DG|3G@1.reverse: free for a route (R6)
        WF_IAG_1 = FREE_IAG and (not OCC_IAG) and (not BLK_IAG)  # IAG from 1DG|IAG@1.toe to W: free for a route (R6)
        WF_IAG_2 = FREE_IAG and (not OCC_IAG) and (not BLK_IAG)  # IAG from W to 1DG|IAG@1.toe: free for a route (R6)
        WF_IG_1 = FREE_IG and (not OCC_IG) and (not BLK_IG)  # IG from 1DG|IG@1.normal to 2DG|IG@2.normal: free for a route (R6)
        WF_IG_2 = FREE_IG and (not OCC_IG) and (not BLK_IG)  # IG from 2DG|IG@2.normal to 1DG|IG@1.normal: free for a route (R6)
        WF_IIAG_1 = FREE_IIAG and (not OCC_IIAG) and (not BLK_IIAG)  # IIAG from 2DG|IIAG@2.toe to E: free for a route (R6)
        WF_IIAG_2 = FREE_IIAG and (not OCC_IIAG) and (not BLK_IIAG)  # IIAG from E to 2DG|IIAG@2.toe: free for a route (R6)
        WD_1DG_1 = QR_1 and (not TR_1)  # 1DG from 1DG|3G@1.reverse to 1DG|IAG@1.toe: its points lie, nothing is foul of it
        WL_1DG_1 = (not OCC_1DG) and WD_1DG_1  # 1DG from 1DG|3G@1.reverse to 1DG|IAG@1.toe: lies and is clear
        WP_1DG_1 = WL_1DG_1 and (not BLK_1DG)  # 1DG from 1DG|3G@1.reverse to 1DG|IAG@1.toe: proceed may be shown over it (R3)
        WD_1DG_2 = QR_1 and (not TR_1)  # 1DG from 1DG|IAG@1.toe to 1DG|3G@1.reverse: its points lie, nothing is foul of it
        WL_1DG_2 = (not OCC_1DG) and WD_1DG_2  # 1DG from 1DG|IAG@1.toe to 1DG|3G@1.reverse: lies and is clear
        WP_1DG_2 = WL_1DG_2 and (not BLK_1DG)  # 1DG from 1DG|IAG@1.toe to 1DG|3G@1.reverse: proceed may be shown over it (R3)
        WD_1DG_3 = QN_1 and (not TR_1)  # 1DG from 1DG|IAG@1.toe to 1DG|IG@1.normal: its points lie, nothing is foul of it
        WL_1DG_3 = (not OCC_1DG) and WD_1DG_3  # 1DG from 1DG|IAG@1.toe to 1DG|IG@1.normal: lies and is clear
        WP_1DG_3 = WL_1DG_3 and (not BLK_1DG)  # 1DG from 1DG|IAG@1.toe to 1DG|IG@1.normal: proceed may be shown over it (R3)
        WD_1DG_4 = QN_1 and (not TR_1)  # 1DG from 1DG|IG@1.normal to 1DG|IAG@1.toe: its points lie, nothing is foul of it
        WL_1DG_4 = (not OCC_1DG) and WD_1DG_4  # 1DG from 1DG|IG@1.normal to 1DG|IAG@1.toe: lies and is clear
        WP_1DG_4 = WL_1DG_4 and (not BLK_1DG)  # 1DG from 1DG|IG@1.normal to 1DG|IAG@1.toe: proceed may be shown over it (R3)
        WD_2DG_1 = QR_2 and (not TR_2)  # 2DG from 2DG|3G@2.reverse to 2DG|IIAG@2.toe: its points lie, nothing is foul of it
        WL_2DG_1 = (not OCC_2DG) and WD_2DG_1  # 2DG from 2DG|3G@2.reverse to 2DG|IIAG@2.toe: lies and is clear
        WP_2DG_1 = WL_2DG_1 and (not BLK_2DG)  # 2DG from 2DG|3G@2.reverse to 2DG|IIAG@2.toe: proceed may be shown over it (R3)
        WD_2DG_2 = QN_2 and (not TR_2)  # 2DG from 2DG|IG@2.normal to 2DG|IIAG@2.toe: its points lie, nothing is foul of it
        WL_2DG_2 = (not OCC_2DG) and WD_2DG_2  # 2DG from 2DG|IG@2.normal to 2DG|IIAG@2.toe: lies and is clear
        WP_2DG_2 = WL_2DG_2 and (not BLK_2DG)  # 2DG from 2DG|IG@2.normal to 2DG|IIAG@2.toe: proceed may be shown over it (R3)
        WD_2DG_3 = QR_2 and (not TR_2)  # 2DG from 2DG|IIAG@2.toe to 2DG|3G@2.reverse: its points lie, nothing is foul of it
        WL_2DG_3 = (not OCC_2DG) and WD_2DG_3  # 2DG from 2DG|IIAG@2.toe to 2DG|3G@2.reverse: lies and is clear
        WP_2DG_3 = WL_2DG_3 and (not BLK_2DG)  # 2DG from 2DG|IIAG@2.toe to 2DG|3G@2.reverse: proceed may be shown over it (R3)
        WD_2DG_4 = QN_2 and (not TR_2)  # 2DG from 2DG|IIAG@2.toe to 2DG|IG@2.normal: its points lie, nothing is foul of it
        WL_2DG_4 = (not OCC_2DG) and WD_2DG_4  # 2DG from 2DG|IIAG@2.toe to 2DG|IG@2.normal: lies and is clear
        WP_2DG_4 = WL_2DG_4 and (not BLK_2DG)  # 2DG from 2DG|IIAG@2.toe to 2DG|IG@2.normal: proceed may be shown over it (R3)
        WL_3G_1 = (not OCC_3G)  # 3G from 1DG|3G@1.reverse to 2DG|3G@2.reverse: lies and is clear
        WP_3G_1 = WL_3G_1 and (not BLK_3G)  # 3G from 1DG|3G@1.reverse to 2DG|3G@2.reverse: proceed may be shown over it (R3)
        WL_3G_2 = (not OCC_3G)  # 3G from 2DG|3G@2.reverse to 1DG|3G@1.reverse: lies and is clear
        WP_3G_2 = WL_3G_2 and (not BLK_3G)  # 3G from 2DG|3G@2.reverse to 1DG|3G@1.reverse: proceed may be shown over it (R3)
        WL_IAG_1 = (not OCC_IAG)  # IAG from 1DG|IAG@1.toe to W: lies and is clear
        WP_IAG_1 = WL_IAG_1 and (not BLK_IAG)  # IAG from 1DG|IAG@1.toe to W: proceed may be shown over it (R3)
        WL_IAG_2 = (not OCC_IAG)  # IAG from W to 1DG|IAG@1.toe: lies and is clear
        WP_IAG_2 = WL_IAG_2 and (not BLK_IAG)  # IAG from W to 1DG|IAG@1.toe: proceed may be shown over it (R3)
        WL_IG_1 = (not OCC_IG)  # IG from 1DG|IG@1.normal to 2DG|IG@2.normal: lies and is clear
        WP_IG_1 = WL_IG_1 and (not BLK_IG)  # IG from 1DG|IG@1.normal to 2DG|IG@2.normal: proceed may be shown over it (R3)
        WL_IG_2 = (not OCC_IG)  # IG from 2DG|IG@2.normal to 1DG|IG@1.normal: lies and is clear
        WP_IG_2 = WL_IG_2 and (not BLK_IG)  # IG from 2DG|IG@2.normal to 1DG|IG@1.normal: proceed may be shown over it (R3)
        WL_IIAG_1 = (not OCC_IIAG)  # IIAG from 2DG|IIAG@2.toe to E: lies and is clear
        WP_IIAG_1 = WL_IIAG_1 and (not BLK_IIAG)  # IIAG from 2DG|IIAG@2.toe to E: proceed may be shown over it (R3)
        WL_IIAG_2 = (not OCC_IIAG)  # IIAG from E to 2DG|IIAG@2.toe: lies and is clear
        WP_IIAG_2 = WL_IIAG_2 and (not BLK_IIAG)  # IIAG from E to 2DG|IIAG@2.toe: proceed may be shown over it (R3)
        G_R1 = (REQ == 1) and VALID and WF_IIAG_2 and WF_2DG_4 and WF_IG_2  # grant of route S-S1 (R6)
        G_R2 = (REQ == 2) and VALID and WF_IIAG_2 and WF_2DG_3 and WF_3G_2  # grant of route S-S3 (R6)
        G_R3 = (REQ == 3) and VALID and WF_IIAG_2 and FREE_2DG and (not BLK_2DG) and WA_2DG_4 and FREE_IG and (not BLK_IG)  # grant of route S-S1.c (R6)
        G_R4 = (REQ == 4) and VALID and WF_IIAG_2 and FREE_2DG and (not BLK_2DG) and WA_2DG_3 and FREE_3G and (not BLK_3G)  # grant of route S-S3.c (R6)
        G_R5 = (REQ == 5) and VALID and WF_1DG_4 and WF_IAG_1  # grant of route S1-W (R6)
        G_R6 = (REQ == 6) and VALID and WF_1DG_1 and WF_IAG_1  # grant of route S3-W (R6)
        G_R7 = (REQ == 7) and VALID and WF_IAG_2 and WF_1DG_3 and WF_IG_1  # grant of route X-X1 (R6)
        G_R8 = (REQ == 8) and VALID and WF_IAG_2 and WF_1DG_2 and WF_3G_1  # grant of route X-X3 (R6)
        G_R9 = (REQ == 9) and VALID and WF_IAG_2 and FREE_1DG and (not BLK_1DG) and WA_1DG_3 and FREE_IG and (not BLK_IG)  # grant of route X-X1.c (R6)
        G_R10 = (REQ == 10) and VALID and WF_IAG_2 and FREE_1DG and (not BLK_1DG) and WA_1DG_2 and FREE_3G and (not BLK_3G)  # grant of route X-X3.c (R6)
        G_R11 = (REQ == 11) and VALID and WF_2DG_2 and WF_IIAG_1  # grant of route X1-E (R6)
        G_R12 = (REQ == 12) and VALID and WF_2DG_1 and WF_IIAG_1  # grant of route X3-E (R6)
        GW_1DG_1 = G_R6  # 1DG from 1DG|3G@1.reverse to 1DG|IAG@1.toe: granted
        GW_1DG_2 = G_R8 or G_R10  # 1DG from 1DG|IAG@1.toe to 1DG|3G@1.reverse: granted
        GW_1DG_3 = G_R7 or G_R9  # 1DG from 1DG|IAG@1.toe to 1DG|IG@1.normal: granted
        GW_1DG_4 = G_R5  # 1DG from 1DG|IG@1.normal to 1DG|IAG@1.toe: granted
        GW_2DG_1 = G_R12  # 2DG from 2DG|3G@2.reverse to 2DG|IIAG@2.toe: granted
        GW_2DG_2 = G_R11  # 2DG from 2DG|IG@2.normal to 2DG|IIAG@2.toe: granted
        GW_2DG_3 = G_R2 or G_R4  # 2DG from 2DG|IIAG@2.toe to 2DG|3G@2.reverse: granted
        GW_2DG_4 = G_R1 or G_R3  # 2DG from 2DG|IIAG@2.toe to 2DG|IG@2.normal: granted
        GW_3G_1 = G_R8 or G_R10  # 3G from 1DG|3G@1.reverse to 2DG|3G@2.reverse: granted
        GW_3G_2 = G_R2 or G_R4  # 3G from 2DG|3G@2.reverse to 1DG|3G@1.reverse: granted
        GW_IAG_1 = G_R5 or G_R6  # IAG from 1DG|IAG@1.toe to W: granted
        GW_IAG_2 = G_R7 or G_R8 or G_R9 or G_R10  # IAG from W to 1DG|IAG@1.toe: granted
        GW_IG_1 = G_R7 or G_R9  # IG from 1DG|IG@1.normal to 2DG|IG@2.normal: granted
        GW_IG_2 = G_R1 or G_R3  # IG from 2DG|IG@2.normal to 1DG|IG@1.normal: granted
        GW_IIAG_1 = G_R11 or G_R12  # IIAG from 2DG|IIAG@2.toe to E: granted
        GW_IIAG_2 = G_R1 or G_R2 or G_R3 or G_R4  # IIAG from E to 2DG|IIAG@2.toe: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_S) and (not CAN_S) and WL_IIAG_2 and WL_2DG_4 and WL_IG_2  # route S-S1 becomes locked (R3)
        CO_R1 = VALID and WP_IIAG_2 and WP_2DG_4 and WP_IG_2 and (not D_IIAG)  # conditions of proceed for route S-S1 (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_S) and (not CAN_S) and WL_IIAG_2 and WL_2DG_3 and WL_3G_2  # route S-S3 becomes locked (R3)
        CO_R2 = VALID and WP_IIAG_2 and WP_2DG_3 and WP_3G_2 and (not D_IIAG)  # conditions of proceed for route S-S3 (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_S) and (not CAN_S) and WL_IIAG_2 and WD_2DG_4  # route S-S1.c becomes locked (R3)
        CO_R3 = VALID and WP_IIAG_2 and WD_2DG_4 and (not BLK_2DG) and (not BLK_IG)  # conditions of proceed for route S-S1.c (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_S) and (not CAN_S) and WL_IIAG_2 and WD_2DG_3  # route S-S3.c becomes locked (R3)
        CO_R4 = VALID and WP_IIAG_2 and WD_2DG_3 and (not BLK_2DG) and (not BLK_3G)  # conditions of proceed for route S-S3.c (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_S1) and (not CAN_S1) and WL_1DG_4 and WL_IAG_1  # route S1-W becomes locked (R3)
        CO_R5 = VALID and WP_1DG_4 and WP_IAG_1 and (not OCC_XJG) and BH_W and (not D_1DG)  # conditions of proceed for route S1-W (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_S3) and (not CAN_S3) and WL_1DG_1 and WL_IAG_1  # route S3-W becomes locked (R3)
        CO_R6 = VALID and WP_1DG_1 and WP_IAG_1 and (not OCC_XJG) and BH_W and (not D_1DG)  # conditions of proceed for route S3-W (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WL_1DG_3 and WL_IG_1  # route X-X1 becomes locked (R3)
        CO_R7 = VALID and WP_IAG_2 and WP_1DG_3 and WP_IG_1 and (not D_IAG)  # conditions of proceed for route X-X1 (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WL_1DG_2 and WL_3G_1  # route X-X3 becomes locked (R3)
        CO_R8 = VALID and WP_IAG_2 and WP_1DG_2 and WP_3G_1 and (not D_IAG)  # conditions of proceed for route X-X3 (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WD_1DG_3  # route X-X1.c becomes locked (R3)
        CO_R9 = VALID and WP_IAG_2 and WD_1DG_3 and (not BLK_1DG) and (not BLK_IG)  # conditions of proceed for route X-X1.c (R3)
        LK_R10 = A_R10 and (not B_R10) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WD_1DG_2  # route X-X3.c becomes locked (R3)
        CO_R10 = VALID and WP_IAG_2 and WD_1DG_2 and (not BLK_1DG) and (not BLK_3G)  # conditions of proceed for route X-X3.c (R3)
        LK_R11 = A_R11 and (not B_R11) and VALID and (not X_X1) and (not CAN_X1) and WL_2DG_2 and WL_IIAG_1  # route X1-E becomes locked (R3)
        CO_R11 = VALID and WP_2DG_2 and WP_IIAG_1 and E_BF_E and (not OCC_SJG) and (not D_2DG)  # conditions of proceed for route X1-E (R3)
        LK_R12 = A_R12 and (not B_R12) and VALID and (not X_X3) and (not CAN_X3) and WL_2DG_1 and WL_IIAG_1  # route X3-E becomes locked (R3)
        CO_R12 = VALID and WP_2DG_1 and WP_IIAG_1 and E_BF_E and (not OCC_SJG) and (not D_2DG)  # conditions of proceed for route X3-E (R3)
        NU_1DG_1 = VALID and F_1DG and (not D_1DG) and (not U_1DG) and L_1DG_1 and OCC_1DG and OCC_3G  # a train comes into 1DG at 1DG|3G@1.reverse (R9)
        NU_1DG_2 = VALID and F_1DG and (not D_1DG) and (not U_1DG) and (L_1DG_2 or L_1DG_3) and OCC_1DG and OCC_IAG and U_IAG and L_IAG_2  # a train comes into 1DG at 1DG|IAG@1.toe (R9)
        NU_1DG_3 = VALID and F_1DG and (not D_1DG) and (not U_1DG) and L_1DG_4 and OCC_1DG and OCC_IG  # a train comes into 1DG at 1DG|IG@1.normal (R9)
        NU_2DG_1 = VALID and F_2DG and (not D_2DG) and (not U_2DG) and L_2DG_1 and OCC_2DG and OCC_3G  # a train comes into 2DG at 2DG|3G@2.reverse (R9)
        NU_2DG_2 = VALID and F_2DG and (not D_2DG) and (not U_2DG) and L_2DG_2 and OCC_2DG and OCC_IG  # a train comes into 2DG at 2DG|IG@2.normal (R9)
        NU_2DG_3 = VALID and F_2DG and (not D_2DG) and (not U_2DG) and (L_2DG_3 or L_2DG_4) and OCC_2DG and OCC_IIAG and U_IIAG and L_IIAG_2  # a train comes into 2DG at 2DG|IIAG@2.toe (R9)
        NU_3G_1 = VALID and F_3G and (not D_3G) and (not U_3G) and L_3G_1 and OCC_3G and OCC_1DG and U_1DG and L_1DG_2  # a train comes into 3G at 1DG|3G@1.reverse (R9)
        NU_3G_2 = VALID and F_3G and (not D_3G) and (not U_3G) and L_3G_2 and OCC_3G and OCC_2DG and U_2DG and L_2DG_3  # a train comes into 3G at 2DG|3G@2.reverse (R9)
        NU_IAG_1 = VALID and F_IAG and (not D_IAG) and (not U_IAG) and L_IAG_1 and OCC_IAG and OCC_1DG and U_1DG and (L_1DG_1 or L_1DG_4)  # a train comes into IAG at 1DG|IAG@1.toe (R9)
        NU_IAG_2 = VALID and F_IAG and (not D_IAG) and (not U_IAG) and L_IAG_2 and OCC_IAG and OCC_XJG  # a train comes into IAG at W (R9)
        NU_IG_1 = VALID and F_IG and (not D_IG) and (not U_IG) and L_IG_1 and OCC_IG and OCC_1DG and U_1DG and L_1DG_3  # a train comes into IG at 1DG|IG@1.normal (R9)
        NU_IG_2 = VALID and F_IG and (not D_IG) and (not U_IG) and L_IG_2 and OCC_IG and OCC_2DG and U_2DG and L_2DG_4  # a train comes into IG at 2DG|IG@2.normal (R9)
        NU_IIAG_1 = VALID and F_IIAG and (not D_IIAG) and (not U_IIAG) and L_IIAG_1 and OCC_IIAG and OCC_2DG and U_2DG and (L_2DG_1 or L_2DG_2)  # a train comes into IIAG at 2DG|IIAG@2.toe (R9)
        NU_IIAG_2 = VALID and F_IIAG and (not D_IIAG) and (not U_IIAG) and L_IIAG_2 and OCC_IIAG and OCC_SJG  # a train comes into IIAG at E (R9)
        ATI_S = X_S or ((not (A_R1 or A_R2 or A_R3 or A_R4)) and L_IIAG_2 and REL_IIAG)  # S at stop, waiting for a train that may still come (R8)
        ATI_S1 = X_S1 or ((not A_R5) and L_1DG_4 and REL_1DG)  # S1 at stop, waiting for a train that may still come (R8)
        ATI_S3 = X_S3 or ((not A_R6) and L_1DG_1 and REL_1DG)  # S3 at stop, waiting for a train that may still come (R8)
        ATI_X = X_X or ((not (A_R7 or A_R8 or A_R9 or A_R10)) and L_IAG_2 and REL_IAG)  # X at stop, waiting for a train that may still come (R8)
        ATI_X1 = X_X1 or ((not A_R11) and L_2DG_2 and REL_2DG)  # X1 at stop, waiting for a train that may still come (R8)
        ATI_X3 = X_X3 or ((not A_R12) and L_2DG_1 and REL_2DG)  # X3 at stop, waiting for a train that may still come (R8)
        AT_S = self._timer('AT_S', ATI_S, dt_ms)  # S: approach locking delay (R8)
        AT_S1 = self._timer('AT_S1', ATI_S1, dt_ms)  # S1: approach locking delay (R8)
        AT_S3 = self._timer('AT_S3', ATI_S3, dt_ms)  # S3: approach locking delay (R8)
        AT_X = self._timer('AT_X', ATI_X, dt_ms)  # X: approach locking delay (R8)
        AT_X1 = self._timer('AT_X1', ATI_X1, dt_ms)  # X1: approach locking delay (R8)
        AT_X3 = self._timer('AT_X3', ATI_X3, dt_ms)  # X3: approach locking delay (R8)
        CD_S = X_S and (A_R1 or A_R2 or A_R3 or A_R4) and VALID and (not OCC_IIAG) and ((not OCC_SJG) or AT_S or (not (H_R1 or H_R2 or H_R3 or H_R4)))  # the route from S is cancelled (R8)
        CD_S1 = X_S1 and A_R5 and VALID and (not OCC_1DG) and ((not OCC_IG) or AT_S1 or (not H_R5))  # the route from S1 is cancelled (R8)
        CD_S3 = X_S3 and A_R6 and VALID and (not OCC_1DG) and ((not OCC_3G) or AT_S3 or (not H_R6))  # the route from S3 is cancelled (R8)
        CD_X = X_X and (A_R7 or A_R8 or A_R9 or A_R10) and VALID and (not OCC_IAG) and ((not OCC_XJG) or AT_X or (not (H_R7 or H_R8 or H_R9 or H_R10)))  # the route from X is cancelled (R8)
        CD_X1 = X_X1 and A_R11 and VALID and (not OCC_2DG) and ((not OCC_IG) or AT_X1 or (not H_R11))  # the route from X1 is cancelled (R8)
        CD_X3 = X_X3 and A_R12 and VALID and (not OCC_2DG) and ((not OCC_3G) or AT_X3 or (not H_R12))  # the route from X3 is cancelled (R8)
        EX_1DG = P_1DG  # a train in 1DG leaves over a boundary, or has passed on
        RTI_1DG = VALID and U_1DG and (not OCC_1DG) and (not ((L_1DG_2 or L_1DG_3) and L_IAG_2)) and EX_1DG  # 1DG may be released behind the train (R9)
        EX_2DG = P_2DG  # a train in 2DG leaves over a boundary, or has passed on
        RTI_2DG = VALID and U_2DG and (not OCC_2DG) and (not ((L_2DG_3 or L_2DG_4) and L_IIAG_2)) and EX_2DG  # 2DG may be released behind the train (R9)
        EX_3G = P_3G  # a train in 3G leaves over a boundary, or has passed on
        RTI_3G = VALID and U_3G and (not OCC_3G) and (not (L_3G_1 and L_1DG_2)) and (not (L_3G_2 and L_2DG_3)) and EX_3G  # 3G may be released behind the train (R9)
        EX_IAG = P_IAG or L_IAG_1  # a train in IAG leaves over a boundary, or has passed on
        RTI_IAG = VALID and U_IAG and (not OCC_IAG) and (not (L_IAG_1 and (L_1DG_1 or L_1DG_4))) and EX_IAG  # IAG may be released behind the train (R9)
        EX_IG = P_IG  # a train in IG leaves over a boundary, or has passed on
        RTI_IG = VALID and U_IG and (not OCC_IG) and (not (L_IG_1 and L_1DG_3)) and (not (L_IG_2 and L_2DG_4)) and EX_IG  # IG may be released behind the train (R9)
        EX_IIAG = P_IIAG or L_IIAG_1  # a train in IIAG leaves over a boundary, or has passed on
        RTI_IIAG = VALID and U_IIAG and (not OCC_IIAG) and (not (L_IIAG_1 and (L_2DG_1 or L_2DG_2))) and EX_IIAG  # IIAG may be released behind the train (R9)
        RT_1DG = self._timer('RT_1DG', RTI_1DG, dt_ms)  # 1DG: release delay (R9)
        RT_2DG = self._timer('RT_2DG', RTI_2DG, dt_ms)  # 2DG: release delay (R9)
        RT_3G = self._timer('RT_3G', RTI_3G, dt_ms)  # 3G: release delay (R9)
        RT_IAG = self._timer('RT_IAG', RTI_IAG, dt_ms)  # IAG: release delay (R9)
        RT_IG = self._timer('RT_IG', RTI_IG, dt_ms)  # IG: release delay (R9)
        RT_IIAG = self._timer('RT_IIAG', RTI_IIAG, dt_ms)  # IIAG: release delay (R9)
        CA_1DG = VALID and (not OCC_1DG) and (not U_1DG) and (L_1DG_2 or L_1DG_3) and (not ((L_1DG_2 or L_1DG_3) and L_IAG_2))  # the lock before 1DG was withdrawn (R8)
        HR_1DG = VALID and (not OCC_1DG) and (not ((L_1DG_2 or L_1DG_3) and L_IAG_2)) and REL_1DG and (L_1DG_1 or L_1DG_2 or L_1DG_3 or L_1DG_4) and ((not L_1DG_1) or ((not A_R6) and ((not OCC_3G) or AT_S3))) and ((not L_1DG_4) or ((not A_R5) and ((not OCC_IG) or AT_S1)))  # 1DG released by hand (R8, section fault release)
        SR_1DG = VALID and (not OCC_1DG) and K_1DG and (REL_1DG or RELALL)  # 1DG released after a restart (R16)
        RLS_1DG = RT_1DG or CA_1DG or CD_S3 or CD_S1 or HR_1DG or SR_1DG  # 1DG is released
        CA_2DG = VALID and (not OCC_2DG) and (not U_2DG) and (L_2DG_3 or L_2DG_4) and (not ((L_2DG_3 or L_2DG_4) and L_IIAG_2))  # the lock before 2DG was withdrawn (R8)
        HR_2DG = VALID and (not OCC_2DG) and (not ((L_2DG_3 or L_2DG_4) and L_IIAG_2)) and REL_2DG and (L_2DG_1 or L_2DG_2 or L_2DG_3 or L_2DG_4) and ((not L_2DG_1) or ((not A_R12) and ((not OCC_3G) or AT_X3))) and ((not L_2DG_2) or ((not A_R11) and ((not OCC_IG) or AT_X1)))  # 2DG released by hand (R8, section fault release)
        SR_2DG = VALID and (not OCC_2DG) and K_2DG and (REL_2DG or RELALL)  # 2DG released after a restart (R16)
        RLS_2DG = RT_2DG or CA_2DG or CD_X3 or CD_X1 or HR_2DG or SR_2DG  # 2DG is released
        CA_3G = VALID and (not OCC_3G) and (not U_3G) and (L_3G_1 or L_3G_2) and (not (L_3G_1 and L_1DG_2)) and (not (L_3G_2 and L_2DG_3))  # the lock before 3G was withdrawn (R8)
        HR_3G = VALID and (not OCC_3G) and (not (L_3G_1 and L_1DG_2)) and (not (L_3G_2 and L_2DG_3)) and REL_3G and (L_3G_1 or L_3G_2)  # 3G released by hand (R8, section fault release)
        SR_3G = VALID and (not OCC_3G) and K_3G and (REL_3G or RELALL)  # 3G released after a restart (R16)
        RLS_3G = RT_3G or CA_3G or HR_3G or SR_3G  # 3G is released
        CA_IAG = VALID and (not OCC_IAG) and (not U_IAG) and L_IAG_1 and (not (L_IAG_1 and (L_1DG_1 or L_1DG_4)))  # the lock before IAG was withdrawn (R8)
        HR_IAG = VALID and (not OCC_IAG) and (not (L_IAG_1 and (L_1DG_1 or L_1DG_4))) and REL_IAG and (L_IAG_1 or L_IAG_2) and ((not L_IAG_2) or ((not (A_R7 or A_R8 or A_R9 or A_R10)) and ((not OCC_XJG) or AT_X)))  # IAG released by hand (R8, section fault release)
        SR_IAG = VALID and (not OCC_IAG) and K_IAG and (REL_IAG or RELALL)  # IAG released after a restart (R16)
        RLS_IAG = RT_IAG or CA_IAG or CD_X or HR_IAG or SR_IAG  # IAG is released
        CA_IG = VALID and (not OCC_IG) and (not U_IG) and (L_IG_1 or L_IG_2) and (not (L_IG_1 and L_1DG_3)) and (not (L_IG_2 and L_2DG_4))  # the lock before IG was withdrawn (R8)
        HR_IG = VALID and (not OCC_IG) and (not (L_IG_1 and L_1DG_3)) and (not (L_IG_2 and L_2DG_4)) and REL_IG and (L_IG_1 or L_IG_2)  # IG released by hand (R8, section fault release)
        SR_IG = VALID and (not OCC_IG) and K_IG and (REL_IG or RELALL)  # IG released after a restart (R16)
        RLS_IG = RT_IG or CA_IG or HR_IG or SR_IG  # IG is released
        CA_IIAG = VALID and (not OCC_IIAG) and (not U_IIAG) and L_IIAG_1 and (not (L_IIAG_1 and (L_2DG_1 or L_2DG_2)))  # the lock before IIAG was withdrawn (R8)
        HR_IIAG = VALID and (not OCC_IIAG) and (not (L_IIAG_1 and (L_2DG_1 or L_2DG_2))) and REL_IIAG and (L_IIAG_1 or L_IIAG_2) and ((not L_IIAG_2) or ((not (A_R1 or A_R2 or A_R3 or A_R4)) and ((not OCC_SJG) or AT_S)))  # IIAG released by hand (R8, section fault release)
        SR_IIAG = VALID and (not OCC_IIAG) and K_IIAG and (REL_IIAG or RELALL)  # IIAG released after a restart (R16)
        RLS_IIAG = RT_IIAG or CA_IIAG or CD_S or HR_IIAG or SR_IIAG  # IIAG is released
        BTI_W = VALID and TKN_W and (not BH_W) and (not BG_W) and (not NG_W) and (not NH_W)  # direction at W: special manual change (R12)
        BT_W = self._timer('BT_W', BTI_W, dt_ms)  # W: special manual change (R12)
        BK_W = VALID and NG_W and (not BH_W) and (not BG_W)  # the direction at W is taken (R12)
        BV_W = VALID and NR_W and BH_W and BN_W and LC_W and (not L_IAG_1)  # the direction at W is given to the neighbour (R12)
        TG_1 = (GW_1DG_1 or GW_1DG_2 or GW_1DG_3 or GW_1DG_4)  # a grant touches machine 1 in this scan
        GPN_1 = (GW_1DG_3 or GW_1DG_4)  # a grant needs 1 N
        MAN_1 = MN_1 and (not MR_1) and MOV_1 and (not TG_1)  # machine 1 moved N by hand
        GPR_1 = (GW_1DG_1 or GW_1DG_2)  # a grant needs 1 R
        MAR_1 = MR_1 and (not MN_1) and MOV_1 and (not TG_1)  # machine 1 moved R by hand
        HDN_1 = CN_1 and (not GPR_1) and (not MAR_1)  # the command N stays
        HDR_1 = CR_1 and (not GPN_1) and (not MAN_1)  # the command R stays
        TG_2 = (GW_2DG_1 or GW_2DG_2 or GW_2DG_3 or GW_2DG_4)  # a grant touches machine 2 in this scan
        GPN_2 = (GW_2DG_2 or GW_2DG_4)  # a grant needs 2 N
        MAN_2 = MN_2 and (not MR_2) and MOV_2 and (not TG_2)  # machine 2 moved N by hand
        GPR_2 = (GW_2DG_1 or GW_2DG_3)  # a grant needs 2 R
        MAR_2 = MR_2 and (not MN_2) and MOV_2 and (not TG_2)  # machine 2 moved R by hand
        HDN_2 = CN_2 and (not GPR_2) and (not MAR_2)  # the command N stays
        HDR_2 = CR_2 and (not GPN_2) and (not MAN_2)  # the command R stays
        STI_1 = (CN_1 and (not QN_1)) or (CR_1 and (not QR_1))  # machine 1 is not where it was commanded
        STI_2 = (CN_2 and (not QN_2)) or (CR_2 and (not QR_2))  # machine 2 is not where it was commanded
        ST_1 = self._timer('ST_1', STI_1, dt_ms)  # machine 1: time-out
        ST_2 = self._timer('ST_2', STI_2, dt_ms)  # machine 2: time-out
        KP_R1 = (not NU_IIAG_2) and (not CD_S)  # route S-S1 stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_S) and (not CAN_S)  # proceed for route S-S1 (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route S-S1: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_IIAG_2) and (not CD_S)  # route S-S3 stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_S) and (not CAN_S)  # proceed for route S-S3 (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route S-S3: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_IIAG_2) and (not CD_S)  # route S-S1.c stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_S) and (not CAN_S)  # proceed for route S-S1.c (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route S-S1.c: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_IIAG_2) and (not CD_S)  # route S-S3.c stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_S) and (not CAN_S)  # proceed for route S-S3.c (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route S-S3.c: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_1DG_3) and (not CD_S1)  # route S1-W stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_S1) and (not CAN_S1)  # proceed for route S1-W (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route S1-W: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_1DG_1) and (not CD_S3)  # route S3-W stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_S3) and (not CAN_S3)  # proceed for route S3-W (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route S3-W: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_IAG_2) and (not CD_X)  # route X-X1 stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_X) and (not CAN_X)  # proceed for route X-X1 (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route X-X1: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_IAG_2) and (not CD_X)  # route X-X3 stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_X) and (not CAN_X)  # proceed for route X-X3 (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route X-X3: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_IAG_2) and (not CD_X)  # route X-X1.c stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_X) and (not CAN_X)  # proceed for route X-X1.c (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route X-X1.c: a condition was lost; no reopening by itself (R14)
        KP_R10 = (not NU_IAG_2) and (not CD_X)  # route X-X3.c stays set
        PR_R10 = A_R10 and B_R10 and W_R10 and CO_R10 and KP_R10 and (not X_X) and (not CAN_X)  # proceed for route X-X3.c (R3, R11)
        LS_R10 = S_R10 and (not CO_R10)  # route X-X3.c: a condition was lost; no reopening by itself (R14)
        KP_R11 = (not NU_2DG_2) and (not CD_X1)  # route X1-E stays set
        PR_R11 = A_R11 and B_R11 and W_R11 and CO_R11 and KP_R11 and (not X_X1) and (not CAN_X1)  # proceed for route X1-E (R3, R11)
        LS_R11 = S_R11 and (not CO_R11)  # route X1-E: a condition was lost; no reopening by itself (R14)
        KP_R12 = (not NU_2DG_1) and (not CD_X3)  # route X3-E stays set
        PR_R12 = A_R12 and B_R12 and W_R12 and CO_R12 and KP_R12 and (not X_X3) and (not CAN_X3)  # proceed for route X3-E (R3, R11)
        LS_R12 = S_R12 and (not CO_R12)  # route X3-E: a condition was lost; no reopening by itself (R14)
        N_CN_1 = GPN_1 or MAN_1 or HDN_1  # machine 1 commanded N
        N_CR_1 = GPR_1 or MAR_1 or HDR_1  # machine 1 commanded R
        N_CN_2 = GPN_2 or MAN_2 or HDN_2  # machine 2 commanded N
        N_CR_2 = GPR_2 or MAR_2 or HDR_2  # machine 2 commanded R
        N_AL_1 = ST_1  # alarm: machine 1 not detected
        N_AL_2 = ST_2  # alarm: machine 2 not detected
        N_TH_1 = ((CN_1 and QN_1) or (CR_1 and QR_1)) and (not (GPN_1 or GPR_1 or MAN_1 or MAR_1))  # machine 1 was detected where it is commanded
        N_TR_1 = (TH_1 and VALID and ((CN_1 and (not QN_1) and (not GPR_1) and (not MAR_1)) or (CR_1 and (not QR_1) and (not GPN_1) and (not MAN_1)))) or (TR_1 and (not (TC_1 and VALID and (not OCC_1DG))))  # machine 1 was trailed
        N_TH_2 = ((CN_2 and QN_2) or (CR_2 and QR_2)) and (not (GPN_2 or GPR_2 or MAN_2 or MAR_2))  # machine 2 was detected where it is commanded
        N_TR_2 = (TH_2 and VALID and ((CN_2 and (not QN_2) and (not GPR_2) and (not MAR_2)) or (CR_2 and (not QR_2) and (not GPN_2) and (not MAN_2)))) or (TR_2 and (not (TC_2 and VALID and (not OCC_2DG))))  # machine 2 was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route S-S1 active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route S-S1 locked
        N_W_R1 = (W_R1 or LK_R1 or ((REQ == 1) and B_R1)) and (not LS_R1) and KP_R1 and (not X_S) and (not CAN_S)  # route S-S1: proceed wanted
        N_S_R1 = PR_R1  # route S-S1: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route S-S1: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route S-S3 active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route S-S3 locked
        N_W_R2 = (W_R2 or LK_R2 or ((REQ == 2) and B_R2)) and (not LS_R2) and KP_R2 and (not X_S) and (not CAN_S)  # route S-S3: proceed wanted
        N_S_R2 = PR_R2  # route S-S3: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route S-S3: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route S-S1.c active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route S-S1.c locked
        N_W_R3 = (W_R3 or LK_R3) and (not LS_R3) and KP_R3 and (not X_S) and (not CAN_S)  # route S-S1.c: proceed wanted
        N_S_R3 = PR_R3  # route S-S1.c: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route S-S1.c: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route S-S3.c active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route S-S3.c locked
        N_W_R4 = (W_R4 or LK_R4) and (not LS_R4) and KP_R4 and (not X_S) and (not CAN_S)  # route S-S3.c: proceed wanted
        N_S_R4 = PR_R4  # route S-S3.c: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route S-S3.c: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route S1-W active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route S1-W locked
        N_W_R5 = (W_R5 or LK_R5 or ((REQ == 5) and B_R5)) and (not LS_R5) and KP_R5 and (not X_S1) and (not CAN_S1)  # route S1-W: proceed wanted
        N_S_R5 = PR_R5  # route S1-W: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route S1-W: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route S3-W active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route S3-W locked
        N_W_R6 = (W_R6 or LK_R6 or ((REQ == 6) and B_R6)) and (not LS_R6) and KP_R6 and (not X_S3) and (not CAN_S3)  # route S3-W: proceed wanted
        N_S_R6 = PR_R6  # route S3-W: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route S3-W: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route X-X1 active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route X-X1 locked
        N_W_R7 = (W_R7 or LK_R7 or ((REQ == 7) and B_R7)) and (not LS_R7) and KP_R7 and (not X_X) and (not CAN_X)  # route X-X1: proceed wanted
        N_S_R7 = PR_R7  # route X-X1: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route X-X1: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route X-X3 active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route X-X3 locked
        N_W_R8 = (W_R8 or LK_R8 or ((REQ == 8) and B_R8)) and (not LS_R8) and KP_R8 and (not X_X) and (not CAN_X)  # route X-X3: proceed wanted
        N_S_R8 = PR_R8  # route X-X3: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route X-X3: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route X-X1.c active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route X-X1.c locked
        N_W_R9 = (W_R9 or LK_R9) and (not LS_R9) and KP_R9 and (not X_X) and (not CAN_X)  # route X-X1.c: proceed wanted
        N_S_R9 = PR_R9  # route X-X1.c: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route X-X1.c: signal has been open
        N_A_R10 = (A_R10 or G_R10) and KP_R10  # route X-X3.c active
        N_B_R10 = (B_R10 or LK_R10) and KP_R10  # route X-X3.c locked
        N_W_R10 = (W_R10 or LK_R10) and (not LS_R10) and KP_R10 and (not X_X) and (not CAN_X)  # route X-X3.c: proceed wanted
        N_S_R10 = PR_R10  # route X-X3.c: proceed
        N_H_R10 = (H_R10 or PR_R10) and KP_R10  # route X-X3.c: signal has been open
        N_A_R11 = (A_R11 or G_R11) and KP_R11  # route X1-E active
        N_B_R11 = (B_R11 or LK_R11) and KP_R11  # route X1-E locked
        N_W_R11 = (W_R11 or LK_R11 or ((REQ == 11) and B_R11)) and (not LS_R11) and KP_R11 and (not X_X1) and (not CAN_X1)  # route X1-E: proceed wanted
        N_S_R11 = PR_R11  # route X1-E: proceed
        N_H_R11 = (H_R11 or PR_R11) and KP_R11  # route X1-E: signal has been open
        N_A_R12 = (A_R12 or G_R12) and KP_R12  # route X3-E active
        N_B_R12 = (B_R12 or LK_R12) and KP_R12  # route X3-E locked
        N_W_R12 = (W_R12 or LK_R12 or ((REQ == 12) and B_R12)) and (not LS_R12) and KP_R12 and (not X_X3) and (not CAN_X3)  # route X3-E: proceed wanted
        N_S_R12 = PR_R12  # route X3-E: proceed
        N_H_R12 = (H_R12 or PR_R12) and KP_R12  # route X3-E: signal has been open
        N_X_S = (X_S or CAN_S) and (A_R1 or A_R2 or A_R3 or A_R4) and (not CD_S)  # S: cancelling
        N_X_S1 = (X_S1 or CAN_S1) and A_R5 and (not CD_S1)  # S1: cancelling
        N_X_S3 = (X_S3 or CAN_S3) and A_R6 and (not CD_S3)  # S3: cancelling
        N_X_X = (X_X or CAN_X) and (A_R7 or A_R8 or A_R9 or A_R10) and (not CD_X)  # X: cancelling
        N_X_X1 = (X_X1 or CAN_X1) and A_R11 and (not CD_X1)  # X1: cancelling
        N_X_X3 = (X_X3 or CAN_X3) and A_R12 and (not CD_X3)  # X3: cancelling
        N_K_1DG = K_1DG and (not RLS_1DG)  # 1DG: restart lock (R16)
        N_L_1DG_1 = (L_1DG_1 or GW_1DG_1) and (not RLS_1DG)  # 1DG locked from 1DG|3G@1.reverse to 1DG|IAG@1.toe
        N_L_1DG_2 = (L_1DG_2 or GW_1DG_2) and (not RLS_1DG)  # 1DG locked from 1DG|IAG@1.toe to 1DG|3G@1.reverse
        N_L_1DG_3 = (L_1DG_3 or GW_1DG_3) and (not RLS_1DG)  # 1DG locked from 1DG|IAG@1.toe to 1DG|IG@1.normal
        N_L_1DG_4 = (L_1DG_4 or GW_1DG_4) and (not RLS_1DG)  # 1DG locked from 1DG|IG@1.normal to 1DG|IAG@1.toe
        N_F_1DG = (F_1DG or LK_R6 or LK_R8 or LK_R10 or LK_R7 or LK_R9 or LK_R5) and (not RLS_1DG)  # 1DG firmly locked
        N_U_1DG = (U_1DG or NU_1DG_1 or NU_1DG_2 or NU_1DG_3) and (not RLS_1DG)  # 1DG used by a train (R9)
        N_P_1DG = (P_1DG or (U_1DG and OCC_1DG and (NU_3G_1 or NU_IAG_1 or NU_IG_1))) and (not RLS_1DG)  # 1DG: the train went on (R9)
        N_D_1DG = (D_1DG or ((not VALID) and (L_1DG_1 or L_1DG_2 or L_1DG_3 or L_1DG_4)) or G_R9 or G_R10) and (not RLS_1DG)  # 1DG: detection is not relied on, inputs were lost or a train is called on
        N_K_2DG = K_2DG and (not RLS_2DG)  # 2DG: restart lock (R16)
        N_L_2DG_1 = (L_2DG_1 or GW_2DG_1) and (not RLS_2DG)  # 2DG locked from 2DG|3G@2.reverse to 2DG|IIAG@2.toe
        N_L_2DG_2 = (L_2DG_2 or GW_2DG_2) and (not RLS_2DG)  # 2DG locked from 2DG|IG@2.normal to 2DG|IIAG@2.toe
        N_L_2DG_3 = (L_2DG_3 or GW_2DG_3) and (not RLS_2DG)  # 2DG locked from 2DG|IIAG@2.toe to 2DG|3G@2.reverse
        N_L_2DG_4 = (L_2DG_4 or GW_2DG_4) and (not RLS_2DG)  # 2DG locked from 2DG|IIAG@2.toe to 2DG|IG@2.normal
        N_F_2DG = (F_2DG or LK_R12 or LK_R11 or LK_R2 or LK_R4 or LK_R1 or LK_R3) and (not RLS_2DG)  # 2DG firmly locked
        N_U_2DG = (U_2DG or NU_2DG_1 or NU_2DG_2 or NU_2DG_3) and (not RLS_2DG)  # 2DG used by a train (R9)
        N_P_2DG = (P_2DG or (U_2DG and OCC_2DG and (NU_3G_2 or NU_IG_2 or NU_IIAG_1))) and (not RLS_2DG)  # 2DG: the train went on (R9)
        N_D_2DG = (D_2DG or ((not VALID) and (L_2DG_1 or L_2DG_2 or L_2DG_3 or L_2DG_4)) or G_R3 or G_R4) and (not RLS_2DG)  # 2DG: detection is not relied on, inputs were lost or a train is called on
        N_K_3G = K_3G and (not RLS_3G)  # 3G: restart lock (R16)
        N_L_3G_1 = (L_3G_1 or GW_3G_1) and (not RLS_3G)  # 3G locked from 1DG|3G@1.reverse to 2DG|3G@2.reverse
        N_L_3G_2 = (L_3G_2 or GW_3G_2) and (not RLS_3G)  # 3G locked from 2DG|3G@2.reverse to 1DG|3G@1.reverse
        N_F_3G = (F_3G or LK_R8 or LK_R10 or LK_R2 or LK_R4) and (not RLS_3G)  # 3G firmly locked
        N_U_3G = (U_3G or NU_3G_1 or NU_3G_2) and (not RLS_3G)  # 3G used by a train (R9)
        N_P_3G = (P_3G or (U_3G and OCC_3G and (NU_1DG_1 or NU_2DG_1))) and (not RLS_3G)  # 3G: the train went on (R9)
        N_D_3G = (D_3G or ((not VALID) and (L_3G_1 or L_3G_2)) or G_R4 or G_R10) and (not RLS_3G)  # 3G: detection is not relied on, inputs were lost or a train is called on
        N_K_IAG = K_IAG and (not RLS_IAG)  # IAG: restart lock (R16)
        N_L_IAG_1 = (L_IAG_1 or GW_IAG_1) and (not RLS_IAG)  # IAG locked from 1DG|IAG@1.toe to W
        N_L_IAG_2 = (L_IAG_2 or GW_IAG_2) and (not RLS_IAG)  # IAG locked from W to 1DG|IAG@1.toe
        N_F_IAG = (F_IAG or LK_R5 or LK_R6 or LK_R7 or LK_R8 or LK_R9 or LK_R10) and (not RLS_IAG)  # IAG firmly locked
        N_U_IAG = (U_IAG or NU_IAG_1 or NU_IAG_2) and (not RLS_IAG)  # IAG used by a train (R9)
        N_P_IAG = (P_IAG or (U_IAG and OCC_IAG and NU_1DG_2)) and (not RLS_IAG)  # IAG: the train went on (R9)
        N_D_IAG = (D_IAG or ((not VALID) and (L_IAG_1 or L_IAG_2)) or G_R9 or G_R10) and (not RLS_IAG)  # IAG: detection is not relied on, inputs were lost or a train is called on
        N_K_IG = K_IG and (not RLS_IG)  # IG: restart lock (R16)
        N_L_IG_1 = (L_IG_1 or GW_IG_1) and (not RLS_IG)  # IG locked from 1DG|IG@1.normal to 2DG|IG@2.normal
        N_L_IG_2 = (L_IG_2 or GW_IG_2) and (not RLS_IG)  # IG locked from 2DG|IG@2.normal to 1DG|IG@1.normal
        N_F_IG = (F_IG or LK_R7 or LK_R9 or LK_R1 or LK_R3) and (not RLS_IG)  # IG firmly locked
        N_U_IG = (U_IG or NU_IG_1 or NU_IG_2) and (not RLS_IG)  # IG used by a train (R9)
        N_P_IG = (P_IG or (U_IG and OCC_IG and (NU_1DG_3 or NU_2DG_2))) and (not RLS_IG)  # IG: the train went on (R9)
        N_D_IG = (D_IG or ((not VALID) and (L_IG_1 or L_IG_2)) or G_R3 or G_R9) and (not RLS_IG)  # IG: detection is not relied on, inputs were lost or a train is called on
        N_K_IIAG = K_IIAG and (not RLS_IIAG)  # IIAG: restart lock (R16)
        N_L_IIAG_1 = (L_IIAG_1 or GW_IIAG_1) and (not RLS_IIAG)  # IIAG locked from 2DG|IIAG@2.toe to E
        N_L_IIAG_2 = (L_IIAG_2 or GW_IIAG_2) and (not RLS_IIAG)  # IIAG locked from E to 2DG|IIAG@2.toe
        N_F_IIAG = (F_IIAG or LK_R11 or LK_R12 or LK_R1 or LK_R2 or LK_R3 or LK_R4) and (not RLS_IIAG)  # IIAG firmly locked
        N_U_IIAG = (U_IIAG or NU_IIAG_1 or NU_IIAG_2) and (not RLS_IIAG)  # IIAG used by a train (R9)
        N_P_IIAG = (P_IIAG or (U_IIAG and OCC_IIAG and NU_2DG_3)) and (not RLS_IIAG)  # IIAG: the train went on (R9)
        N_D_IIAG = (D_IIAG or ((not VALID) and (L_IIAG_1 or L_IIAG_2)) or G_R3 or G_R4) and (not RLS_IIAG)  # IIAG: detection is not relied on, inputs were lost or a train is called on
        N_BH_W = (BH_W or BK_W or BT_W) and (not BV_W)  # the direction at W is ours
        N_BG_W = (BG_W or BV_W) and (not (VALID and NH_W))  # the direction at W is given
        N_BY_W = (not (BG_W or BV_W)) or (VALID and NH_W)  # the direction at W is not given
        N_BN_W = (BN_W or (VALID and NN_W)) and (not BK_W)  # the neighbour at W told that he does not give the direction
        N_C_S = (PR_R1 or PR_R2) and ((PR_R1 and PR_R5) or (PR_R2 and PR_R6))  # S shows clear
        N_C_S1 = PR_R5 and PR_R5  # S1 shows clear
        N_C_S3 = PR_R6 and PR_R6  # S3 shows clear
        N_C_X = (PR_R7 or PR_R8) and ((PR_R7 and PR_R11) or (PR_R8 and PR_R12))  # X shows clear
        N_C_X1 = PR_R11 and PR_R11  # X1 shows clear
        N_C_X3 = PR_R12 and PR_R12  # X3 shows clear
        self.state = {
            'CN_1': bool(N_CN_1),
            'CR_1': bool(N_CR_1),
            'CN_2': bool(N_CN_2),
            'CR_2': bool(N_CR_2),
            'AL_1': bool(N_AL_1),
            'AL_2': bool(N_AL_2),
            'TH_1': bool(N_TH_1),
            'TR_1': bool(N_TR_1),
            'TH_2': bool(N_TH_2),
            'TR_2': bool(N_TR_2),
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
            'A_R11': bool(N_A_R11),
            'B_R11': bool(N_B_R11),
            'W_R11': bool(N_W_R11),
            'S_R11': bool(N_S_R11),
            'H_R11': bool(N_H_R11),
            'A_R12': bool(N_A_R12),
            'B_R12': bool(N_B_R12),
            'W_R12': bool(N_W_R12),
            'S_R12': bool(N_S_R12),
            'H_R12': bool(N_H_R12),
            'X_S': bool(N_X_S),
            'X_S1': bool(N_X_S1),
            'X_S3': bool(N_X_S3),
            'X_X': bool(N_X_X),
            'X_X1': bool(N_X_X1),
            'X_X3': bool(N_X_X3),
            'K_1DG': bool(N_K_1DG),
            'L_1DG_1': bool(N_L_1DG_1),
            'L_1DG_2': bool(N_L_1DG_2),
            'L_1DG_3': bool(N_L_1DG_3),
            'L_1DG_4': bool(N_L_1DG_4),
            'F_1DG': bool(N_F_1DG),
            'U_1DG': bool(N_U_1DG),
            'P_1DG': bool(N_P_1DG),
            'D_1DG': bool(N_D_1DG),
            'K_2DG': bool(N_K_2DG),
            'L_2DG_1': bool(N_L_2DG_1),
            'L_2DG_2': bool(N_L_2DG_2),
            'L_2DG_3': bool(N_L_2DG_3),
            'L_2DG_4': bool(N_L_2DG_4),
            'F_2DG': bool(N_F_2DG),
            'U_2DG': bool(N_U_2DG),
            'P_2DG': bool(N_P_2DG),
            'D_2DG': bool(N_D_2DG),
            'K_3G': bool(N_K_3G),
            'L_3G_1': bool(N_L_3G_1),
            'L_3G_2': bool(N_L_3G_2),
            'F_3G': bool(N_F_3G),
            'U_3G': bool(N_U_3G),
            'P_3G': bool(N_P_3G),
            'D_3G': bool(N_D_3G),
            'K_IAG': bool(N_K_IAG),
            'L_IAG_1': bool(N_L_IAG_1),
            'L_IAG_2': bool(N_L_IAG_2),
            'F_IAG': bool(N_F_IAG),
            'U_IAG': bool(N_U_IAG),
            'P_IAG': bool(N_P_IAG),
            'D_IAG': bool(N_D_IAG),
            'K_IG': bool(N_K_IG),
            'L_IG_1': bool(N_L_IG_1),
            'L_IG_2': bool(N_L_IG_2),
            'F_IG': bool(N_F_IG),
            'U_IG': bool(N_U_IG),
            'P_IG': bool(N_P_IG),
            'D_IG': bool(N_D_IG),
            'K_IIAG': bool(N_K_IIAG),
            'L_IIAG_1': bool(N_L_IIAG_1),
            'L_IIAG_2': bool(N_L_IIAG_2),
            'F_IIAG': bool(N_F_IIAG),
            'U_IIAG': bool(N_U_IIAG),
            'P_IIAG': bool(N_P_IIAG),
            'D_IIAG': bool(N_D_IIAG),
            'BH_W': bool(N_BH_W),
            'BG_W': bool(N_BG_W),
            'BY_W': bool(N_BY_W),
            'BN_W': bool(N_BN_W),
            'C_S': bool(N_C_S),
            'C_S1': bool(N_C_S1),
            'C_S3': bool(N_C_S3),
            'C_X': bool(N_C_X),
            'C_X1': bool(N_C_X1),
            'C_X3': bool(N_C_X3),
        }
        CN_1 = self.state['CN_1']
        CR_1 = self.state['CR_1']
        CN_2 = self.state['CN_2']
        CR_2 = self.state['CR_2']
        AL_1 = self.state['AL_1']
        AL_2 = self.state['AL_2']
        TH_1 = self.state['TH_1']
        TR_1 = self.state['TR_1']
        TH_2 = self.state['TH_2']
        TR_2 = self.state['TR_2']
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
        A_R11 = self.state['A_R11']
        B_R11 = self.state['B_R11']
        W_R11 = self.state['W_R11']
        S_R11 = self.state['S_R11']
        H_R11 = self.state['H_R11']
        A_R12 = self.state['A_R12']
        B_R12 = self.state['B_R12']
        W_R12 = self.state['W_R12']
        S_R12 = self.state['S_R12']
        H_R12 = self.state['H_R12']
        X_S = self.state['X_S']
        X_S1 = self.state['X_S1']
        X_S3 = self.state['X_S3']
        X_X = self.state['X_X']
        X_X1 = self.state['X_X1']
        X_X3 = self.state['X_X3']
        K_1DG = self.state['K_1DG']
        L_1DG_1 = self.state['L_1DG_1']
        L_1DG_2 = self.state['L_1DG_2']
        L_1DG_3 = self.state['L_1DG_3']
        L_1DG_4 = self.state['L_1DG_4']
        F_1DG = self.state['F_1DG']
        U_1DG = self.state['U_1DG']
        P_1DG = self.state['P_1DG']
        D_1DG = self.state['D_1DG']
        K_2DG = self.state['K_2DG']
        L_2DG_1 = self.state['L_2DG_1']
        L_2DG_2 = self.state['L_2DG_2']
        L_2DG_3 = self.state['L_2DG_3']
        L_2DG_4 = self.state['L_2DG_4']
        F_2DG = self.state['F_2DG']
        U_2DG = self.state['U_2DG']
        P_2DG = self.state['P_2DG']
        D_2DG = self.state['D_2DG']
        K_3G = self.state['K_3G']
        L_3G_1 = self.state['L_3G_1']
        L_3G_2 = self.state['L_3G_2']
        F_3G = self.state['F_3G']
        U_3G = self.state['U_3G']
        P_3G = self.state['P_3G']
        D_3G = self.state['D_3G']
        K_IAG = self.state['K_IAG']
        L_IAG_1 = self.state['L_IAG_1']
        L_IAG_2 = self.state['L_IAG_2']
        F_IAG = self.state['F_IAG']
        U_IAG = self.state['U_IAG']
        P_IAG = self.state['P_IAG']
        D_IAG = self.state['D_IAG']
        K_IG = self.state['K_IG']
        L_IG_1 = self.state['L_IG_1']
        L_IG_2 = self.state['L_IG_2']
        F_IG = self.state['F_IG']
        U_IG = self.state['U_IG']
        P_IG = self.state['P_IG']
        D_IG = self.state['D_IG']
        K_IIAG = self.state['K_IIAG']
        L_IIAG_1 = self.state['L_IIAG_1']
        L_IIAG_2 = self.state['L_IIAG_2']
        F_IIAG = self.state['F_IIAG']
        U_IIAG = self.state['U_IIAG']
        P_IIAG = self.state['P_IIAG']
        D_IIAG = self.state['D_IIAG']
        BH_W = self.state['BH_W']
        BG_W = self.state['BG_W']
        BY_W = self.state['BY_W']
        BN_W = self.state['BN_W']
        C_S = self.state['C_S']
        C_S1 = self.state['C_S1']
        C_S3 = self.state['C_S3']
        C_X = self.state['C_X']
        C_X1 = self.state['C_X1']
        C_X3 = self.state['C_X3']
        return {
            'YN_1': bool(CN_1),
            'YR_1': bool(CR_1),
            'YN_2': bool(CN_2),
            'YR_2': bool(CR_2),
            'YA_1': bool(AL_1),
            'YA_2': bool(AL_2),
            'YT_1': bool(TR_1),
            'YT_2': bool(TR_2),
            'YL_1DG': bool(K_1DG or L_1DG_1 or L_1DG_2 or L_1DG_3 or L_1DG_4),
            'YL_2DG': bool(K_2DG or L_2DG_1 or L_2DG_2 or L_2DG_3 or L_2DG_4),
            'YL_3G': bool(K_3G or L_3G_1 or L_3G_2),
            'YL_IAG': bool(K_IAG or L_IAG_1 or L_IAG_2),
            'YL_IG': bool(K_IG or L_IG_1 or L_IG_2),
            'YL_IIAG': bool(K_IIAG or L_IIAG_1 or L_IIAG_2),
            'YTA_W': bool(L_IAG_1 and (not BH_W)),
            'YTG_W': bool(BG_W),
            'YTN_W': bool(BY_W),
            'YTH_W': bool(BH_W),
            'YP_S': bool(C_S),
            'YY_S': bool((S_R1 or S_R2) and (not C_S)),
            'YO_S': bool(S_R3 or S_R4),
            'YS_S': bool((not (S_R1 or S_R2))),
            'YP_S1': bool(C_S1),
            'YY_S1': bool(S_R5 and (not C_S1)),
            'YS_S1': bool((not S_R5)),
            'YP_S3': bool(C_S3),
            'YY_S3': bool(S_R6 and (not C_S3)),
            'YS_S3': bool((not S_R6)),
            'YP_X': bool(C_X),
            'YY_X': bool((S_R7 or S_R8) and (not C_X)),
            'YO_X': bool(S_R9 or S_R10),
            'YS_X': bool((not (S_R7 or S_R8))),
            'YP_X1': bool(C_X1),
            'YY_X1': bool(S_R11 and (not C_X1)),
            'YS_X1': bool((not S_R11)),
            'YP_X3': bool(C_X3),
            'YY_X3': bool(S_R12 and (not C_X3)),
            'YS_X3': bool((not S_R12)),
        }
