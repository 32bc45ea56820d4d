# Interlocking crossing_line, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout ab7beca2f85ac198614f767581f5aad7aa275ef1defeef86dbd5d0cfc86b75ce
# claims f2417952bcb882db2f991c709531d7d5b87fc3e71ef5dea5a83c284ef6f0f611
"""Interlocking crossing_line: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_E1': (0, 2),  # operator: cancel the route from E1
    'CAN_E2': (0, 2),  # operator: cancel the route from E2
    'CAN_E3': (0, 2),  # operator: cancel the route from E3
    'CAN_L1': (0, 2),  # operator: cancel the route from L1
    'CAN_M': (0, 2),  # operator: cancel the route from M
    'CAN_W1': (0, 2),  # operator: cancel the route from W1
    'CAN_W2': (0, 2),  # operator: cancel the route from W2
    'CAN_W3': (0, 2),  # operator: cancel the route from W3
    'REQ': (0, 10),  # operator: set route number, 0 = none
    'CLR_ea': (0, 2),  # section ea reported clear
    'CLR_ld': (0, 2),  # section ld reported clear
    'CLR_s1': (0, 2),  # section s1 reported clear
    'CLR_s2': (0, 2),  # section s2 reported clear
    'CLR_s3': (0, 2),  # section s3 reported clear
    'CLR_s4': (0, 2),  # section s4 reported clear
    'CLR_s5': (0, 2),  # section s5 reported clear
    'CLR_wa': (0, 2),  # section wa reported clear
    'REL_ld': (0, 2),  # operator: release section ld (hold until released)
    'REL_s1': (0, 2),  # operator: release section s1 (hold until released)
    'REL_s2': (0, 2),  # operator: release section s2 (hold until released)
    'REL_s3': (0, 2),  # operator: release section s3 (hold until released)
    'REL_s4': (0, 2),  # operator: release section s4 (hold until released)
    'REL_s5': (0, 2),  # operator: release section s5 (hold until released)
    'BLK_ld': (1, 2),  # operator: section ld is blocked
    'BLK_s1': (1, 2),  # operator: section s1 is blocked
    'BLK_s2': (1, 2),  # operator: section s2 is blocked
    'BLK_s3': (1, 2),  # operator: section s3 is blocked
    'BLK_s4': (1, 2),  # operator: section s4 is blocked
    'BLK_s5': (1, 2),  # operator: section s5 is blocked
    'RELALL': (0, 2),  # operator: release all clear sections after a restart
    'DN_LC1': (0, 2),  # machine LC1 detected open
    'DR_LC1': (0, 2),  # machine LC1 detected closed
    'MN_LC1': (0, 2),  # operator: move machine LC1 open
    'MR_LC1': (0, 2),  # operator: move machine LC1 closed
    'DN_LC2': (0, 2),  # machine LC2 detected open
    'DR_LC2': (0, 2),  # machine LC2 detected closed
    'MN_LC2': (0, 2),  # operator: move machine LC2 open
    'MR_LC2': (0, 2),  # operator: move machine LC2 closed
    'DN_P1': (0, 2),  # machine P1 detected normal
    'DR_P1': (0, 2),  # machine P1 detected reverse
    'MN_P1': (0, 2),  # operator: move machine P1 normal
    'MR_P1': (0, 2),  # operator: move machine P1 reverse
    'TC_P1': (0, 2),  # operator: machine P1 has been looked at after it was trailed
}
# name: value at a restart, meaning
STATE = {
    'CN_LC1': False,  # machine LC1 commanded N
    'CR_LC1': False,  # machine LC1 commanded R
    'CN_LC2': False,  # machine LC2 commanded N
    'CR_LC2': False,  # machine LC2 commanded R
    'CN_P1': False,  # machine P1 commanded N
    'CR_P1': False,  # machine P1 commanded R
    'AL_LC1': False,  # alarm: machine LC1 not detected
    'AL_LC2': False,  # alarm: machine LC2 not detected
    'AL_P1': False,  # alarm: machine P1 not detected
    'TH_P1': False,  # machine P1 was detected where it is commanded
    'TR_P1': False,  # machine P1 was trailed
    'A_R1': False,  # route E1-E2 active
    'B_R1': False,  # route E1-E2 locked
    'W_R1': False,  # route E1-E2: proceed wanted
    'S_R1': False,  # route E1-E2: proceed
    'H_R1': False,  # route E1-E2: signal has been open
    'A_R2': False,  # route E2-E3 active
    'B_R2': False,  # route E2-E3 locked
    'W_R2': False,  # route E2-E3: proceed wanted
    'S_R2': False,  # route E2-E3: proceed
    'H_R2': False,  # route E2-E3: signal has been open
    'A_R3': False,  # route E3-W active
    'B_R3': False,  # route E3-W locked
    'W_R3': False,  # route E3-W: proceed wanted
    'S_R3': False,  # route E3-W: proceed
    'H_R3': False,  # route E3-W: signal has been open
    'A_R4': False,  # route L1-E3 active
    'B_R4': False,  # route L1-E3 locked
    'W_R4': False,  # route L1-E3: proceed wanted
    'S_R4': False,  # route L1-E3: proceed
    'H_R4': False,  # route L1-E3: signal has been open
    'A_R5': False,  # route M-E active
    'B_R5': False,  # route M-E locked
    'W_R5': False,  # route M-E: proceed wanted
    'S_R5': False,  # route M-E: proceed
    'H_R5': False,  # route M-E: signal has been open
    'A_R6': False,  # route W1-W2 active
    'B_R6': False,  # route W1-W2 locked
    'W_R6': False,  # route W1-W2: proceed wanted
    'S_R6': False,  # route W1-W2: proceed
    'H_R6': False,  # route W1-W2: signal has been open
    'A_R7': False,  # route W2-W3 active
    'B_R7': False,  # route W2-W3 locked
    'W_R7': False,  # route W2-W3: proceed wanted
    'S_R7': False,  # route W2-W3: proceed
    'H_R7': False,  # route W2-W3: signal has been open
    'A_R8': False,  # route W3-LOAD active
    'B_R8': False,  # route W3-LOAD locked
    'W_R8': False,  # route W3-LOAD: proceed wanted
    'S_R8': False,  # route W3-LOAD: proceed
    'H_R8': False,  # route W3-LOAD: signal has been open
    'A_R9': False,  # route W3-M active
    'B_R9': False,  # route W3-M locked
    'W_R9': False,  # route W3-M: proceed wanted
    'S_R9': False,  # route W3-M: proceed
    'H_R9': False,  # route W3-M: signal has been open
    'X_E1': False,  # E1: cancelling
    'X_E2': False,  # E2: cancelling
    'X_E3': False,  # E3: cancelling
    'X_L1': False,  # L1: cancelling
    'X_M': False,  # M: cancelling
    'X_W1': False,  # W1: cancelling
    'X_W2': False,  # W2: cancelling
    'X_W3': False,  # W3: cancelling
    'K_ld': True,  # ld: restart lock (R16)
    'L_ld_2': False,  # ld locked from ld|s3@P1.reverse to LOAD
    'F_ld': False,  # ld firmly locked
    'U_ld': True,  # ld used by a train (R9)
    'P_ld': False,  # ld: the train went on (R9)
    'D_ld': False,  # ld: detection is not relied on, inputs were lost or a train is called on
    'K_s1': True,  # s1: restart lock (R16)
    'L_s1_1': False,  # s1 locked from W to s1|s2@west.0
    'L_s1_2': False,  # s1 locked from s1|s2@west.0 to W
    'F_s1': False,  # s1 firmly locked
    'U_s1': True,  # s1 used by a train (R9)
    'P_s1': False,  # s1: the train went on (R9)
    'D_s1': False,  # s1: detection is not relied on, inputs were lost or a train is called on
    'K_s2': True,  # s2: restart lock (R16)
    'L_s2_1': False,  # s2 locked from s1|s2@west.0 to s2|s3@P1.toe
    'L_s2_2': False,  # s2 locked from s2|s3@P1.toe to s1|s2@west.0
    'F_s2': False,  # s2 firmly locked
    'U_s2': True,  # s2 used by a train (R9)
    'P_s2': False,  # s2: the train went on (R9)
    'D_s2': False,  # s2: detection is not relied on, inputs were lost or a train is called on
    'K_s3': True,  # s3: restart lock (R16)
    'L_s3_1': False,  # s3 locked from ld|s3@P1.reverse to s2|s3@P1.toe
    'L_s3_2': False,  # s3 locked from s2|s3@P1.toe to ld|s3@P1.reverse
    'L_s3_3': False,  # s3 locked from s2|s3@P1.toe to s3|s4@P1.normal
    'L_s3_4': False,  # s3 locked from s3|s4@P1.normal to s2|s3@P1.toe
    'F_s3': False,  # s3 firmly locked
    'U_s3': True,  # s3 used by a train (R9)
    'P_s3': False,  # s3: the train went on (R9)
    'D_s3': False,  # s3: detection is not relied on, inputs were lost or a train is called on
    'K_s4': True,  # s4: restart lock (R16)
    'L_s4_1': False,  # s4 locked from s3|s4@P1.normal to s4|s5@mid.0
    'L_s4_2': False,  # s4 locked from s4|s5@mid.0 to s3|s4@P1.normal
    'F_s4': False,  # s4 firmly locked
    'U_s4': True,  # s4 used by a train (R9)
    'P_s4': False,  # s4: the train went on (R9)
    'D_s4': False,  # s4: detection is not relied on, inputs were lost or a train is called on
    'K_s5': True,  # s5: restart lock (R16)
    'L_s5_1': False,  # s5 locked from E to s4|s5@mid.0
    'L_s5_2': False,  # s5 locked from s4|s5@mid.0 to E
    'F_s5': False,  # s5 firmly locked
    'U_s5': True,  # s5 used by a train (R9)
    'P_s5': False,  # s5: the train went on (R9)
    'D_s5': False,  # s5: detection is not relied on, inputs were lost or a train is called on
    'V_M_1': False,  # overlap 1 of M held
    'V_W2_1': False,  # overlap 1 of W2 held
    'VF_M': False,  # overlap of M firmly held
    'VF_W2': False,  # overlap of W2 firmly held
    'C_E1': False,  # E1 shows clear
    'C_E2': False,  # E2 shows clear
    'C_E3': False,  # E3 shows clear
    'C_L1': False,  # L1 shows clear
    'C_M': False,  # M shows clear
    'C_W1': False,  # W1 shows clear
    'C_W2': False,  # W2 shows clear
    'C_W3': False,  # W3 shows clear
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_E1': 180000,  # E1: approach locking delay (R8)
    'AT_E2': 180000,  # E2: approach locking delay (R8)
    'AT_E3': 180000,  # E3: approach locking delay (R8)
    'AT_L1': 180000,  # L1: approach locking delay (R8)
    'AT_M': 180000,  # M: approach locking delay (R8)
    'AT_W1': 180000,  # W1: approach locking delay (R8)
    'AT_W2': 180000,  # W2: approach locking delay (R8)
    'AT_W3': 180000,  # W3: approach locking delay (R8)
    'RT_ld': 3000,  # ld: release delay (R9)
    'RT_s1': 3000,  # s1: release delay (R9)
    'RT_s2': 3000,  # s2: release delay (R9)
    'RT_s3': 3000,  # s3: release delay (R9)
    'RT_s4': 3000,  # s4: release delay (R9)
    'RT_s5': 3000,  # s5: release delay (R9)
    'OT_M': 60000,  # M: the train before it stands (R4)
    'OT_W2': 60000,  # W2: the train before it stands (R4)
    'ST_LC1': 13000,  # machine LC1: time-out
    'ST_LC2': 13000,  # machine LC2: time-out
    'ST_P1': 13000,  # machine P1: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_LC1': False,  # machine LC1: open
    'YR_LC1': False,  # machine LC1: closed
    'YN_LC2': False,  # machine LC2: open
    'YR_LC2': False,  # machine LC2: closed
    'YN_P1': False,  # machine P1: normal
    'YR_P1': False,  # machine P1: reverse
    'YA_LC1': False,  # alarm: machine LC1 not detected in time
    'YA_LC2': False,  # alarm: machine LC2 not detected in time
    'YA_P1': False,  # alarm: machine P1 not detected in time
    'YT_P1': False,  # alarm: machine P1 was trailed
    'YL_ld': True,  # indication: ld is locked
    'YL_s1': True,  # indication: s1 is locked
    'YL_s2': True,  # indication: s2 is locked
    'YL_s3': True,  # indication: s3 is locked
    'YL_s4': True,  # indication: s4 is locked
    'YL_s5': True,  # indication: s5 is locked
    'YP_E1': False,  # signal E1: clear (green)
    'YY_E1': False,  # signal E1: caution (yellow)
    'YS_E1': True,  # signal E1: stop
    'YP_E2': False,  # signal E2: clear (green)
    'YY_E2': False,  # signal E2: caution (yellow)
    'YS_E2': True,  # signal E2: stop
    'YP_E3': False,  # signal E3: clear (green)
    'YY_E3': False,  # signal E3: caution (yellow)
    'YS_E3': True,  # signal E3: stop
    'YP_L1': False,  # signal L1: clear (green)
    'YY_L1': False,  # signal L1: caution (yellow)
    'YS_L1': True,  # signal L1: stop
    'YP_M': False,  # signal M: clear (green)
    'YY_M': False,  # signal M: caution (yellow)
    'YS_M': True,  # signal M: stop
    'YP_W1': False,  # signal W1: clear (green)
    'YY_W1': False,  # signal W1: caution (yellow)
    'YS_W1': True,  # signal W1: stop
    'YP_W2': False,  # signal W2: clear (green)
    'YY_W2': False,  # signal W2: caution (yellow)
    'YS_W2': True,  # signal W2: stop
    'YP_W3': False,  # signal W3: clear (green)
    'YY_W3': False,  # signal W3: caution (yellow)
    'YS_W3': True,  # signal W3: stop
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
        CAN_E1 = read['CAN_E1']
        CAN_E2 = read['CAN_E2']
        CAN_E3 = read['CAN_E3']
        CAN_L1 = read['CAN_L1']
        CAN_M = read['CAN_M']
        CAN_W1 = read['CAN_W1']
        CAN_W2 = read['CAN_W2']
        CAN_W3 = read['CAN_W3']
        REQ = read['REQ']
        CLR_ea = read['CLR_ea']
        CLR_ld = read['CLR_ld']
        CLR_s1 = read['CLR_s1']
        CLR_s2 = read['CLR_s2']
        CLR_s3 = read['CLR_s3']
        CLR_s4 = read['CLR_s4']
        CLR_s5 = read['CLR_s5']
        CLR_wa = read['CLR_wa']
        REL_ld = read['REL_ld']
        REL_s1 = read['REL_s1']
        REL_s2 = read['REL_s2']
        REL_s3 = read['REL_s3']
        REL_s4 = read['REL_s4']
        REL_s5 = read['REL_s5']
        BLK_ld = read['BLK_ld']
        BLK_s1 = read['BLK_s1']
        BLK_s2 = read['BLK_s2']
        BLK_s3 = read['BLK_s3']
        BLK_s4 = read['BLK_s4']
        BLK_s5 = read['BLK_s5']
        RELALL = read['RELALL']
        DN_LC1 = read['DN_LC1']
        DR_LC1 = read['DR_LC1']
        MN_LC1 = read['MN_LC1']
        MR_LC1 = read['MR_LC1']
        DN_LC2 = read['DN_LC2']
        DR_LC2 = read['DR_LC2']
        MN_LC2 = read['MN_LC2']
        MR_LC2 = read['MR_LC2']
        DN_P1 = read['DN_P1']
        DR_P1 = read['DR_P1']
        MN_P1 = read['MN_P1']
        MR_P1 = read['MR_P1']
        TC_P1 = read['TC_P1']
        CN_LC1 = old['CN_LC1']
        CR_LC1 = old['CR_LC1']
        CN_LC2 = old['CN_LC2']
        CR_LC2 = old['CR_LC2']
        CN_P1 = old['CN_P1']
        CR_P1 = old['CR_P1']
        AL_LC1 = old['AL_LC1']
        AL_LC2 = old['AL_LC2']
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
        X_E1 = old['X_E1']
        X_E2 = old['X_E2']
        X_E3 = old['X_E3']
        X_L1 = old['X_L1']
        X_M = old['X_M']
        X_W1 = old['X_W1']
        X_W2 = old['X_W2']
        X_W3 = old['X_W3']
        K_ld = old['K_ld']
        L_ld_2 = old['L_ld_2']
        F_ld = old['F_ld']
        U_ld = old['U_ld']
        P_ld = old['P_ld']
        D_ld = old['D_ld']
        K_s1 = old['K_s1']
        L_s1_1 = old['L_s1_1']
        L_s1_2 = old['L_s1_2']
        F_s1 = old['F_s1']
        U_s1 = old['U_s1']
        P_s1 = old['P_s1']
        D_s1 = old['D_s1']
        K_s2 = old['K_s2']
        L_s2_1 = old['L_s2_1']
        L_s2_2 = old['L_s2_2']
        F_s2 = old['F_s2']
        U_s2 = old['U_s2']
        P_s2 = old['P_s2']
        D_s2 = old['D_s2']
        K_s3 = old['K_s3']
        L_s3_1 = old['L_s3_1']
        L_s3_2 = old['L_s3_2']
        L_s3_3 = old['L_s3_3']
        L_s3_4 = old['L_s3_4']
        F_s3 = old['F_s3']
        U_s3 = old['U_s3']
        P_s3 = old['P_s3']
        D_s3 = old['D_s3']
        K_s4 = old['K_s4']
        L_s4_1 = old['L_s4_1']
        L_s4_2 = old['L_s4_2']
        F_s4 = old['F_s4']
        U_s4 = old['U_s4']
        P_s4 = old['P_s4']
        D_s4 = old['D_s4']
        K_s5 = old['K_s5']
        L_s5_1 = old['L_s5_1']
        L_s5_2 = old['L_s5_2']
        F_s5 = old['F_s5']
        U_s5 = old['U_s5']
        P_s5 = old['P_s5']
        D_s5 = old['D_s5']
        V_M_1 = old['V_M_1']
        V_W2_1 = old['V_W2_1']
        VF_M = old['VF_M']
        VF_W2 = old['VF_W2']
        C_E1 = old['C_E1']
        C_E2 = old['C_E2']
        C_E3 = old['C_E3']
        C_L1 = old['C_L1']
        C_M = old['C_M']
        C_W1 = old['C_W1']
        C_W2 = old['C_W2']
        C_W3 = old['C_W3']
        OCC_ea = (not CLR_ea) or (not VALID)  # ea counts as occupied
        OCC_ld = (not CLR_ld) or (not VALID)  # ld counts as occupied
        OCC_s1 = (not CLR_s1) or (not VALID)  # s1 counts as occupied
        OCC_s2 = (not CLR_s2) or (not VALID)  # s2 counts as occupied
        OCC_s3 = (not CLR_s3) or (not VALID)  # s3 counts as occupied
        OCC_s4 = (not CLR_s4) or (not VALID)  # s4 counts as occupied
        OCC_s5 = (not CLR_s5) or (not VALID)  # s5 counts as occupied
        OCC_wa = (not CLR_wa) or (not VALID)  # wa counts as occupied
        FREE_ld = (not K_ld) and (not L_ld_2)  # ld is not locked by anybody
        FREE_s1 = (not K_s1) and (not L_s1_1) and (not L_s1_2)  # s1 is not locked by anybody
        FREE_s2 = (not K_s2) and (not L_s2_1) and (not L_s2_2) and (not V_W2_1)  # s2 is not locked by anybody
        FREE_s3 = (not K_s3) and (not L_s3_1) and (not L_s3_2) and (not L_s3_3) and (not L_s3_4)  # s3 is not locked by anybody
        FREE_s4 = (not K_s4) and (not L_s4_1) and (not L_s4_2)  # s4 is not locked by anybody
        FREE_s5 = (not K_s5) and (not L_s5_1) and (not L_s5_2) and (not V_M_1)  # s5 is not locked by anybody
        QN_LC1 = VALID and DN_LC1 and (not DR_LC1)  # machine LC1 lies N (R10)
        QR_LC1 = VALID and DR_LC1 and (not DN_LC1)  # machine LC1 lies R (R10)
        QN_LC2 = VALID and DN_LC2 and (not DR_LC2)  # machine LC2 lies N (R10)
        QR_LC2 = VALID and DR_LC2 and (not DN_LC2)  # machine LC2 lies R (R10)
        QN_P1 = VALID and DN_P1 and (not DR_P1)  # machine P1 lies N (R10)
        QR_P1 = VALID and DR_P1 and (not DN_P1)  # machine P1 lies R (R10)
        MOV_LC1 = VALID and FREE_s2 and (not OCC_s2) and True and True  # machine LC1 is free to move (R10)
        AVN_LC1 = CN_LC1 or MOV_LC1 or (QN_LC1 and (not CN_LC1) and (not CR_LC1))  # machine LC1 can be demanded N
        AVR_LC1 = CR_LC1 or MOV_LC1 or (QR_LC1 and (not CN_LC1) and (not CR_LC1))  # machine LC1 can be demanded R
        MOV_LC2 = VALID and FREE_s3 and (not OCC_s3) and FREE_s4 and (not OCC_s4) and True and True  # machine LC2 is free to move (R10)
        AVN_LC2 = CN_LC2 or MOV_LC2 or (QN_LC2 and (not CN_LC2) and (not CR_LC2))  # machine LC2 can be demanded N
        AVR_LC2 = CR_LC2 or MOV_LC2 or (QR_LC2 and (not CN_LC2) and (not CR_LC2))  # machine LC2 can be demanded R
        MOV_P1 = VALID and FREE_s3 and (not OCC_s3) and True and True  # machine P1 is free to move (R10)
        AVN_P1 = CN_P1 or MOV_P1 or (QN_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded N
        AVR_P1 = CR_P1 or MOV_P1 or (QR_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded R
        WF_ld_2 = FREE_ld and (not OCC_ld) and (not BLK_ld)  # ld from ld|s3@P1.reverse to LOAD: free for a route (R6)
        WF_s1_1 = FREE_s1 and (not OCC_s1) and (not BLK_s1)  # s1 from W to s1|s2@west.0: free for a route (R6)
        WF_s1_2 = FREE_s1 and (not OCC_s1) and (not BLK_s1)  # s1 from s1|s2@west.0 to W: free for a route (R6)
        WA_s2_1 = AVR_LC1  # s2 from s1|s2@west.0 to s2|s3@P1.toe: could be locked
        WF_s2_1 = FREE_s2 and (not OCC_s2) and (not BLK_s2) and WA_s2_1  # s2 from s1|s2@west.0 to s2|s3@P1.toe: free for a route (R6)
        WA_s2_2 = AVR_LC1  # s2 from s2|s3@P1.toe to s1|s2@west.0: could be locked
        WF_s2_2 = FREE_s2 and (not OCC_s2) and (not BLK_s2) and WA_s2_2  # s2 from s2|s3@P1.toe to s1|s2@west.0: free for a route (R6)
        WA_s3_1 = AVR_P1 and AVR_LC2 and (not TR_P1)  # s3 from ld|s3@P1.reverse to s2|s3@P1.toe: could be locked
        WF_s3_1 = FREE_s3 and (not OCC_s3) and (not BLK_s3) and WA_s3_1  # s3 from ld|s3@P1.reverse to s2|s3@P1.toe: free for a route (R6)
        WA_s3_2 = AVR_P1 and AVR_LC2 and (not TR_P1)  # s3 from s2|s3@P1.toe to ld|s3@P1.reverse: could be locked
        WF_s3_2 = FREE_s3 and (not OCC_s3) and (not BLK_s3) and WA_s3_2  # s3 from s2|s3@P1.toe to ld|s3@P1.reverse: free for a route (R6)
        WA_s3_3 = AVN_P1 and AVR_LC2 and (not TR_P1)  # s3 from s2|s3@P1.toe to s3|s4@P1.normal: could be locked
        WF_s3_3 = FREE_s3 and (not OCC_s3) and (not BLK_s3) and WA_s3_3  # s3 from s2|s3@P1.toe to s3|s4@P1.normal: free for a route (R6)
        WA_s3_4 = AVN_P1 and AVR_LC2 and (not TR_P1)  # s3 from s3|s4@P1.normal to s2|s3@P1.toe: could be locked
        WF_s3_4 = FREE_s3 and (not OCC_s3) and (not BLK_s3) and WA_s3_4  # s3 from s3|s4@P1.normal to s2|s3@P1.toe: free for a route (R6)
        WA_s4_1 = AVR_LC2  # s4 from s3|s4@P1.normal to s4|s5@mid.0: could be locked
        WF_s4_1 = FREE_s4 and (not OCC_s4) and (not BLK_s4) and WA_s4_1  # s4 from s3|s4@P1.normal to s4|s5@mid.0: free for a route (R6)
        WA_s4_2 = AVR_LC2  # s4 from s4|s5@mid.0 to s3|s4@P1.normal: could be locked
        WF_s4_2 = FREE_s4 and (not OCC_s4) and (not BLK_s4) and WA_s4_2  # s4 from s4|s5@mid.0 to s3|s4@P1.normal: free for a route (R6)
        WF_s5_1 = FREE_s5 and (not OCC_s5) and (not BLK_s5)  # s5 from E to s4|s5@mid.0: free for a route (R6)
        WF_s5_2 = FREE_s5 and (not OCC_s5) and (not BLK_s5)  # s5 from s4|s5@mid.0 to E: free for a route (R6)
        OF_M_1 = ((not K_s5) and (not V_M_1) and (not L_s5_1) and ((not L_s5_2) or A_R5)) and (not OCC_s5) and (not BLK_s5)  # overlap 1 of M may be held (R4)
        OF_W2_1 = ((not K_s2) and (not V_W2_1) and ((not L_s2_1) or A_R7) and (not L_s2_2)) and (not OCC_s2) and (not BLK_s2) and WA_s2_1  # overlap 1 of W2 may be held (R4)
        WL_ld_2 = (not OCC_ld)  # ld from ld|s3@P1.reverse to LOAD: lies and is clear
        WP_ld_2 = WL_ld_2 and (not BLK_ld)  # ld from ld|s3@P1.reverse to LOAD: proceed may be shown over it (R3)
        WL_s1_1 = (not OCC_s1)  # s1 from W to s1|s2@west.0: lies and is clear
        WP_s1_1 = WL_s1_1 and (not BLK_s1)  # s1 from W to s1|s2@west.0: proceed may be shown over it (R3)
        WL_s1_2 = (not OCC_s1)  # s1 from s1|s2@west.0 to W: lies and is clear
        WP_s1_2 = WL_s1_2 and (not BLK_s1)  # s1 from s1|s2@west.0 to W: proceed may be shown over it (R3)
        WD_s2_1 = QR_LC1  # s2 from s1|s2@west.0 to s2|s3@P1.toe: its points lie, nothing is foul of it
        WL_s2_1 = (not OCC_s2) and WD_s2_1  # s2 from s1|s2@west.0 to s2|s3@P1.toe: lies and is clear
        WP_s2_1 = WL_s2_1 and (not BLK_s2)  # s2 from s1|s2@west.0 to s2|s3@P1.toe: proceed may be shown over it (R3)
        WD_s2_2 = QR_LC1  # s2 from s2|s3@P1.toe to s1|s2@west.0: its points lie, nothing is foul of it
        WL_s2_2 = (not OCC_s2) and WD_s2_2  # s2 from s2|s3@P1.toe to s1|s2@west.0: lies and is clear
        WP_s2_2 = WL_s2_2 and (not BLK_s2)  # s2 from s2|s3@P1.toe to s1|s2@west.0: proceed may be shown over it (R3)
        WD_s3_1 = QR_P1 and QR_LC2 and (not TR_P1)  # s3 from ld|s3@P1.reverse to s2|s3@P1.toe: its points lie, nothing is foul of it
        WL_s3_1 = (not OCC_s3) and WD_s3_1  # s3 from ld|s3@P1.reverse to s2|s3@P1.toe: lies and is clear
        WP_s3_1 = WL_s3_1 and (not BLK_s3)  # s3 from ld|s3@P1.reverse to s2|s3@P1.toe: proceed may be shown over it (R3)
        WD_s3_2 = QR_P1 and QR_LC2 and (not TR_P1)  # s3 from s2|s3@P1.toe to ld|s3@P1.reverse: its points lie, nothing is foul of it
        WL_s3_2 = (not OCC_s3) and WD_s3_2  # s3 from s2|s3@P1.toe to ld|s3@P1.reverse: lies and is clear
        WP_s3_2 = WL_s3_2 and (not BLK_s3)  # s3 from s2|s3@P1.toe to ld|s3@P1.reverse: proceed may be shown over it (R3)
        WD_s3_3 = QN_P1 and QR_LC2 and (not TR_P1)  # s3 from s2|s3@P1.toe to s3|s4@P1.normal: its points lie, nothing is foul of it
        WL_s3_3 = (not OCC_s3) and WD_s3_3  # s3 from s2|s3@P1.toe to s3|s4@P1.normal: lies and is clear
        WP_s3_3 = WL_s3_3 and (not BLK_s3)  # s3 from s2|s3@P1.toe to s3|s4@P1.normal: proceed may be shown over it (R3)
        WD_s3_4 = QN_P1 and QR_LC2 and (not TR_P1)  # s3 from s3|s4@P1.normal to s2|s3@P1.toe: its points lie, nothing is foul of it
        WL_s3_4 = (not OCC_s3) and WD_s3_4  # s3 from s3|s4@P1.normal to s2|s3@P1.toe: lies and is clear
        WP_s3_4 = WL_s3_4 and (not BLK_s3)  # s3 from s3|s4@P1.normal to s2|s3@P1.toe: proceed may be shown over it (R3)
        WD_s4_1 = QR_LC2  # s4 from s3|s4@P1.normal to s4|s5@mid.0: its points lie, nothing is foul of it
        WL_s4_1 = (not OCC_s4) and WD_s4_1  # s4 from s3|s4@P1.normal to s4|s5@mid.0: lies and is clear
        WP_s4_1 = WL_s4_1 and (not BLK_s4)  # s4 from s3|s4@P1.normal to s4|s5@mid.0: proceed may be shown over it (R3)
        WD_s4_2 = QR_LC2  # s4 from s4|s5@mid.0 to s3|s4@P1.normal: its points lie, nothing is foul of it
        WL_s4_2 = (not OCC_s4) and WD_s4_2  # s4 from s4|s5@mid.0 to s3|s4@P1.normal: lies and is clear
        WP_s4_2 = WL_s4_2 and (not BLK_s4)  # s4 from s4|s5@mid.0 to s3|s4@P1.normal: proceed may be shown over it (R3)
        WL_s5_1 = (not OCC_s5)  # s5 from E to s4|s5@mid.0: lies and is clear
        WP_s5_1 = WL_s5_1 and (not BLK_s5)  # s5 from E to s4|s5@mid.0: proceed may be shown over it (R3)
        WL_s5_2 = (not OCC_s5)  # s5 from s4|s5@mid.0 to E: lies and is clear
        WP_s5_2 = WL_s5_2 and (not BLK_s5)  # s5 from s4|s5@mid.0 to E: proceed may be shown over it (R3)
        G_R1 = (REQ == 1) and VALID and WF_s5_1  # grant of route E1-E2 (R6)
        G_R2 = (REQ == 2) and VALID and WF_s4_2 and WF_s3_4 and WF_s2_2  # grant of route E2-E3 (R6)
        G_R3 = (REQ == 3) and VALID and WF_s1_2  # grant of route E3-W (R6)
        G_R4 = (REQ == 4) and VALID and WF_s3_1 and WF_s2_2  # grant of route L1-E3 (R6)
        G_R5 = (REQ == 5) and VALID and ((not K_s5) and (not L_s5_1) and (not L_s5_2)) and (not OCC_s5) and (not BLK_s5)  # grant of route M-E (R6)
        G_R6 = (REQ == 6) and VALID and WF_s1_1 and OF_W2_1  # grant of route W1-W2 (R6)
        G_R7 = (REQ == 7) and VALID and ((not K_s2) and (not L_s2_1) and (not L_s2_2)) and (not OCC_s2) and (not BLK_s2) and WA_s2_1  # grant of route W2-W3 (R6)
        G_R8 = (REQ == 8) and VALID and WF_s3_2 and WF_ld_2  # grant of route W3-LOAD (R6)
        G_R9 = (REQ == 9) and VALID and WF_s3_3 and WF_s4_1 and OF_M_1  # grant of route W3-M (R6)
        GW_ld_2 = G_R8  # ld from ld|s3@P1.reverse to LOAD: granted
        GW_s1_1 = G_R6  # s1 from W to s1|s2@west.0: granted
        GW_s1_2 = G_R3  # s1 from s1|s2@west.0 to W: granted
        GW_s2_1 = G_R7  # s2 from s1|s2@west.0 to s2|s3@P1.toe: granted
        GW_s2_2 = G_R2 or G_R4  # s2 from s2|s3@P1.toe to s1|s2@west.0: granted
        GW_s3_1 = G_R4  # s3 from ld|s3@P1.reverse to s2|s3@P1.toe: granted
        GW_s3_2 = G_R8  # s3 from s2|s3@P1.toe to ld|s3@P1.reverse: granted
        GW_s3_3 = G_R9  # s3 from s2|s3@P1.toe to s3|s4@P1.normal: granted
        GW_s3_4 = G_R2  # s3 from s3|s4@P1.normal to s2|s3@P1.toe: granted
        GW_s4_1 = G_R9  # s4 from s3|s4@P1.normal to s4|s5@mid.0: granted
        GW_s4_2 = G_R2  # s4 from s4|s5@mid.0 to s3|s4@P1.normal: granted
        GW_s5_1 = G_R1  # s5 from E to s4|s5@mid.0: granted
        GW_s5_2 = G_R5  # s5 from s4|s5@mid.0 to E: granted
        GO_M_1 = G_R9  # overlap 1 of M: granted
        GO_W2_1 = G_R6  # overlap 1 of W2: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_E1) and (not CAN_E1) and WL_s5_1  # route E1-E2 becomes locked (R3)
        CO_R1 = VALID and WP_s5_1 and (not D_s5)  # conditions of proceed for route E1-E2 (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_E2) and (not CAN_E2) and WL_s4_2 and WL_s3_4 and WL_s2_2  # route E2-E3 becomes locked (R3)
        CO_R2 = VALID and WP_s4_2 and WP_s3_4 and WP_s2_2 and (not D_s4)  # conditions of proceed for route E2-E3 (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_E3) and (not CAN_E3) and WL_s1_2  # route E3-W becomes locked (R3)
        CO_R3 = VALID and WP_s1_2 and (not OCC_wa) and (not D_s1)  # conditions of proceed for route E3-W (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_L1) and (not CAN_L1) and WL_s3_1 and WL_s2_2  # route L1-E3 becomes locked (R3)
        CO_R4 = VALID and WP_s3_1 and WP_s2_2 and (not D_s3)  # conditions of proceed for route L1-E3 (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_M) and (not CAN_M) and WL_s5_2  # route M-E becomes locked (R3)
        CO_R5 = VALID and WP_s5_2 and (not OCC_ea) and (not D_s5)  # conditions of proceed for route M-E (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_W1) and (not CAN_W1) and WL_s1_1 and WL_s2_1  # route W1-W2 becomes locked (R3)
        CO_R6 = VALID and WP_s1_1 and WL_s2_1 and (not D_s1) and V_W2_1  # conditions of proceed for route W1-W2 (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_W2) and (not CAN_W2) and WL_s2_1  # route W2-W3 becomes locked (R3)
        CO_R7 = VALID and WP_s2_1 and (not D_s2)  # conditions of proceed for route W2-W3 (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_W3) and (not CAN_W3) and WL_s3_2 and WL_ld_2  # route W3-LOAD becomes locked (R3)
        CO_R8 = VALID and WP_s3_2 and WP_ld_2 and (not D_s3)  # conditions of proceed for route W3-LOAD (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_W3) and (not CAN_W3) and WL_s3_3 and WL_s4_1 and WL_s5_2  # route W3-M becomes locked (R3)
        CO_R9 = VALID and WP_s3_3 and WP_s4_1 and WL_s5_2 and (not D_s3) and V_M_1  # conditions of proceed for route W3-M (R3)
        NU_ld_2 = VALID and F_ld and (not D_ld) and (not U_ld) and L_ld_2 and OCC_ld and OCC_s3 and U_s3 and L_s3_2  # a train comes into ld at ld|s3@P1.reverse (R9)
        NU_s1_1 = VALID and F_s1 and (not D_s1) and (not U_s1) and L_s1_1 and OCC_s1 and OCC_wa  # a train comes into s1 at W (R9)
        NU_s1_2 = VALID and F_s1 and (not D_s1) and (not U_s1) and L_s1_2 and OCC_s1 and OCC_s2  # a train comes into s1 at s1|s2@west.0 (R9)
        NU_s2_1 = VALID and F_s2 and (not D_s2) and (not U_s2) and L_s2_1 and OCC_s2 and OCC_s1  # a train comes into s2 at s1|s2@west.0 (R9)
        NU_s2_2 = VALID and F_s2 and (not D_s2) and (not U_s2) and L_s2_2 and OCC_s2 and OCC_s3 and U_s3 and (L_s3_1 or L_s3_4)  # a train comes into s2 at s2|s3@P1.toe (R9)
        NU_s3_1 = VALID and F_s3 and (not D_s3) and (not U_s3) and L_s3_1 and OCC_s3 and OCC_ld  # a train comes into s3 at ld|s3@P1.reverse (R9)
        NU_s3_2 = VALID and F_s3 and (not D_s3) and (not U_s3) and (L_s3_2 or L_s3_3) and OCC_s3 and OCC_s2  # a train comes into s3 at s2|s3@P1.toe (R9)
        NU_s3_3 = VALID and F_s3 and (not D_s3) and (not U_s3) and L_s3_4 and OCC_s3 and OCC_s4 and U_s4 and L_s4_2  # a train comes into s3 at s3|s4@P1.normal (R9)
        NU_s4_1 = VALID and F_s4 and (not D_s4) and (not U_s4) and L_s4_1 and OCC_s4 and OCC_s3 and U_s3 and L_s3_3  # a train comes into s4 at s3|s4@P1.normal (R9)
        NU_s4_2 = VALID and F_s4 and (not D_s4) and (not U_s4) and L_s4_2 and OCC_s4 and OCC_s5  # a train comes into s4 at s4|s5@mid.0 (R9)
        NU_s5_1 = VALID and F_s5 and (not D_s5) and (not U_s5) and L_s5_1 and OCC_s5 and OCC_ea  # a train comes into s5 at E (R9)
        NU_s5_2 = VALID and F_s5 and (not D_s5) and (not U_s5) and L_s5_2 and OCC_s5 and OCC_s4  # a train comes into s5 at s4|s5@mid.0 (R9)
        ATI_E1 = X_E1 or ((not A_R1) and L_s5_1 and REL_s5)  # E1 at stop, waiting for a train that may still come (R8)
        ATI_E2 = X_E2 or ((not A_R2) and L_s4_2 and REL_s4)  # E2 at stop, waiting for a train that may still come (R8)
        ATI_E3 = X_E3 or ((not A_R3) and L_s1_2 and (REL_s1 or (L_s1_2 and U_s1 and (not OCC_s1))))  # E3 at stop, waiting for a train that may still come (R8)
        ATI_L1 = X_L1 or ((not A_R4) and L_s3_1 and REL_s3)  # L1 at stop, waiting for a train that may still come (R8)
        ATI_M = X_M or ((not A_R5) and L_s5_2 and (REL_s5 or (L_s5_2 and U_s5 and (not OCC_s5))))  # M at stop, waiting for a train that may still come (R8)
        ATI_W1 = X_W1 or ((not A_R6) and L_s1_1 and REL_s1)  # W1 at stop, waiting for a train that may still come (R8)
        ATI_W2 = X_W2 or ((not A_R7) and L_s2_1 and REL_s2)  # W2 at stop, waiting for a train that may still come (R8)
        ATI_W3 = X_W3 or ((not (A_R8 or A_R9)) and (L_s3_2 or L_s3_3) and REL_s3)  # W3 at stop, waiting for a train that may still come (R8)
        AT_E1 = self._timer('AT_E1', ATI_E1, dt_ms)  # E1: approach locking delay (R8)
        AT_E2 = self._timer('AT_E2', ATI_E2, dt_ms)  # E2: approach locking delay (R8)
        AT_E3 = self._timer('AT_E3', ATI_E3, dt_ms)  # E3: approach locking delay (R8)
        AT_L1 = self._timer('AT_L1', ATI_L1, dt_ms)  # L1: approach locking delay (R8)
        AT_M = self._timer('AT_M', ATI_M, dt_ms)  # M: approach locking delay (R8)
        AT_W1 = self._timer('AT_W1', ATI_W1, dt_ms)  # W1: approach locking delay (R8)
        AT_W2 = self._timer('AT_W2', ATI_W2, dt_ms)  # W2: approach locking delay (R8)
        AT_W3 = self._timer('AT_W3', ATI_W3, dt_ms)  # W3: approach locking delay (R8)
        CD_E1 = X_E1 and A_R1 and VALID and (not OCC_s5) and ((not OCC_ea) or AT_E1 or (not H_R1))  # the route from E1 is cancelled (R8)
        CD_E2 = X_E2 and A_R2 and VALID and (not OCC_s4) and ((not OCC_s5) or AT_E2 or (not H_R2))  # the route from E2 is cancelled (R8)
        CD_E3 = X_E3 and A_R3 and VALID and (not OCC_s1) and ((not OCC_s2) or AT_E3 or (not H_R3))  # the route from E3 is cancelled (R8)
        CD_L1 = X_L1 and A_R4 and VALID and (not OCC_s3) and ((not OCC_ld) or AT_L1 or (not H_R4))  # the route from L1 is cancelled (R8)
        CD_M = X_M and A_R5 and VALID and (not OCC_s5) and ((not OCC_s4) or AT_M or (not H_R5))  # the route from M is cancelled (R8)
        CD_W1 = X_W1 and A_R6 and VALID and (not OCC_s1) and ((not OCC_wa) or AT_W1 or (not H_R6))  # the route from W1 is cancelled (R8)
        CD_W2 = X_W2 and A_R7 and VALID and (not OCC_s2) and ((not OCC_s1) or AT_W2 or (not H_R7))  # the route from W2 is cancelled (R8)
        CD_W3 = X_W3 and (A_R8 or A_R9) and VALID and (not OCC_s3) and ((not OCC_s2) or AT_W3 or (not (H_R8 or H_R9)))  # the route from W3 is cancelled (R8)
        EX_ld = P_ld  # a train in ld leaves over a boundary, or has passed on
        RTI_ld = VALID and U_ld and (not OCC_ld) and (not (L_ld_2 and L_s3_2)) and EX_ld  # ld may be released behind the train (R9)
        EX_s1 = P_s1 or (L_s1_2 and ((not OCC_s2) or AT_E3))  # a train in s1 leaves over a boundary, or has passed on
        RTI_s1 = VALID and U_s1 and (not OCC_s1) and EX_s1  # s1 may be released behind the train (R9)
        EX_s2 = P_s2  # a train in s2 leaves over a boundary, or has passed on
        RTI_s2 = VALID and U_s2 and (not OCC_s2) and (not (L_s2_2 and (L_s3_1 or L_s3_4))) and EX_s2  # s2 may be released behind the train (R9)
        EX_s3 = P_s3  # a train in s3 leaves over a boundary, or has passed on
        RTI_s3 = VALID and U_s3 and (not OCC_s3) and (not (L_s3_4 and L_s4_2)) and EX_s3  # s3 may be released behind the train (R9)
        EX_s4 = P_s4  # a train in s4 leaves over a boundary, or has passed on
        RTI_s4 = VALID and U_s4 and (not OCC_s4) and (not (L_s4_1 and L_s3_3)) and EX_s4  # s4 may be released behind the train (R9)
        EX_s5 = P_s5 or (L_s5_2 and ((not OCC_s4) or AT_M))  # a train in s5 leaves over a boundary, or has passed on
        RTI_s5 = VALID and U_s5 and (not OCC_s5) and EX_s5  # s5 may be released behind the train (R9)
        RT_ld = self._timer('RT_ld', RTI_ld, dt_ms)  # ld: release delay (R9)
        RT_s1 = self._timer('RT_s1', RTI_s1, dt_ms)  # s1: release delay (R9)
        RT_s2 = self._timer('RT_s2', RTI_s2, dt_ms)  # s2: release delay (R9)
        RT_s3 = self._timer('RT_s3', RTI_s3, dt_ms)  # s3: release delay (R9)
        RT_s4 = self._timer('RT_s4', RTI_s4, dt_ms)  # s4: release delay (R9)
        RT_s5 = self._timer('RT_s5', RTI_s5, dt_ms)  # s5: release delay (R9)
        CA_ld = VALID and (not OCC_ld) and (not U_ld) and L_ld_2 and (not (L_ld_2 and L_s3_2))  # the lock before ld was withdrawn (R8)
        HR_ld = VALID and (not OCC_ld) and (not (L_ld_2 and L_s3_2)) and REL_ld and L_ld_2  # ld released by hand (R8, section fault release)
        SR_ld = VALID and (not OCC_ld) and K_ld and (REL_ld or RELALL)  # ld released after a restart (R16)
        RLS_ld = RT_ld or CA_ld or HR_ld or SR_ld  # ld is released
        CA_s1 = VALID and (not OCC_s1) and (not U_s1) and False  # the lock before s1 was withdrawn (R8)
        HR_s1 = VALID and (not OCC_s1) and REL_s1 and (L_s1_1 or L_s1_2) and ((not L_s1_1) or ((not A_R6) and ((not OCC_wa) or AT_W1))) and ((not L_s1_2) or ((not A_R3) and ((not OCC_s2) or AT_E3)))  # s1 released by hand (R8, section fault release)
        SR_s1 = VALID and (not OCC_s1) and K_s1 and (REL_s1 or RELALL)  # s1 released after a restart (R16)
        RLS_s1 = RT_s1 or CA_s1 or CD_W1 or CD_E3 or HR_s1 or SR_s1  # s1 is released
        CA_s2 = VALID and (not OCC_s2) and (not U_s2) and L_s2_2 and (not (L_s2_2 and (L_s3_1 or L_s3_4)))  # the lock before s2 was withdrawn (R8)
        HR_s2 = VALID and (not OCC_s2) and (not (L_s2_2 and (L_s3_1 or L_s3_4))) and REL_s2 and (L_s2_1 or L_s2_2) and ((not L_s2_1) or ((not A_R7) and ((not OCC_s1) or AT_W2)))  # s2 released by hand (R8, section fault release)
        SR_s2 = VALID and (not OCC_s2) and K_s2 and (REL_s2 or RELALL)  # s2 released after a restart (R16)
        RLS_s2 = RT_s2 or CA_s2 or CD_W2 or HR_s2 or SR_s2  # s2 is released
        CA_s3 = VALID and (not OCC_s3) and (not U_s3) and L_s3_4 and (not (L_s3_4 and L_s4_2))  # the lock before s3 was withdrawn (R8)
        HR_s3 = VALID and (not OCC_s3) and (not (L_s3_4 and L_s4_2)) and REL_s3 and (L_s3_1 or L_s3_2 or L_s3_3 or L_s3_4) and ((not L_s3_1) or ((not A_R4) and ((not OCC_ld) or AT_L1))) and ((not (L_s3_2 or L_s3_3)) or ((not (A_R8 or A_R9)) and ((not OCC_s2) or AT_W3)))  # s3 released by hand (R8, section fault release)
        SR_s3 = VALID and (not OCC_s3) and K_s3 and (REL_s3 or RELALL)  # s3 released after a restart (R16)
        RLS_s3 = RT_s3 or CA_s3 or CD_L1 or CD_W3 or HR_s3 or SR_s3  # s3 is released
        CA_s4 = VALID and (not OCC_s4) and (not U_s4) and L_s4_1 and (not (L_s4_1 and L_s3_3))  # the lock before s4 was withdrawn (R8)
        HR_s4 = VALID and (not OCC_s4) and (not (L_s4_1 and L_s3_3)) and REL_s4 and (L_s4_1 or L_s4_2) and ((not L_s4_2) or ((not A_R2) and ((not OCC_s5) or AT_E2)))  # s4 released by hand (R8, section fault release)
        SR_s4 = VALID and (not OCC_s4) and K_s4 and (REL_s4 or RELALL)  # s4 released after a restart (R16)
        RLS_s4 = RT_s4 or CA_s4 or CD_E2 or HR_s4 or SR_s4  # s4 is released
        CA_s5 = VALID and (not OCC_s5) and (not U_s5) and False  # the lock before s5 was withdrawn (R8)
        HR_s5 = VALID and (not OCC_s5) and REL_s5 and (L_s5_1 or L_s5_2) and ((not L_s5_1) or ((not A_R1) and ((not OCC_ea) or AT_E1))) and ((not L_s5_2) or ((not A_R5) and ((not OCC_s4) or AT_M)))  # s5 released by hand (R8, section fault release)
        SR_s5 = VALID and (not OCC_s5) and K_s5 and (REL_s5 or RELALL)  # s5 released after a restart (R16)
        RLS_s5 = RT_s5 or CA_s5 or CD_E1 or CD_M or HR_s5 or SR_s5  # s5 is released
        OTI_M = VALID and U_s4 and (not (L_s4_1 and L_s3_3)) and (not (L_s4_2 and OCC_s5)) and L_s4_1 and OCC_s4  # the train before M is wholly in s4 (R4)
        OTI_W2 = VALID and U_s1 and (not (L_s1_1 and OCC_wa)) and (not (L_s1_2 and OCC_s2)) and L_s1_1 and OCC_s1  # the train before W2 is wholly in s1 (R4)
        OT_M = self._timer('OT_M', OTI_M, dt_ms)  # M: the train before it stands (R4)
        OT_W2 = self._timer('OT_W2', OTI_W2, dt_ms)  # W2: the train before it stands (R4)
        OR_M = (not L_s4_1) or OT_M  # the overlap of M is not needed any more (R4)
        OR_W2 = (not L_s1_1) or OT_W2  # the overlap of W2 is not needed any more (R4)
        TG_LC1 = (GW_s2_1 or GO_W2_1 or GW_s2_2)  # a grant touches machine LC1 in this scan
        GPN_LC1 = False or (MOV_LC1 and (not TG_LC1) and (not MR_LC1))  # a grant needs LC1 N
        MAN_LC1 = MN_LC1 and (not MR_LC1) and MOV_LC1 and (not TG_LC1)  # machine LC1 moved N by hand
        GPR_LC1 = (GW_s2_1 or GO_W2_1 or GW_s2_2)  # a grant needs LC1 R
        MAR_LC1 = MR_LC1 and (not MN_LC1) and MOV_LC1 and (not TG_LC1)  # machine LC1 moved R by hand
        HDN_LC1 = CN_LC1 and (not GPR_LC1) and (not MAR_LC1)  # the command N stays
        HDR_LC1 = CR_LC1 and (not GPN_LC1) and (not MAN_LC1)  # the command R stays
        TG_LC2 = (GW_s3_1 or GW_s3_2 or GW_s3_3 or GW_s3_4 or GW_s4_1 or GW_s4_2)  # a grant touches machine LC2 in this scan
        GPN_LC2 = False or (MOV_LC2 and (not TG_LC2) and (not MR_LC2))  # a grant needs LC2 N
        MAN_LC2 = MN_LC2 and (not MR_LC2) and MOV_LC2 and (not TG_LC2)  # machine LC2 moved N by hand
        GPR_LC2 = (GW_s3_1 or GW_s3_2 or GW_s3_3 or GW_s3_4 or GW_s4_1 or GW_s4_2)  # a grant needs LC2 R
        MAR_LC2 = MR_LC2 and (not MN_LC2) and MOV_LC2 and (not TG_LC2)  # machine LC2 moved R by hand
        HDN_LC2 = CN_LC2 and (not GPR_LC2) and (not MAR_LC2)  # the command N stays
        HDR_LC2 = CR_LC2 and (not GPN_LC2) and (not MAN_LC2)  # the command R stays
        TG_P1 = (GW_s3_1 or GW_s3_2 or GW_s3_3 or GW_s3_4)  # a grant touches machine P1 in this scan
        GPN_P1 = (GW_s3_3 or GW_s3_4)  # a grant needs P1 N
        MAN_P1 = MN_P1 and (not MR_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved N by hand
        GPR_P1 = (GW_s3_1 or GW_s3_2)  # a grant needs P1 R
        MAR_P1 = MR_P1 and (not MN_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved R by hand
        HDN_P1 = CN_P1 and (not GPR_P1) and (not MAR_P1)  # the command N stays
        HDR_P1 = CR_P1 and (not GPN_P1) and (not MAN_P1)  # the command R stays
        STI_LC1 = (CN_LC1 and (not QN_LC1)) or (CR_LC1 and (not QR_LC1))  # machine LC1 is not where it was commanded
        STI_LC2 = (CN_LC2 and (not QN_LC2)) or (CR_LC2 and (not QR_LC2))  # machine LC2 is not where it was commanded
        STI_P1 = (CN_P1 and (not QN_P1)) or (CR_P1 and (not QR_P1))  # machine P1 is not where it was commanded
        ST_LC1 = self._timer('ST_LC1', STI_LC1, dt_ms)  # machine LC1: time-out
        ST_LC2 = self._timer('ST_LC2', STI_LC2, dt_ms)  # machine LC2: time-out
        ST_P1 = self._timer('ST_P1', STI_P1, dt_ms)  # machine P1: time-out
        KP_R1 = (not NU_s5_1) and (not CD_E1)  # route E1-E2 stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_E1) and (not CAN_E1)  # proceed for route E1-E2 (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route E1-E2: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_s4_2) and (not CD_E2)  # route E2-E3 stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_E2) and (not CAN_E2)  # proceed for route E2-E3 (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route E2-E3: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_s1_2) and (not CD_E3)  # route E3-W stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_E3) and (not CAN_E3)  # proceed for route E3-W (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route E3-W: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_s3_1) and (not CD_L1)  # route L1-E3 stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_L1) and (not CAN_L1)  # proceed for route L1-E3 (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route L1-E3: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_s5_2) and (not CD_M)  # route M-E stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_M) and (not CAN_M)  # proceed for route M-E (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route M-E: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_s1_1) and (not CD_W1)  # route W1-W2 stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_W1) and (not CAN_W1)  # proceed for route W1-W2 (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route W1-W2: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_s2_1) and (not CD_W2)  # route W2-W3 stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_W2) and (not CAN_W2)  # proceed for route W2-W3 (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route W2-W3: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_s3_2) and (not CD_W3)  # route W3-LOAD stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_W3) and (not CAN_W3)  # proceed for route W3-LOAD (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route W3-LOAD: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_s3_2) and (not CD_W3)  # route W3-M stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_W3) and (not CAN_W3)  # proceed for route W3-M (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route W3-M: a condition was lost; no reopening by itself (R14)
        N_CN_LC1 = GPN_LC1 or MAN_LC1 or HDN_LC1  # machine LC1 commanded N
        N_CR_LC1 = GPR_LC1 or MAR_LC1 or HDR_LC1  # machine LC1 commanded R
        N_CN_LC2 = GPN_LC2 or MAN_LC2 or HDN_LC2  # machine LC2 commanded N
        N_CR_LC2 = GPR_LC2 or MAR_LC2 or HDR_LC2  # machine LC2 commanded R
        N_CN_P1 = GPN_P1 or MAN_P1 or HDN_P1  # machine P1 commanded N
        N_CR_P1 = GPR_P1 or MAR_P1 or HDR_P1  # machine P1 commanded R
        N_AL_LC1 = ST_LC1  # alarm: machine LC1 not detected
        N_AL_LC2 = ST_LC2  # alarm: machine LC2 not detected
        N_AL_P1 = ST_P1  # alarm: machine P1 not detected
        N_TH_P1 = ((CN_P1 and QN_P1) or (CR_P1 and QR_P1)) and (not (GPN_P1 or GPR_P1 or MAN_P1 or MAR_P1))  # machine P1 was detected where it is commanded
        N_TR_P1 = (TH_P1 and VALID and ((CN_P1 and (not QN_P1) and (not GPR_P1) and (not MAR_P1)) or (CR_P1 and (not QR_P1) and (not GPN_P1) and (not MAN_P1)))) or (TR_P1 and (not (TC_P1 and VALID and (not OCC_s3))))  # machine P1 was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route E1-E2 active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route E1-E2 locked
        N_W_R1 = (W_R1 or LK_R1 or ((REQ == 1) and B_R1)) and (not LS_R1) and KP_R1 and (not X_E1) and (not CAN_E1)  # route E1-E2: proceed wanted
        N_S_R1 = PR_R1  # route E1-E2: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route E1-E2: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route E2-E3 active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route E2-E3 locked
        N_W_R2 = (W_R2 or LK_R2 or ((REQ == 2) and B_R2)) and (not LS_R2) and KP_R2 and (not X_E2) and (not CAN_E2)  # route E2-E3: proceed wanted
        N_S_R2 = PR_R2  # route E2-E3: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route E2-E3: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route E3-W active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route E3-W locked
        N_W_R3 = (W_R3 or LK_R3 or ((REQ == 3) and B_R3)) and (not LS_R3) and KP_R3 and (not X_E3) and (not CAN_E3)  # route E3-W: proceed wanted
        N_S_R3 = PR_R3  # route E3-W: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route E3-W: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route L1-E3 active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route L1-E3 locked
        N_W_R4 = (W_R4 or LK_R4 or ((REQ == 4) and B_R4)) and (not LS_R4) and KP_R4 and (not X_L1) and (not CAN_L1)  # route L1-E3: proceed wanted
        N_S_R4 = PR_R4  # route L1-E3: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route L1-E3: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route M-E active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route M-E locked
        N_W_R5 = (W_R5 or LK_R5 or ((REQ == 5) and B_R5)) and (not LS_R5) and KP_R5 and (not X_M) and (not CAN_M)  # route M-E: proceed wanted
        N_S_R5 = PR_R5  # route M-E: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route M-E: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route W1-W2 active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route W1-W2 locked
        N_W_R6 = (W_R6 or LK_R6 or ((REQ == 6) and B_R6)) and (not LS_R6) and KP_R6 and (not X_W1) and (not CAN_W1)  # route W1-W2: proceed wanted
        N_S_R6 = PR_R6  # route W1-W2: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route W1-W2: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route W2-W3 active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route W2-W3 locked
        N_W_R7 = (W_R7 or LK_R7 or ((REQ == 7) and B_R7)) and (not LS_R7) and KP_R7 and (not X_W2) and (not CAN_W2)  # route W2-W3: proceed wanted
        N_S_R7 = PR_R7  # route W2-W3: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route W2-W3: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route W3-LOAD active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route W3-LOAD locked
        N_W_R8 = (W_R8 or LK_R8 or ((REQ == 8) and B_R8)) and (not LS_R8) and KP_R8 and (not X_W3) and (not CAN_W3)  # route W3-LOAD: proceed wanted
        N_S_R8 = PR_R8  # route W3-LOAD: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route W3-LOAD: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route W3-M active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route W3-M locked
        N_W_R9 = (W_R9 or LK_R9 or ((REQ == 9) and B_R9)) and (not LS_R9) and KP_R9 and (not X_W3) and (not CAN_W3)  # route W3-M: proceed wanted
        N_S_R9 = PR_R9  # route W3-M: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route W3-M: signal has been open
        N_X_E1 = (X_E1 or CAN_E1) and A_R1 and (not CD_E1)  # E1: cancelling
        N_X_E2 = (X_E2 or CAN_E2) and A_R2 and (not CD_E2)  # E2: cancelling
        N_X_E3 = (X_E3 or CAN_E3) and A_R3 and (not CD_E3)  # E3: cancelling
        N_X_L1 = (X_L1 or CAN_L1) and A_R4 and (not CD_L1)  # L1: cancelling
        N_X_M = (X_M or CAN_M) and A_R5 and (not CD_M)  # M: cancelling
        N_X_W1 = (X_W1 or CAN_W1) and A_R6 and (not CD_W1)  # W1: cancelling
        N_X_W2 = (X_W2 or CAN_W2) and A_R7 and (not CD_W2)  # W2: cancelling
        N_X_W3 = (X_W3 or CAN_W3) and (A_R8 or A_R9) and (not CD_W3)  # W3: cancelling
        N_K_ld = K_ld and (not RLS_ld)  # ld: restart lock (R16)
        N_L_ld_2 = (L_ld_2 or GW_ld_2) and (not RLS_ld)  # ld locked from ld|s3@P1.reverse to LOAD
        N_F_ld = (F_ld or LK_R8) and (not RLS_ld)  # ld firmly locked
        N_U_ld = (U_ld or NU_ld_2) and (not RLS_ld)  # ld used by a train (R9)
        N_P_ld = (P_ld or (U_ld and OCC_ld and NU_s3_1)) and (not RLS_ld)  # ld: the train went on (R9)
        N_D_ld = (D_ld or ((not VALID) and L_ld_2)) and (not RLS_ld)  # ld: detection is not relied on, inputs were lost or a train is called on
        N_K_s1 = K_s1 and (not RLS_s1)  # s1: restart lock (R16)
        N_L_s1_1 = (L_s1_1 or GW_s1_1) and (not RLS_s1)  # s1 locked from W to s1|s2@west.0
        N_L_s1_2 = (L_s1_2 or GW_s1_2) and (not RLS_s1)  # s1 locked from s1|s2@west.0 to W
        N_F_s1 = (F_s1 or LK_R6 or LK_R3) and (not RLS_s1)  # s1 firmly locked
        N_U_s1 = (U_s1 or NU_s1_1 or NU_s1_2) and (not RLS_s1)  # s1 used by a train (R9)
        N_P_s1 = (P_s1 or (U_s1 and OCC_s1 and NU_s2_1)) and (not RLS_s1)  # s1: the train went on (R9)
        N_D_s1 = (D_s1 or ((not VALID) and (L_s1_1 or L_s1_2))) and (not RLS_s1)  # s1: detection is not relied on, inputs were lost or a train is called on
        N_K_s2 = K_s2 and (not RLS_s2)  # s2: restart lock (R16)
        N_L_s2_1 = (L_s2_1 or GW_s2_1) and (not RLS_s2)  # s2 locked from s1|s2@west.0 to s2|s3@P1.toe
        N_L_s2_2 = (L_s2_2 or GW_s2_2) and (not RLS_s2)  # s2 locked from s2|s3@P1.toe to s1|s2@west.0
        N_F_s2 = (F_s2 or LK_R7 or LK_R2 or LK_R4) and (not RLS_s2)  # s2 firmly locked
        N_U_s2 = (U_s2 or NU_s2_1 or NU_s2_2) and (not RLS_s2)  # s2 used by a train (R9)
        N_P_s2 = (P_s2 or (U_s2 and OCC_s2 and (NU_s1_2 or NU_s3_2))) and (not RLS_s2)  # s2: the train went on (R9)
        N_D_s2 = (D_s2 or ((not VALID) and (L_s2_1 or L_s2_2))) and (not RLS_s2)  # s2: detection is not relied on, inputs were lost or a train is called on
        N_K_s3 = K_s3 and (not RLS_s3)  # s3: restart lock (R16)
        N_L_s3_1 = (L_s3_1 or GW_s3_1) and (not RLS_s3)  # s3 locked from ld|s3@P1.reverse to s2|s3@P1.toe
        N_L_s3_2 = (L_s3_2 or GW_s3_2) and (not RLS_s3)  # s3 locked from s2|s3@P1.toe to ld|s3@P1.reverse
        N_L_s3_3 = (L_s3_3 or GW_s3_3) and (not RLS_s3)  # s3 locked from s2|s3@P1.toe to s3|s4@P1.normal
        N_L_s3_4 = (L_s3_4 or GW_s3_4) and (not RLS_s3)  # s3 locked from s3|s4@P1.normal to s2|s3@P1.toe
        N_F_s3 = (F_s3 or LK_R4 or LK_R8 or LK_R9 or LK_R2) and (not RLS_s3)  # s3 firmly locked
        N_U_s3 = (U_s3 or NU_s3_1 or NU_s3_2 or NU_s3_3) and (not RLS_s3)  # s3 used by a train (R9)
        N_P_s3 = (P_s3 or (U_s3 and OCC_s3 and (NU_ld_2 or NU_s2_2 or NU_s4_1))) and (not RLS_s3)  # s3: the train went on (R9)
        N_D_s3 = (D_s3 or ((not VALID) and (L_s3_1 or L_s3_2 or L_s3_3 or L_s3_4))) and (not RLS_s3)  # s3: detection is not relied on, inputs were lost or a train is called on
        N_K_s4 = K_s4 and (not RLS_s4)  # s4: restart lock (R16)
        N_L_s4_1 = (L_s4_1 or GW_s4_1) and (not RLS_s4)  # s4 locked from s3|s4@P1.normal to s4|s5@mid.0
        N_L_s4_2 = (L_s4_2 or GW_s4_2) and (not RLS_s4)  # s4 locked from s4|s5@mid.0 to s3|s4@P1.normal
        N_F_s4 = (F_s4 or LK_R9 or LK_R2) and (not RLS_s4)  # s4 firmly locked
        N_U_s4 = (U_s4 or NU_s4_1 or NU_s4_2) and (not RLS_s4)  # s4 used by a train (R9)
        N_P_s4 = (P_s4 or (U_s4 and OCC_s4 and (NU_s3_3 or NU_s5_2))) and (not RLS_s4)  # s4: the train went on (R9)
        N_D_s4 = (D_s4 or ((not VALID) and (L_s4_1 or L_s4_2))) and (not RLS_s4)  # s4: detection is not relied on, inputs were lost or a train is called on
        N_K_s5 = K_s5 and (not RLS_s5)  # s5: restart lock (R16)
        N_L_s5_1 = (L_s5_1 or GW_s5_1) and (not RLS_s5)  # s5 locked from E to s4|s5@mid.0
        N_L_s5_2 = (L_s5_2 or GW_s5_2) and (not RLS_s5)  # s5 locked from s4|s5@mid.0 to E
        N_F_s5 = (F_s5 or LK_R1 or LK_R5) and (not RLS_s5)  # s5 firmly locked
        N_U_s5 = (U_s5 or NU_s5_1 or NU_s5_2) and (not RLS_s5)  # s5 used by a train (R9)
        N_P_s5 = (P_s5 or (U_s5 and OCC_s5 and NU_s4_2)) and (not RLS_s5)  # s5: the train went on (R9)
        N_D_s5 = (D_s5 or ((not VALID) and (L_s5_1 or L_s5_2))) and (not RLS_s5)  # s5: detection is not relied on, inputs were lost or a train is called on
        N_V_M_1 = GO_M_1 or (V_M_1 and (not (OR_M and (not OCC_s5))))  # overlap 1 of M held
        N_V_W2_1 = GO_W2_1 or (V_W2_1 and (not (OR_W2 and (not OCC_s2))))  # overlap 1 of W2 held
        N_VF_M = (VF_M or LK_R9) and V_M_1  # overlap of M firmly held
        N_VF_W2 = (VF_W2 or LK_R6) and V_W2_1  # overlap of W2 firmly held
        N_C_E1 = PR_R1 and (PR_R1 and PR_R2)  # E1 shows clear
        N_C_E2 = PR_R2 and (PR_R2 and PR_R3)  # E2 shows clear
        N_C_E3 = PR_R3 and PR_R3  # E3 shows clear
        N_C_L1 = PR_R4 and (PR_R4 and PR_R3)  # L1 shows clear
        N_C_M = PR_R5 and PR_R5  # M shows clear
        N_C_W1 = PR_R6 and (PR_R6 and PR_R7)  # W1 shows clear
        N_C_W2 = PR_R7 and (PR_R7 and (PR_R8 or PR_R9))  # W2 shows clear
        N_C_W3 = (PR_R8 or PR_R9) and (PR_R9 and PR_R5)  # W3 shows clear
        self.state = {
            'CN_LC1': bool(N_CN_LC1),
            'CR_LC1': bool(N_CR_LC1),
            'CN_LC2': bool(N_CN_LC2),
            'CR_LC2': bool(N_CR_LC2),
            'CN_P1': bool(N_CN_P1),
            'CR_P1': bool(N_CR_P1),
            'AL_LC1': bool(N_AL_LC1),
            'AL_LC2': bool(N_AL_LC2),
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
            'X_E1': bool(N_X_E1),
            'X_E2': bool(N_X_E2),
            'X_E3': bool(N_X_E3),
            'X_L1': bool(N_X_L1),
            'X_M': bool(N_X_M),
            'X_W1': bool(N_X_W1),
            'X_W2': bool(N_X_W2),
            'X_W3': bool(N_X_W3),
            'K_ld': bool(N_K_ld),
            'L_ld_2': bool(N_L_ld_2),
            'F_ld': bool(N_F_ld),
            'U_ld': bool(N_U_ld),
            'P_ld': bool(N_P_ld),
            'D_ld': bool(N_D_ld),
            'K_s1': bool(N_K_s1),
            'L_s1_1': bool(N_L_s1_1),
            'L_s1_2': bool(N_L_s1_2),
            'F_s1': bool(N_F_s1),
            'U_s1': bool(N_U_s1),
            'P_s1': bool(N_P_s1),
            'D_s1': bool(N_D_s1),
            'K_s2': bool(N_K_s2),
            'L_s2_1': bool(N_L_s2_1),
            'L_s2_2': bool(N_L_s2_2),
            'F_s2': bool(N_F_s2),
            'U_s2': bool(N_U_s2),
            'P_s2': bool(N_P_s2),
            'D_s2': bool(N_D_s2),
            'K_s3': bool(N_K_s3),
            'L_s3_1': bool(N_L_s3_1),
            'L_s3_2': bool(N_L_s3_2),
            'L_s3_3': bool(N_L_s3_3),
            'L_s3_4': bool(N_L_s3_4),
            'F_s3': bool(N_F_s3),
            'U_s3': bool(N_U_s3),
            'P_s3': bool(N_P_s3),
            'D_s3': bool(N_D_s3),
            'K_s4': bool(N_K_s4),
            'L_s4_1': bool(N_L_s4_1),
            'L_s4_2': bool(N_L_s4_2),
            'F_s4': bool(N_F_s4),
            'U_s4': bool(N_U_s4),
            'P_s4': bool(N_P_s4),
            'D_s4': bool(N_D_s4),
            'K_s5': bool(N_K_s5),
            'L_s5_1': bool(N_L_s5_1),
            'L_s5_2': bool(N_L_s5_2),
            'F_s5': bool(N_F_s5),
            'U_s5': bool(N_U_s5),
            'P_s5': bool(N_P_s5),
            'D_s5': bool(N_D_s5),
            'V_M_1': bool(N_V_M_1),
            'V_W2_1': bool(N_V_W2_1),
            'VF_M': bool(N_VF_M),
            'VF_W2': bool(N_VF_W2),
            'C_E1': bool(N_C_E1),
            'C_E2': bool(N_C_E2),
            'C_E3': bool(N_C_E3),
            'C_L1': bool(N_C_L1),
            'C_M': bool(N_C_M),
            'C_W1': bool(N_C_W1),
            'C_W2': bool(N_C_W2),
            'C_W3': bool(N_C_W3),
        }
        CN_LC1 = self.state['CN_LC1']
        CR_LC1 = self.state['CR_LC1']
        CN_LC2 = self.state['CN_LC2']
        CR_LC2 = self.state['CR_LC2']
        CN_P1 = self.state['CN_P1']
        CR_P1 = self.state['CR_P1']
        AL_LC1 = self.state['AL_LC1']
        AL_LC2 = self.state['AL_LC2']
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
        X_E1 = self.state['X_E1']
        X_E2 = self.state['X_E2']
        X_E3 = self.state['X_E3']
        X_L1 = self.state['X_L1']
        X_M = self.state['X_M']
        X_W1 = self.state['X_W1']
        X_W2 = self.state['X_W2']
        X_W3 = self.state['X_W3']
        K_ld = self.state['K_ld']
        L_ld_2 = self.state['L_ld_2']
        F_ld = self.state['F_ld']
        U_ld = self.state['U_ld']
        P_ld = self.state['P_ld']
        D_ld = self.state['D_ld']
        K_s1 = self.state['K_s1']
        L_s1_1 = self.state['L_s1_1']
        L_s1_2 = self.state['L_s1_2']
        F_s1 = self.state['F_s1']
        U_s1 = self.state['U_s1']
        P_s1 = self.state['P_s1']
        D_s1 = self.state['D_s1']
        K_s2 = self.state['K_s2']
        L_s2_1 = self.state['L_s2_1']
        L_s2_2 = self.state['L_s2_2']
        F_s2 = self.state['F_s2']
        U_s2 = self.state['U_s2']
        P_s2 = self.state['P_s2']
        D_s2 = self.state['D_s2']
        K_s3 = self.state['K_s3']
        L_s3_1 = self.state['L_s3_1']
        L_s3_2 = self.state['L_s3_2']
        L_s3_3 = self.state['L_s3_3']
        L_s3_4 = self.state['L_s3_4']
        F_s3 = self.state['F_s3']
        U_s3 = self.state['U_s3']
        P_s3 = self.state['P_s3']
        D_s3 = self.state['D_s3']
        K_s4 = self.state['K_s4']
        L_s4_1 = self.state['L_s4_1']
        L_s4_2 = self.state['L_s4_2']
        F_s4 = self.state['F_s4']
        U_s4 = self.state['U_s4']
        P_s4 = self.state['P_s4']
        D_s4 = self.state['D_s4']
        K_s5 = self.state['K_s5']
        L_s5_1 = self.state['L_s5_1']
        L_s5_2 = self.state['L_s5_2']
        F_s5 = self.state['F_s5']
        U_s5 = self.state['U_s5']
        P_s5 = self.state['P_s5']
        D_s5 = self.state['D_s5']
        V_M_1 = self.state['V_M_1']
        V_W2_1 = self.state['V_W2_1']
        VF_M = self.state['VF_M']
        VF_W2 = self.state['VF_W2']
        C_E1 = self.state['C_E1']
        C_E2 = self.state['C_E2']
        C_E3 = self.state['C_E3']
        C_L1 = self.state['C_L1']
        C_M = self.state['C_M']
        C_W1 = self.state['C_W1']
        C_W2 = self.state['C_W2']
        C_W3 = self.state['C_W3']
        return {
            'YN_LC1': bool(CN_LC1),
            'YR_LC1': bool(CR_LC1),
            'YN_LC2': bool(CN_LC2),
            'YR_LC2': bool(CR_LC2),
            'YN_P1': bool(CN_P1),
            'YR_P1': bool(CR_P1),
            'YA_LC1': bool(AL_LC1),
            'YA_LC2': bool(AL_LC2),
            'YA_P1': bool(AL_P1),
            'YT_P1': bool(TR_P1),
            'YL_ld': bool(K_ld or L_ld_2),
            'YL_s1': bool(K_s1 or L_s1_1 or L_s1_2),
            'YL_s2': bool(K_s2 or L_s2_1 or L_s2_2 or V_W2_1),
            'YL_s3': bool(K_s3 or L_s3_1 or L_s3_2 or L_s3_3 or L_s3_4),
            'YL_s4': bool(K_s4 or L_s4_1 or L_s4_2),
            'YL_s5': bool(K_s5 or L_s5_1 or L_s5_2 or V_M_1),
            'YP_E1': bool(C_E1),
            'YY_E1': bool(S_R1 and (not C_E1)),
            'YS_E1': bool((not S_R1)),
            'YP_E2': bool(C_E2),
            'YY_E2': bool(S_R2 and (not C_E2)),
            'YS_E2': bool((not S_R2)),
            'YP_E3': bool(C_E3),
            'YY_E3': bool(S_R3 and (not C_E3)),
            'YS_E3': bool((not S_R3)),
            'YP_L1': bool(C_L1),
            'YY_L1': bool(S_R4 and (not C_L1)),
            'YS_L1': bool((not S_R4)),
            'YP_M': bool(C_M),
            'YY_M': bool(S_R5 and (not C_M)),
            'YS_M': bool((not S_R5)),
            'YP_W1': bool(C_W1),
            'YY_W1': bool(S_R6 and (not C_W1)),
            'YS_W1': bool((not S_R6)),
            'YP_W2': bool(C_W2),
            'YY_W2': bool(S_R7 and (not C_W2)),
            'YS_W2': bool((not S_R7)),
            'YP_W3': bool(C_W3),
            'YY_W3': bool((S_R8 or S_R9) and (not C_W3)),
            'YS_W3': bool((not (S_R8 or S_R9))),
        }
