# Interlocking terminus, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout a52e9a9aa61a7f769da349b83051aedd2bfc702a2183e1f764149011ed48bad7
# claims 6793e030736fde206141096caa1040da85b08c68b82ab29ce9c8eee05de03b6c
"""Interlocking terminus: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_S1': (0, 2),  # operator: cancel the route from S1
    'CAN_S11': (0, 2),  # operator: cancel the route from S11
    'CAN_S12': (0, 2),  # operator: cancel the route from S12
    'CAN_S13': (0, 2),  # operator: cancel the route from S13
    'CAN_S14': (0, 2),  # operator: cancel the route from S14
    'REQ': (0, 13),  # operator: set route number, 0 = none
    'CLR_DA': (0, 2),  # section DA reported clear
    'CLR_P1': (0, 2),  # section P1 reported clear
    'CLR_P2': (0, 2),  # section P2 reported clear
    'CLR_P3': (0, 2),  # section P3 reported clear
    'CLR_P4': (0, 2),  # section P4 reported clear
    'CLR_T1': (0, 2),  # section T1 reported clear
    'CLR_T2': (0, 2),  # section T2 reported clear
    'CLR_T3': (0, 2),  # section T3 reported clear
    'CLR_T4': (0, 2),  # section T4 reported clear
    'CLR_UA': (0, 2),  # section UA reported clear
    'REL_P1': (0, 2),  # operator: release section P1 (hold until released)
    'REL_P2': (0, 2),  # operator: release section P2 (hold until released)
    'REL_P3': (0, 2),  # operator: release section P3 (hold until released)
    'REL_P4': (0, 2),  # operator: release section P4 (hold until released)
    'REL_T1': (0, 2),  # operator: release section T1 (hold until released)
    'REL_T2': (0, 2),  # operator: release section T2 (hold until released)
    'REL_T3': (0, 2),  # operator: release section T3 (hold until released)
    'REL_T4': (0, 2),  # operator: release section T4 (hold until released)
    'REL_UA': (0, 2),  # operator: release section UA (hold until released)
    'BLK_P1': (1, 2),  # operator: section P1 is blocked
    'BLK_P2': (1, 2),  # operator: section P2 is blocked
    'BLK_P3': (1, 2),  # operator: section P3 is blocked
    'BLK_P4': (1, 2),  # operator: section P4 is blocked
    'BLK_T1': (1, 2),  # operator: section T1 is blocked
    'BLK_T2': (1, 2),  # operator: section T2 is blocked
    'BLK_T3': (1, 2),  # operator: section T3 is blocked
    'BLK_T4': (1, 2),  # operator: section T4 is blocked
    'BLK_UA': (1, 2),  # operator: section UA is blocked
    'RELALL': (0, 2),  # operator: release all clear sections after a restart
    'DN_201': (0, 2),  # machine 201 detected normal
    'DR_201': (0, 2),  # machine 201 detected reverse
    'MN_201': (0, 2),  # operator: move machine 201 normal
    'MR_201': (0, 2),  # operator: move machine 201 reverse
    'TC_201': (0, 2),  # operator: machine 201 has been looked at after it was trailed
    'DN_202': (0, 2),  # machine 202 detected normal
    'DR_202': (0, 2),  # machine 202 detected reverse
    'MN_202': (0, 2),  # operator: move machine 202 normal
    'MR_202': (0, 2),  # operator: move machine 202 reverse
    'TC_202': (0, 2),  # operator: machine 202 has been looked at after it was trailed
    'DN_203': (0, 2),  # machine 203 detected normal
    'DR_203': (0, 2),  # machine 203 detected reverse
    'MN_203': (0, 2),  # operator: move machine 203 normal
    'MR_203': (0, 2),  # operator: move machine 203 reverse
    'TC_203': (0, 2),  # operator: machine 203 has been looked at after it was trailed
    'DN_204': (0, 2),  # machine 204 detected normal
    'DR_204': (0, 2),  # machine 204 detected reverse
    'MN_204': (0, 2),  # operator: move machine 204 normal
    'MR_204': (0, 2),  # operator: move machine 204 reverse
    'TC_204': (0, 2),  # operator: machine 204 has been looked at after it was trailed
}
# name: value at a restart, meaning
STATE = {
    'CN_201': False,  # machine 201 commanded N
    'CR_201': False,  # machine 201 commanded R
    'CN_202': False,  # machine 202 commanded N
    'CR_202': False,  # machine 202 commanded R
    'CN_203': False,  # machine 203 commanded N
    'CR_203': False,  # machine 203 commanded R
    'CN_204': False,  # machine 204 commanded N
    'CR_204': False,  # machine 204 commanded R
    'AL_201': False,  # alarm: machine 201 not detected
    'AL_202': False,  # alarm: machine 202 not detected
    'AL_203': False,  # alarm: machine 203 not detected
    'AL_204': False,  # alarm: machine 204 not detected
    'TH_201': False,  # machine 201 was detected where it is commanded
    'TR_201': False,  # machine 201 was trailed
    'TH_202': False,  # machine 202 was detected where it is commanded
    'TR_202': False,  # machine 202 was trailed
    'TH_203': False,  # machine 203 was detected where it is commanded
    'TR_203': False,  # machine 203 was trailed
    'TH_204': False,  # machine 204 was detected where it is commanded
    'TR_204': False,  # machine 204 was trailed
    'A_R1': False,  # route S1-B1 active
    'B_R1': False,  # route S1-B1 locked
    'W_R1': False,  # route S1-B1: proceed wanted
    'S_R1': False,  # route S1-B1: proceed
    'H_R1': False,  # route S1-B1: signal has been open
    'A_R2': False,  # route S1-B2 active
    'B_R2': False,  # route S1-B2 locked
    'W_R2': False,  # route S1-B2: proceed wanted
    'S_R2': False,  # route S1-B2: proceed
    'H_R2': False,  # route S1-B2: signal has been open
    'A_R3': False,  # route S1-B3 active
    'B_R3': False,  # route S1-B3 locked
    'W_R3': False,  # route S1-B3: proceed wanted
    'S_R3': False,  # route S1-B3: proceed
    'H_R3': False,  # route S1-B3: signal has been open
    'A_R4': False,  # route S1-B4 active
    'B_R4': False,  # route S1-B4 locked
    'W_R4': False,  # route S1-B4: proceed wanted
    'S_R4': False,  # route S1-B4: proceed
    'H_R4': False,  # route S1-B4: signal has been open
    'A_R5': False,  # route S11-D active
    'B_R5': False,  # route S11-D locked
    'W_R5': False,  # route S11-D: proceed wanted
    'S_R5': False,  # route S11-D: proceed
    'H_R5': False,  # route S11-D: signal has been open
    'A_R6': False,  # route S11-U active
    'B_R6': False,  # route S11-U locked
    'W_R6': False,  # route S11-U: proceed wanted
    'S_R6': False,  # route S11-U: proceed
    'H_R6': False,  # route S11-U: signal has been open
    'A_R7': False,  # route S12-D active
    'B_R7': False,  # route S12-D locked
    'W_R7': False,  # route S12-D: proceed wanted
    'S_R7': False,  # route S12-D: proceed
    'H_R7': False,  # route S12-D: signal has been open
    'A_R8': False,  # route S12-U active
    'B_R8': False,  # route S12-U locked
    'W_R8': False,  # route S12-U: proceed wanted
    'S_R8': False,  # route S12-U: proceed
    'H_R8': False,  # route S12-U: signal has been open
    'A_R9': False,  # route S13-D active
    'B_R9': False,  # route S13-D locked
    'W_R9': False,  # route S13-D: proceed wanted
    'S_R9': False,  # route S13-D: proceed
    'H_R9': False,  # route S13-D: signal has been open
    'A_R10': False,  # route S13-U active
    'B_R10': False,  # route S13-U locked
    'W_R10': False,  # route S13-U: proceed wanted
    'S_R10': False,  # route S13-U: proceed
    'H_R10': False,  # route S13-U: signal has been open
    'A_R11': False,  # route S14-D active
    'B_R11': False,  # route S14-D locked
    'W_R11': False,  # route S14-D: proceed wanted
    'S_R11': False,  # route S14-D: proceed
    'H_R11': False,  # route S14-D: signal has been open
    'A_R12': False,  # route S14-U active
    'B_R12': False,  # route S14-U locked
    'W_R12': False,  # route S14-U: proceed wanted
    'S_R12': False,  # route S14-U: proceed
    'H_R12': False,  # route S14-U: signal has been open
    'X_S1': False,  # S1: cancelling
    'X_S11': False,  # S11: cancelling
    'X_S12': False,  # S12: cancelling
    'X_S13': False,  # S13: cancelling
    'X_S14': False,  # S14: cancelling
    'K_P1': True,  # P1: restart lock (R16)
    'L_P1_2': False,  # P1 locked from P1|T3@203.normal to B1
    'F_P1': False,  # P1 firmly locked
    'U_P1': True,  # P1 used by a train (R9)
    'P_P1': False,  # P1: the train went on (R9)
    'D_P1': False,  # P1: detection is not relied on, inputs were lost or a train is called on
    'K_P2': True,  # P2: restart lock (R16)
    'L_P2_2': False,  # P2 locked from P2|T3@203.reverse to B2
    'F_P2': False,  # P2 firmly locked
    'U_P2': True,  # P2 used by a train (R9)
    'P_P2': False,  # P2: the train went on (R9)
    'D_P2': False,  # P2: detection is not relied on, inputs were lost or a train is called on
    'K_P3': True,  # P3: restart lock (R16)
    'L_P3_2': False,  # P3 locked from P3|T4@204.normal to B3
    'F_P3': False,  # P3 firmly locked
    'U_P3': True,  # P3 used by a train (R9)
    'P_P3': False,  # P3: the train went on (R9)
    'D_P3': False,  # P3: detection is not relied on, inputs were lost or a train is called on
    'K_P4': True,  # P4: restart lock (R16)
    'L_P4_2': False,  # P4 locked from P4|T4@204.reverse to B4
    'F_P4': False,  # P4 firmly locked
    'U_P4': True,  # P4 used by a train (R9)
    'P_P4': False,  # P4: the train went on (R9)
    'D_P4': False,  # P4: detection is not relied on, inputs were lost or a train is called on
    'K_T1': True,  # T1: restart lock (R16)
    'L_T1_1': False,  # T1 locked from D to T1|T2@201B.reverse
    'L_T1_2': False,  # T1 locked from D to T1|T3@202B.toe
    'L_T1_3': False,  # T1 locked from T1|T2@201B.reverse to D
    'L_T1_5': False,  # T1 locked from T1|T3@202B.toe to D
    'L_T1_6': False,  # T1 locked from T1|T3@202B.toe to T1|T2@202B.reverse
    'F_T1': False,  # T1 firmly locked
    'U_T1': True,  # T1 used by a train (R9)
    'P_T1': False,  # T1: the train went on (R9)
    'D_T1': False,  # T1: detection is not relied on, inputs were lost or a train is called on
    'K_T2': True,  # T2: restart lock (R16)
    'L_T2_1': False,  # T2 locked from T1|T2@201B.reverse to T2|T4@201B.toe
    'L_T2_2': False,  # T2 locked from T1|T2@202B.reverse to T2|UA@202A.toe
    'L_T2_3': False,  # T2 locked from T2|T4@201B.toe to T1|T2@201B.reverse
    'L_T2_4': False,  # T2 locked from T2|T4@201B.toe to T2|UA@202A.toe
    'F_T2': False,  # T2 firmly locked
    'U_T2': True,  # T2 used by a train (R9)
    'P_T2': False,  # T2: the train went on (R9)
    'D_T2': False,  # T2: detection is not relied on, inputs were lost or a train is called on
    'K_T3': True,  # T3: restart lock (R16)
    'L_T3_1': False,  # T3 locked from P1|T3@203.normal to T1|T3@202B.toe
    'L_T3_2': False,  # T3 locked from P2|T3@203.reverse to T1|T3@202B.toe
    'L_T3_3': False,  # T3 locked from T1|T3@202B.toe to P1|T3@203.normal
    'L_T3_4': False,  # T3 locked from T1|T3@202B.toe to P2|T3@203.reverse
    'F_T3': False,  # T3 firmly locked
    'U_T3': True,  # T3 used by a train (R9)
    'P_T3': False,  # T3: the train went on (R9)
    'D_T3': False,  # T3: detection is not relied on, inputs were lost or a train is called on
    'K_T4': True,  # T4: restart lock (R16)
    'L_T4_1': False,  # T4 locked from P3|T4@204.normal to T2|T4@201B.toe
    'L_T4_2': False,  # T4 locked from P4|T4@204.reverse to T2|T4@201B.toe
    'L_T4_3': False,  # T4 locked from T2|T4@201B.toe to P3|T4@204.normal
    'L_T4_4': False,  # T4 locked from T2|T4@201B.toe to P4|T4@204.reverse
    'F_T4': False,  # T4 firmly locked
    'U_T4': True,  # T4 used by a train (R9)
    'P_T4': False,  # T4: the train went on (R9)
    'D_T4': False,  # T4: detection is not relied on, inputs were lost or a train is called on
    'K_UA': True,  # UA: restart lock (R16)
    'L_UA_1': False,  # UA locked from T2|UA@202A.toe to U
    'F_UA': False,  # UA firmly locked
    'U_UA': True,  # UA used by a train (R9)
    'P_UA': False,  # UA: the train went on (R9)
    'D_UA': False,  # UA: detection is not relied on, inputs were lost or a train is called on
    'C_S1': False,  # S1 shows clear
    'C_S11': False,  # S11 shows clear
    'C_S12': False,  # S12 shows clear
    'C_S13': False,  # S13 shows clear
    'C_S14': False,  # S14 shows clear
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_S1': 180000,  # S1: approach locking delay (R8)
    'AT_S11': 180000,  # S11: approach locking delay (R8)
    'AT_S12': 180000,  # S12: approach locking delay (R8)
    'AT_S13': 180000,  # S13: approach locking delay (R8)
    'AT_S14': 180000,  # S14: approach locking delay (R8)
    'RT_P1': 3000,  # P1: release delay (R9)
    'RT_P2': 3000,  # P2: release delay (R9)
    'RT_P3': 3000,  # P3: release delay (R9)
    'RT_P4': 3000,  # P4: release delay (R9)
    'RT_T1': 3000,  # T1: release delay (R9)
    'RT_T2': 3000,  # T2: release delay (R9)
    'RT_T3': 3000,  # T3: release delay (R9)
    'RT_T4': 3000,  # T4: release delay (R9)
    'RT_UA': 3000,  # UA: release delay (R9)
    'ST_201': 13000,  # machine 201: time-out
    'ST_202': 13000,  # machine 202: time-out
    'ST_203': 13000,  # machine 203: time-out
    'ST_204': 13000,  # machine 204: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_201': False,  # machine 201: normal
    'YR_201': False,  # machine 201: reverse
    'YN_202': False,  # machine 202: normal
    'YR_202': False,  # machine 202: reverse
    'YN_203': False,  # machine 203: normal
    'YR_203': False,  # machine 203: reverse
    'YN_204': False,  # machine 204: normal
    'YR_204': False,  # machine 204: reverse
    'YA_201': False,  # alarm: machine 201 not detected in time
    'YA_202': False,  # alarm: machine 202 not detected in time
    'YA_203': False,  # alarm: machine 203 not detected in time
    'YA_204': False,  # alarm: machine 204 not detected in time
    'YT_201': False,  # alarm: machine 201 was trailed
    'YT_202': False,  # alarm: machine 202 was trailed
    'YT_203': False,  # alarm: machine 203 was trailed
    'YT_204': False,  # alarm: machine 204 was trailed
    'YL_P1': True,  # indication: P1 is locked
    'YL_P2': True,  # indication: P2 is locked
    'YL_P3': True,  # indication: P3 is locked
    'YL_P4': True,  # indication: P4 is locked
    'YL_T1': True,  # indication: T1 is locked
    'YL_T2': True,  # indication: T2 is locked
    'YL_T3': True,  # indication: T3 is locked
    'YL_T4': True,  # indication: T4 is locked
    'YL_UA': True,  # indication: UA is locked
    'YP_S1': False,  # signal S1: clear (green)
    'YY_S1': False,  # signal S1: caution (yellow)
    'YS_S1': True,  # signal S1: stop
    'YP_S11': False,  # signal S11: clear (green)
    'YY_S11': False,  # signal S11: caution (yellow)
    'YS_S11': True,  # signal S11: stop
    'YP_S12': False,  # signal S12: clear (green)
    'YY_S12': False,  # signal S12: caution (yellow)
    'YS_S12': True,  # signal S12: stop
    'YP_S13': False,  # signal S13: clear (green)
    'YY_S13': False,  # signal S13: caution (yellow)
    'YS_S13': True,  # signal S13: stop
    'YP_S14': False,  # signal S14: clear (green)
    'YY_S14': False,  # signal S14: caution (yellow)
    'YS_S14': True,  # signal S14: stop
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
        CAN_S1 = read['CAN_S1']
        CAN_S11 = read['CAN_S11']
        CAN_S12 = read['CAN_S12']
        CAN_S13 = read['CAN_S13']
        CAN_S14 = read['CAN_S14']
        REQ = read['REQ']
        CLR_DA = read['CLR_DA']
        CLR_P1 = read['CLR_P1']
        CLR_P2 = read['CLR_P2']
        CLR_P3 = read['CLR_P3']
        CLR_P4 = read['CLR_P4']
        CLR_T1 = read['CLR_T1']
        CLR_T2 = read['CLR_T2']
        CLR_T3 = read['CLR_T3']
        CLR_T4 = read['CLR_T4']
        CLR_UA = read['CLR_UA']
        REL_P1 = read['REL_P1']
        REL_P2 = read['REL_P2']
        REL_P3 = read['REL_P3']
        REL_P4 = read['REL_P4']
        REL_T1 = read['REL_T1']
        REL_T2 = read['REL_T2']
        REL_T3 = read['REL_T3']
        REL_T4 = read['REL_T4']
        REL_UA = read['REL_UA']
        BLK_P1 = read['BLK_P1']
        BLK_P2 = read['BLK_P2']
        BLK_P3 = read['BLK_P3']
        BLK_P4 = read['BLK_P4']
        BLK_T1 = read['BLK_T1']
        BLK_T2 = read['BLK_T2']
        BLK_T3 = read['BLK_T3']
        BLK_T4 = read['BLK_T4']
        BLK_UA = read['BLK_UA']
        RELALL = read['RELALL']
        DN_201 = read['DN_201']
        DR_201 = read['DR_201']
        MN_201 = read['MN_201']
        MR_201 = read['MR_201']
        TC_201 = read['TC_201']
        DN_202 = read['DN_202']
        DR_202 = read['DR_202']
        MN_202 = read['MN_202']
        MR_202 = read['MR_202']
        TC_202 = read['TC_202']
        DN_203 = read['DN_203']
        DR_203 = read['DR_203']
        MN_203 = read['MN_203']
        MR_203 = read['MR_203']
        TC_203 = read['TC_203']
        DN_204 = read['DN_204']
        DR_204 = read['DR_204']
        MN_204 = read['MN_204']
        MR_204 = read['MR_204']
        TC_204 = read['TC_204']
        CN_201 = old['CN_201']
        CR_201 = old['CR_201']
        CN_202 = old['CN_202']
        CR_202 = old['CR_202']
        CN_203 = old['CN_203']
        CR_203 = old['CR_203']
        CN_204 = old['CN_204']
        CR_204 = old['CR_204']
        AL_201 = old['AL_201']
        AL_202 = old['AL_202']
        AL_203 = old['AL_203']
        AL_204 = old['AL_204']
        TH_201 = old['TH_201']
        TR_201 = old['TR_201']
        TH_202 = old['TH_202']
        TR_202 = old['TR_202']
        TH_203 = old['TH_203']
        TR_203 = old['TR_203']
        TH_204 = old['TH_204']
        TR_204 = old['TR_204']
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
        X_S1 = old['X_S1']
        X_S11 = old['X_S11']
        X_S12 = old['X_S12']
        X_S13 = old['X_S13']
        X_S14 = old['X_S14']
        K_P1 = old['K_P1']
        L_P1_2 = old['L_P1_2']
        F_P1 = old['F_P1']
        U_P1 = old['U_P1']
        P_P1 = old['P_P1']
        D_P1 = old['D_P1']
        K_P2 = old['K_P2']
        L_P2_2 = old['L_P2_2']
        F_P2 = old['F_P2']
        U_P2 = old['U_P2']
        P_P2 = old['P_P2']
        D_P2 = old['D_P2']
        K_P3 = old['K_P3']
        L_P3_2 = old['L_P3_2']
        F_P3 = old['F_P3']
        U_P3 = old['U_P3']
        P_P3 = old['P_P3']
        D_P3 = old['D_P3']
        K_P4 = old['K_P4']
        L_P4_2 = old['L_P4_2']
        F_P4 = old['F_P4']
        U_P4 = old['U_P4']
        P_P4 = old['P_P4']
        D_P4 = old['D_P4']
        K_T1 = old['K_T1']
        L_T1_1 = old['L_T1_1']
        L_T1_2 = old['L_T1_2']
        L_T1_3 = old['L_T1_3']
        L_T1_5 = old['L_T1_5']
        L_T1_6 = old['L_T1_6']
        F_T1 = old['F_T1']
        U_T1 = old['U_T1']
        P_T1 = old['P_T1']
        D_T1 = old['D_T1']
        K_T2 = old['K_T2']
        L_T2_1 = old['L_T2_1']
        L_T2_2 = old['L_T2_2']
        L_T2_3 = old['L_T2_3']
        L_T2_4 = old['L_T2_4']
        F_T2 = old['F_T2']
        U_T2 = old['U_T2']
        P_T2 = old['P_T2']
        D_T2 = old['D_T2']
        K_T3 = old['K_T3']
        L_T3_1 = old['L_T3_1']
        L_T3_2 = old['L_T3_2']
        L_T3_3 = old['L_T3_3']
        L_T3_4 = old['L_T3_4']
        F_T3 = old['F_T3']
        U_T3 = old['U_T3']
        P_T3 = old['P_T3']
        D_T3 = old['D_T3']
        K_T4 = old['K_T4']
        L_T4_1 = old['L_T4_1']
        L_T4_2 = old['L_T4_2']
        L_T4_3 = old['L_T4_3']
        L_T4_4 = old['L_T4_4']
        F_T4 = old['F_T4']
        U_T4 = old['U_T4']
        P_T4 = old['P_T4']
        D_T4 = old['D_T4']
        K_UA = old['K_UA']
        L_UA_1 = old['L_UA_1']
        F_UA = old['F_UA']
        U_UA = old['U_UA']
        P_UA = old['P_UA']
        D_UA = old['D_UA']
        C_S1 = old['C_S1']
        C_S11 = old['C_S11']
        C_S12 = old['C_S12']
        C_S13 = old['C_S13']
        C_S14 = old['C_S14']
        OCC_DA = (not CLR_DA) or (not VALID)  # DA counts as occupied
        OCC_P1 = (not CLR_P1) or (not VALID)  # P1 counts as occupied
        OCC_P2 = (not CLR_P2) or (not VALID)  # P2 counts as occupied
        OCC_P3 = (not CLR_P3) or (not VALID)  # P3 counts as occupied
        OCC_P4 = (not CLR_P4) or (not VALID)  # P4 counts as occupied
        OCC_T1 = (not CLR_T1) or (not VALID)  # T1 counts as occupied
        OCC_T2 = (not CLR_T2) or (not VALID)  # T2 counts as occupied
        OCC_T3 = (not CLR_T3) or (not VALID)  # T3 counts as occupied
        OCC_T4 = (not CLR_T4) or (not VALID)  # T4 counts as occupied
        OCC_UA = (not CLR_UA) or (not VALID)  # UA counts as occupied
        FREE_P1 = (not K_P1) and (not L_P1_2)  # P1 is not locked by anybody
        FREE_P2 = (not K_P2) and (not L_P2_2)  # P2 is not locked by anybody
        FREE_P3 = (not K_P3) and (not L_P3_2)  # P3 is not locked by anybody
        FREE_P4 = (not K_P4) and (not L_P4_2)  # P4 is not locked by anybody
        FREE_T1 = (not K_T1) and (not L_T1_1) and (not L_T1_2) and (not L_T1_3) and (not L_T1_5) and (not L_T1_6)  # T1 is not locked by anybody
        FREE_T2 = (not K_T2) and (not L_T2_1) and (not L_T2_2) and (not L_T2_3) and (not L_T2_4)  # T2 is not locked by anybody
        FREE_T3 = (not K_T3) and (not L_T3_1) and (not L_T3_2) and (not L_T3_3) and (not L_T3_4)  # T3 is not locked by anybody
        FREE_T4 = (not K_T4) and (not L_T4_1) and (not L_T4_2) and (not L_T4_3) and (not L_T4_4)  # T4 is not locked by anybody
        FREE_UA = (not K_UA) and (not L_UA_1)  # UA is not locked by anybody
        QN_201 = VALID and DN_201 and (not DR_201)  # machine 201 lies N (R10)
        QR_201 = VALID and DR_201 and (not DN_201)  # machine 201 lies R (R10)
        QN_202 = VALID and DN_202 and (not DR_202)  # machine 202 lies N (R10)
        QR_202 = VALID and DR_202 and (not DN_202)  # machine 202 lies R (R10)
        QN_203 = VALID and DN_203 and (not DR_203)  # machine 203 lies N (R10)
        QR_203 = VALID and DR_203 and (not DN_203)  # machine 203 lies R (R10)
        QN_204 = VALID and DN_204 and (not DR_204)  # machine 204 lies N (R10)
        QR_204 = VALID and DR_204 and (not DN_204)  # machine 204 lies R (R10)
        MOV_201 = VALID and FREE_T1 and (not OCC_T1) and FREE_T2 and (not OCC_T2) and True and (not (L_T1_6 or L_T2_2))  # machine 201 is free to move (R10)
        AVN_201 = CN_201 or MOV_201 or (QN_201 and (not CN_201) and (not CR_201))  # machine 201 can be demanded N
        AVR_201 = CR_201 or MOV_201 or (QR_201 and (not CN_201) and (not CR_201))  # machine 201 can be demanded R
        MOV_202 = VALID and FREE_T1 and (not OCC_T1) and FREE_T2 and (not OCC_T2) and True and (not (L_T1_1 or L_T1_3))  # machine 202 is free to move (R10)
        AVN_202 = CN_202 or MOV_202 or (QN_202 and (not CN_202) and (not CR_202))  # machine 202 can be demanded N
        AVR_202 = CR_202 or MOV_202 or (QR_202 and (not CN_202) and (not CR_202))  # machine 202 can be demanded R
        MOV_203 = VALID and FREE_T3 and (not OCC_T3) and True and True  # machine 203 is free to move (R10)
        AVN_203 = CN_203 or MOV_203 or (QN_203 and (not CN_203) and (not CR_203))  # machine 203 can be demanded N
        AVR_203 = CR_203 or MOV_203 or (QR_203 and (not CN_203) and (not CR_203))  # machine 203 can be demanded R
        MOV_204 = VALID and FREE_T4 and (not OCC_T4) and True and True  # machine 204 is free to move (R10)
        AVN_204 = CN_204 or MOV_204 or (QN_204 and (not CN_204) and (not CR_204))  # machine 204 can be demanded N
        AVR_204 = CR_204 or MOV_204 or (QR_204 and (not CN_204) and (not CR_204))  # machine 204 can be demanded R
        WF_P1_2 = FREE_P1 and (not OCC_P1) and (not BLK_P1)  # P1 from P1|T3@203.normal to B1: free for a route (R6)
        WF_P2_2 = FREE_P2 and (not OCC_P2) and (not BLK_P2)  # P2 from P2|T3@203.reverse to B2: free for a route (R6)
        WF_P3_2 = FREE_P3 and (not OCC_P3) and (not BLK_P3)  # P3 from P3|T4@204.normal to B3: free for a route (R6)
        WF_P4_2 = FREE_P4 and (not OCC_P4) and (not BLK_P4)  # P4 from P4|T4@204.reverse to B4: free for a route (R6)
        WA_T1_1 = (not (L_T2_2 or K_T2)) and AVR_201 and AVR_202 and (not TR_201) and (not TR_202)  # T1 from D to T1|T2@201B.reverse: could be locked
        WF_T1_1 = FREE_T1 and (not OCC_T1) and (not BLK_T1) and WA_T1_1  # T1 from D to T1|T2@201B.reverse: free for a route (R6)
        WA_T1_2 = AVN_201 and AVN_202 and (not TR_201) and (not TR_202)  # T1 from D to T1|T3@202B.toe: could be locked
        WF_T1_2 = FREE_T1 and (not OCC_T1) and (not BLK_T1) and WA_T1_2  # T1 from D to T1|T3@202B.toe: free for a route (R6)
        WA_T1_3 = (not (L_T2_2 or K_T2)) and AVR_201 and AVR_202 and (not TR_201) and (not TR_202)  # T1 from T1|T2@201B.reverse to D: could be locked
        WF_T1_3 = FREE_T1 and (not OCC_T1) and (not BLK_T1) and WA_T1_3  # T1 from T1|T2@201B.reverse to D: free for a route (R6)
        WA_T1_5 = AVN_202 and AVN_201 and (not TR_202) and (not TR_201)  # T1 from T1|T3@202B.toe to D: could be locked
        WF_T1_5 = FREE_T1 and (not OCC_T1) and (not BLK_T1) and WA_T1_5  # T1 from T1|T3@202B.toe to D: free for a route (R6)
        WA_T1_6 = AVR_202 and AVR_201 and (not TR_202) and (not TR_201)  # T1 from T1|T3@202B.toe to T1|T2@202B.reverse: could be locked
        WF_T1_6 = FREE_T1 and (not OCC_T1) and (not BLK_T1) and WA_T1_6  # T1 from T1|T3@202B.toe to T1|T2@202B.reverse: free for a route (R6)
        WA_T2_1 = AVR_201 and (not TR_201)  # T2 from T1|T2@201B.reverse to T2|T4@201B.toe: could be locked
        WF_T2_1 = FREE_T2 and (not OCC_T2) and (not BLK_T2) and WA_T2_1  # T2 from T1|T2@201B.reverse to T2|T4@201B.toe: free for a route (R6)
        WA_T2_2 = (not (L_T1_1 or L_T1_3 or K_T1)) and AVR_202 and AVR_201 and (not TR_202) and (not TR_201)  # T2 from T1|T2@202B.reverse to T2|UA@202A.toe: could be locked
        WF_T2_2 = FREE_T2 and (not OCC_T2) and (not BLK_T2) and WA_T2_2  # T2 from T1|T2@202B.reverse to T2|UA@202A.toe: free for a route (R6)
        WA_T2_3 = AVR_201 and (not TR_201)  # T2 from T2|T4@201B.toe to T1|T2@201B.reverse: could be locked
        WF_T2_3 = FREE_T2 and (not OCC_T2) and (not BLK_T2) and WA_T2_3  # T2 from T2|T4@201B.toe to T1|T2@201B.reverse: free for a route (R6)
        WA_T2_4 = AVN_201 and AVN_202 and (not TR_201) and (not TR_202)  # T2 from T2|T4@201B.toe to T2|UA@202A.toe: could be locked
        WF_T2_4 = FREE_T2 and (not OCC_T2) and (not BLK_T2) and WA_T2_4  # T2 from T2|T4@201B.toe to T2|UA@202A.toe: free for a route (R6)
        WA_T3_1 = AVN_203 and (not TR_203)  # T3 from P1|T3@203.normal to T1|T3@202B.toe: could be locked
        WF_T3_1 = FREE_T3 and (not OCC_T3) and (not BLK_T3) and WA_T3_1  # T3 from P1|T3@203.normal to T1|T3@202B.toe: free for a route (R6)
        WA_T3_2 = AVR_203 and (not TR_203)  # T3 from P2|T3@203.reverse to T1|T3@202B.toe: could be locked
        WF_T3_2 = FREE_T3 and (not OCC_T3) and (not BLK_T3) and WA_T3_2  # T3 from P2|T3@203.reverse to T1|T3@202B.toe: free for a route (R6)
        WA_T3_3 = AVN_203 and (not TR_203)  # T3 from T1|T3@202B.toe to P1|T3@203.normal: could be locked
        WF_T3_3 = FREE_T3 and (not OCC_T3) and (not BLK_T3) and WA_T3_3  # T3 from T1|T3@202B.toe to P1|T3@203.normal: free for a route (R6)
        WA_T3_4 = AVR_203 and (not TR_203)  # T3 from T1|T3@202B.toe to P2|T3@203.reverse: could be locked
        WF_T3_4 = FREE_T3 and (not OCC_T3) and (not BLK_T3) and WA_T3_4  # T3 from T1|T3@202B.toe to P2|T3@203.reverse: free for a route (R6)
        WA_T4_1 = AVN_204 and (not TR_204)  # T4 from P3|T4@204.normal to T2|T4@201B.toe: could be locked
        WF_T4_1 = FREE_T4 and (not OCC_T4) and (not BLK_T4) and WA_T4_1  # T4 from P3|T4@204.normal to T2|T4@201B.toe: free for a route (R6)
        WA_T4_2 = AVR_204 and (not TR_204)  # T4 from P4|T4@204.reverse to T2|T4@201B.toe: could be locked
        WF_T4_2 = FREE_T4 and (not OCC_T4) and (not BLK_T4) and WA_T4_2  # T4 from P4|T4@204.reverse to T2|T4@201B.toe: free for a route (R6)
        WA_T4_3 = AVN_204 and (not TR_204)  # T4 from T2|T4@201B.toe to P3|T4@204.normal: could be locked
        WF_T4_3 = FREE_T4 and (not OCC_T4) and (not BLK_T4) and WA_T4_3  # T4 from T2|T4@201B.toe to P3|T4@204.normal: free for a route (R6)
        WA_T4_4 = AVR_204 and (not TR_204)  # T4 from T2|T4@201B.toe to P4|T4@204.reverse: could be locked
        WF_T4_4 = FREE_T4 and (not OCC_T4) and (not BLK_T4) and WA_T4_4  # T4 from T2|T4@201B.toe to P4|T4@204.reverse: free for a route (R6)
        WF_UA_1 = FREE_UA and (not OCC_UA) and (not BLK_UA)  # UA from T2|UA@202A.toe to U: free for a route (R6)
        WL_P1_2 = (not OCC_P1)  # P1 from P1|T3@203.normal to B1: lies and is clear
        WP_P1_2 = WL_P1_2 and (not BLK_P1)  # P1 from P1|T3@203.normal to B1: proceed may be shown over it (R3)
        WL_P2_2 = (not OCC_P2)  # P2 from P2|T3@203.reverse to B2: lies and is clear
        WP_P2_2 = WL_P2_2 and (not BLK_P2)  # P2 from P2|T3@203.reverse to B2: proceed may be shown over it (R3)
        WL_P3_2 = (not OCC_P3)  # P3 from P3|T4@204.normal to B3: lies and is clear
        WP_P3_2 = WL_P3_2 and (not BLK_P3)  # P3 from P3|T4@204.normal to B3: proceed may be shown over it (R3)
        WL_P4_2 = (not OCC_P4)  # P4 from P4|T4@204.reverse to B4: lies and is clear
        WP_P4_2 = WL_P4_2 and (not BLK_P4)  # P4 from P4|T4@204.reverse to B4: proceed may be shown over it (R3)
        WD_T1_1 = QR_201 and QR_202 and (not TR_201) and (not TR_202)  # T1 from D to T1|T2@201B.reverse: its points lie, nothing is foul of it
        WL_T1_1 = (not OCC_T1) and WD_T1_1  # T1 from D to T1|T2@201B.reverse: lies and is clear
        WP_T1_1 = WL_T1_1 and (not BLK_T1)  # T1 from D to T1|T2@201B.reverse: proceed may be shown over it (R3)
        WD_T1_2 = QN_201 and QN_202 and (not TR_201) and (not TR_202)  # T1 from D to T1|T3@202B.toe: its points lie, nothing is foul of it
        WL_T1_2 = (not OCC_T1) and WD_T1_2  # T1 from D to T1|T3@202B.toe: lies and is clear
        WP_T1_2 = WL_T1_2 and (not BLK_T1)  # T1 from D to T1|T3@202B.toe: proceed may be shown over it (R3)
        WD_T1_3 = QR_201 and QR_202 and (not TR_201) and (not TR_202)  # T1 from T1|T2@201B.reverse to D: its points lie, nothing is foul of it
        WL_T1_3 = (not OCC_T1) and WD_T1_3  # T1 from T1|T2@201B.reverse to D: lies and is clear
        WP_T1_3 = WL_T1_3 and (not BLK_T1)  # T1 from T1|T2@201B.reverse to D: proceed may be shown over it (R3)
        WD_T1_5 = QN_202 and QN_201 and (not TR_202) and (not TR_201)  # T1 from T1|T3@202B.toe to D: its points lie, nothing is foul of it
        WL_T1_5 = (not OCC_T1) and WD_T1_5  # T1 from T1|T3@202B.toe to D: lies and is clear
        WP_T1_5 = WL_T1_5 and (not BLK_T1)  # T1 from T1|T3@202B.toe to D: proceed may be shown over it (R3)
        WD_T1_6 = QR_202 and QR_201 and (not TR_202) and (not TR_201)  # T1 from T1|T3@202B.toe to T1|T2@202B.reverse: its points lie, nothing is foul of it
        WL_T1_6 = (not OCC_T1) and WD_T1_6  # T1 from T1|T3@202B.toe to T1|T2@202B.reverse: lies and is clear
        WP_T1_6 = WL_T1_6 and (not BLK_T1)  # T1 from T1|T3@202B.toe to T1|T2@202B.reverse: proceed may be shown over it (R3)
        WD_T2_1 = QR_201 and (not TR_201)  # T2 from T1|T2@201B.reverse to T2|T4@201B.toe: its points lie, nothing is foul of it
        WL_T2_1 = (not OCC_T2) and WD_T2_1  # T2 from T1|T2@201B.reverse to T2|T4@201B.toe: lies and is clear
        WP_T2_1 = WL_T2_1 and (not BLK_T2)  # T2 from T1|T2@201B.reverse to T2|T4@201B.toe: proceed may be shown over it (R3)
        WD_T2_2 = QR_202 and QR_201 and (not TR_202) and (not TR_201)  # T2 from T1|T2@202B.reverse to T2|UA@202A.toe: its points lie, nothing is foul of it
        WL_T2_2 = (not OCC_T2) and WD_T2_2  # T2 from T1|T2@202B.reverse to T2|UA@202A.toe: lies and is clear
        WP_T2_2 = WL_T2_2 and (not BLK_T2)  # T2 from T1|T2@202B.reverse to T2|UA@202A.toe: proceed may be shown over it (R3)
        WD_T2_3 = QR_201 and (not TR_201)  # T2 from T2|T4@201B.toe to T1|T2@201B.reverse: its points lie, nothing is foul of it
        WL_T2_3 = (not OCC_T2) and WD_T2_3  # T2 from T2|T4@201B.toe to T1|T2@201B.reverse: lies and is clear
        WP_T2_3 = WL_T2_3 and (not BLK_T2)  # T2 from T2|T4@201B.toe to T1|T2@201B.reverse: proceed may be shown over it (R3)
        WD_T2_4 = QN_201 and QN_202 and (not TR_201) and (not TR_202)  # T2 from T2|T4@201B.toe to T2|UA@202A.toe: its points lie, nothing is foul of it
        WL_T2_4 = (not OCC_T2) and WD_T2_4  # T2 from T2|T4@201B.toe to T2|UA@202A.toe: lies and is clear
        WP_T2_4 = WL_T2_4 and (not BLK_T2)  # T2 from T2|T4@201B.toe to T2|UA@202A.toe: proceed may be shown over it (R3)
        WD_T3_1 = QN_203 and (not TR_203)  # T3 from P1|T3@203.normal to T1|T3@202B.toe: its points lie, nothing is foul of it
        WL_T3_1 = (not OCC_T3) and WD_T3_1  # T3 from P1|T3@203.normal to T1|T3@202B.toe: lies and is clear
        WP_T3_1 = WL_T3_1 and (not BLK_T3)  # T3 from P1|T3@203.normal to T1|T3@202B.toe: proceed may be shown over it (R3)
        WD_T3_2 = QR_203 and (not TR_203)  # T3 from P2|T3@203.reverse to T1|T3@202B.toe: its points lie, nothing is foul of it
        WL_T3_2 = (not OCC_T3) and WD_T3_2  # T3 from P2|T3@203.reverse to T1|T3@202B.toe: lies and is clear
        WP_T3_2 = WL_T3_2 and (not BLK_T3)  # T3 from P2|T3@203.reverse to T1|T3@202B.toe: proceed may be shown over it (R3)
        WD_T3_3 = QN_203 and (not TR_203)  # T3 from T1|T3@202B.toe to P1|T3@203.normal: its points lie, nothing is foul of it
        WL_T3_3 = (not OCC_T3) and WD_T3_3  # T3 from T1|T3@202B.toe to P1|T3@203.normal: lies and is clear
        WP_T3_3 = WL_T3_3 and (not BLK_T3)  # T3 from T1|T3@202B.toe to P1|T3@203.normal: proceed may be shown over it (R3)
        WD_T3_4 = QR_203 and (not TR_203)  # T3 from T1|T3@202B.toe to P2|T3@203.reverse: its points lie, nothing is foul of it
        WL_T3_4 = (not OCC_T3) and WD_T3_4  # T3 from T1|T3@202B.toe to P2|T3@203.reverse: lies and is clear
        WP_T3_4 = WL_T3_4 and (not BLK_T3)  # T3 from T1|T3@202B.toe to P2|T3@203.reverse: proceed may be shown over it (R3)
        WD_T4_1 = QN_204 and (not TR_204)  # T4 from P3|T4@204.normal to T2|T4@201B.toe: its points lie, nothing is foul of it
        WL_T4_1 = (not OCC_T4) and WD_T4_1  # T4 from P3|T4@204.normal to T2|T4@201B.toe: lies and is clear
        WP_T4_1 = WL_T4_1 and (not BLK_T4)  # T4 from P3|T4@204.normal to T2|T4@201B.toe: proceed may be shown over it (R3)
        WD_T4_2 = QR_204 and (not TR_204)  # T4 from P4|T4@204.reverse to T2|T4@201B.toe: its points lie, nothing is foul of it
        WL_T4_2 = (not OCC_T4) and WD_T4_2  # T4 from P4|T4@204.reverse to T2|T4@201B.toe: lies and is clear
        WP_T4_2 = WL_T4_2 and (not BLK_T4)  # T4 from P4|T4@204.reverse to T2|T4@201B.toe: proceed may be shown over it (R3)
        WD_T4_3 = QN_204 and (not TR_204)  # T4 from T2|T4@201B.toe to P3|T4@204.normal: its points lie, nothing is foul of it
        WL_T4_3 = (not OCC_T4) and WD_T4_3  # T4 from T2|T4@201B.toe to P3|T4@204.normal: lies and is clear
        WP_T4_3 = WL_T4_3 and (not BLK_T4)  # T4 from T2|T4@201B.toe to P3|T4@204.normal: proceed may be shown over it (R3)
        WD_T4_4 = QR_204 and (not TR_204)  # T4 from T2|T4@201B.toe to P4|T4@204.reverse: its points lie, nothing is foul of it
        WL_T4_4 = (not OCC_T4) and WD_T4_4  # T4 from T2|T4@201B.toe to P4|T4@204.reverse: lies and is clear
        WP_T4_4 = WL_T4_4 and (not BLK_T4)  # T4 from T2|T4@201B.toe to P4|T4@204.reverse: proceed may be shown over it (R3)
        WL_UA_1 = (not OCC_UA)  # UA from T2|UA@202A.toe to U: lies and is clear
        WP_UA_1 = WL_UA_1 and (not BLK_UA)  # UA from T2|UA@202A.toe to U: proceed may be shown over it (R3)
        G_R1 = (REQ == 1) and VALID and WF_T1_2 and WF_T3_3 and WF_P1_2  # grant of route S1-B1 (R6)
        G_R2 = (REQ == 2) and VALID and WF_T1_2 and WF_T3_4 and WF_P2_2  # grant of route S1-B2 (R6)
        G_R3 = (REQ == 3) and VALID and WF_T1_1 and WF_T2_1 and WF_T4_3 and WF_P3_2  # grant of route S1-B3 (R6)
        G_R4 = (REQ == 4) and VALID and WF_T1_1 and WF_T2_1 and WF_T4_4 and WF_P4_2  # grant of route S1-B4 (R6)
        G_R5 = (REQ == 5) and VALID and WF_T3_1 and WF_T1_5  # grant of route S11-D (R6)
        G_R6 = (REQ == 6) and VALID and WF_T3_1 and WF_T1_6 and WF_T2_2 and WF_UA_1  # grant of route S11-U (R6)
        G_R7 = (REQ == 7) and VALID and WF_T3_2 and WF_T1_5  # grant of route S12-D (R6)
        G_R8 = (REQ == 8) and VALID and WF_T3_2 and WF_T1_6 and WF_T2_2 and WF_UA_1  # grant of route S12-U (R6)
        G_R9 = (REQ == 9) and VALID and WF_T4_1 and WF_T2_3 and WF_T1_3  # grant of route S13-D (R6)
        G_R10 = (REQ == 10) and VALID and WF_T4_1 and WF_T2_4 and WF_UA_1  # grant of route S13-U (R6)
        G_R11 = (REQ == 11) and VALID and WF_T4_2 and WF_T2_3 and WF_T1_3  # grant of route S14-D (R6)
        G_R12 = (REQ == 12) and VALID and WF_T4_2 and WF_T2_4 and WF_UA_1  # grant of route S14-U (R6)
        GW_P1_2 = G_R1  # P1 from P1|T3@203.normal to B1: granted
        GW_P2_2 = G_R2  # P2 from P2|T3@203.reverse to B2: granted
        GW_P3_2 = G_R3  # P3 from P3|T4@204.normal to B3: granted
        GW_P4_2 = G_R4  # P4 from P4|T4@204.reverse to B4: granted
        GW_T1_1 = G_R3 or G_R4  # T1 from D to T1|T2@201B.reverse: granted
        GW_T1_2 = G_R1 or G_R2  # T1 from D to T1|T3@202B.toe: granted
        GW_T1_3 = G_R9 or G_R11  # T1 from T1|T2@201B.reverse to D: granted
        GW_T1_5 = G_R5 or G_R7  # T1 from T1|T3@202B.toe to D: granted
        GW_T1_6 = G_R6 or G_R8  # T1 from T1|T3@202B.toe to T1|T2@202B.reverse: granted
        GW_T2_1 = G_R3 or G_R4  # T2 from T1|T2@201B.reverse to T2|T4@201B.toe: granted
        GW_T2_2 = G_R6 or G_R8  # T2 from T1|T2@202B.reverse to T2|UA@202A.toe: granted
        GW_T2_3 = G_R9 or G_R11  # T2 from T2|T4@201B.toe to T1|T2@201B.reverse: granted
        GW_T2_4 = G_R10 or G_R12  # T2 from T2|T4@201B.toe to T2|UA@202A.toe: granted
        GW_T3_1 = G_R5 or G_R6  # T3 from P1|T3@203.normal to T1|T3@202B.toe: granted
        GW_T3_2 = G_R7 or G_R8  # T3 from P2|T3@203.reverse to T1|T3@202B.toe: granted
        GW_T3_3 = G_R1  # T3 from T1|T3@202B.toe to P1|T3@203.normal: granted
        GW_T3_4 = G_R2  # T3 from T1|T3@202B.toe to P2|T3@203.reverse: granted
        GW_T4_1 = G_R9 or G_R10  # T4 from P3|T4@204.normal to T2|T4@201B.toe: granted
        GW_T4_2 = G_R11 or G_R12  # T4 from P4|T4@204.reverse to T2|T4@201B.toe: granted
        GW_T4_3 = G_R3  # T4 from T2|T4@201B.toe to P3|T4@204.normal: granted
        GW_T4_4 = G_R4  # T4 from T2|T4@201B.toe to P4|T4@204.reverse: granted
        GW_UA_1 = G_R6 or G_R8 or G_R10 or G_R12  # UA from T2|UA@202A.toe to U: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_S1) and (not CAN_S1) and WL_T1_2 and WL_T3_3 and WL_P1_2  # route S1-B1 becomes locked (R3)
        CO_R1 = VALID and WP_T1_2 and WP_T3_3 and WP_P1_2 and (not D_T1)  # conditions of proceed for route S1-B1 (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_S1) and (not CAN_S1) and WL_T1_2 and WL_T3_4 and WL_P2_2  # route S1-B2 becomes locked (R3)
        CO_R2 = VALID and WP_T1_2 and WP_T3_4 and WP_P2_2 and (not D_T1)  # conditions of proceed for route S1-B2 (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_S1) and (not CAN_S1) and WL_T1_1 and WL_T2_1 and WL_T4_3 and WL_P3_2  # route S1-B3 becomes locked (R3)
        CO_R3 = VALID and WP_T1_1 and WP_T2_1 and WP_T4_3 and WP_P3_2 and (not D_T1)  # conditions of proceed for route S1-B3 (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_S1) and (not CAN_S1) and WL_T1_1 and WL_T2_1 and WL_T4_4 and WL_P4_2  # route S1-B4 becomes locked (R3)
        CO_R4 = VALID and WP_T1_1 and WP_T2_1 and WP_T4_4 and WP_P4_2 and (not D_T1)  # conditions of proceed for route S1-B4 (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_S11) and (not CAN_S11) and WL_T3_1 and WL_T1_5  # route S11-D becomes locked (R3)
        CO_R5 = VALID and WP_T3_1 and WP_T1_5 and (not OCC_DA) and (not D_T3)  # conditions of proceed for route S11-D (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_S11) and (not CAN_S11) and WL_T3_1 and WL_T1_6 and WL_T2_2 and WL_UA_1  # route S11-U becomes locked (R3)
        CO_R6 = VALID and WP_T3_1 and WP_T1_6 and WP_T2_2 and WP_UA_1 and (not D_T3)  # conditions of proceed for route S11-U (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_S12) and (not CAN_S12) and WL_T3_2 and WL_T1_5  # route S12-D becomes locked (R3)
        CO_R7 = VALID and WP_T3_2 and WP_T1_5 and (not OCC_DA) and (not D_T3)  # conditions of proceed for route S12-D (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_S12) and (not CAN_S12) and WL_T3_2 and WL_T1_6 and WL_T2_2 and WL_UA_1  # route S12-U becomes locked (R3)
        CO_R8 = VALID and WP_T3_2 and WP_T1_6 and WP_T2_2 and WP_UA_1 and (not D_T3)  # conditions of proceed for route S12-U (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_S13) and (not CAN_S13) and WL_T4_1 and WL_T2_3 and WL_T1_3  # route S13-D becomes locked (R3)
        CO_R9 = VALID and WP_T4_1 and WP_T2_3 and WP_T1_3 and (not OCC_DA) and (not D_T4)  # conditions of proceed for route S13-D (R3)
        LK_R10 = A_R10 and (not B_R10) and VALID and (not X_S13) and (not CAN_S13) and WL_T4_1 and WL_T2_4 and WL_UA_1  # route S13-U becomes locked (R3)
        CO_R10 = VALID and WP_T4_1 and WP_T2_4 and WP_UA_1 and (not D_T4)  # conditions of proceed for route S13-U (R3)
        LK_R11 = A_R11 and (not B_R11) and VALID and (not X_S14) and (not CAN_S14) and WL_T4_2 and WL_T2_3 and WL_T1_3  # route S14-D becomes locked (R3)
        CO_R11 = VALID and WP_T4_2 and WP_T2_3 and WP_T1_3 and (not OCC_DA) and (not D_T4)  # conditions of proceed for route S14-D (R3)
        LK_R12 = A_R12 and (not B_R12) and VALID and (not X_S14) and (not CAN_S14) and WL_T4_2 and WL_T2_4 and WL_UA_1  # route S14-U becomes locked (R3)
        CO_R12 = VALID and WP_T4_2 and WP_T2_4 and WP_UA_1 and (not D_T4)  # conditions of proceed for route S14-U (R3)
        NU_P1_2 = VALID and F_P1 and (not D_P1) and (not U_P1) and L_P1_2 and OCC_P1 and OCC_T3 and U_T3 and L_T3_3  # a train comes into P1 at P1|T3@203.normal (R9)
        NU_P2_2 = VALID and F_P2 and (not D_P2) and (not U_P2) and L_P2_2 and OCC_P2 and OCC_T3 and U_T3 and L_T3_4  # a train comes into P2 at P2|T3@203.reverse (R9)
        NU_P3_2 = VALID and F_P3 and (not D_P3) and (not U_P3) and L_P3_2 and OCC_P3 and OCC_T4 and U_T4 and L_T4_3  # a train comes into P3 at P3|T4@204.normal (R9)
        NU_P4_2 = VALID and F_P4 and (not D_P4) and (not U_P4) and L_P4_2 and OCC_P4 and OCC_T4 and U_T4 and L_T4_4  # a train comes into P4 at P4|T4@204.reverse (R9)
        NU_T1_1 = VALID and F_T1 and (not D_T1) and (not U_T1) and (L_T1_1 or L_T1_2) and OCC_T1 and OCC_DA  # a train comes into T1 at D (R9)
        NU_T1_2 = VALID and F_T1 and (not D_T1) and (not U_T1) and L_T1_3 and OCC_T1 and OCC_T2 and U_T2 and L_T2_3  # a train comes into T1 at T1|T2@201B.reverse (R9)
        NU_T1_4 = VALID and F_T1 and (not D_T1) and (not U_T1) and (L_T1_5 or L_T1_6) and OCC_T1 and OCC_T3 and U_T3 and (L_T3_1 or L_T3_2)  # a train comes into T1 at T1|T3@202B.toe (R9)
        NU_T2_1 = VALID and F_T2 and (not D_T2) and (not U_T2) and L_T2_1 and OCC_T2 and OCC_T1 and U_T1 and L_T1_1  # a train comes into T2 at T1|T2@201B.reverse (R9)
        NU_T2_2 = VALID and F_T2 and (not D_T2) and (not U_T2) and L_T2_2 and OCC_T2 and OCC_T1 and U_T1 and L_T1_6  # a train comes into T2 at T1|T2@202B.reverse (R9)
        NU_T2_3 = VALID and F_T2 and (not D_T2) and (not U_T2) and (L_T2_3 or L_T2_4) and OCC_T2 and OCC_T4 and U_T4 and (L_T4_1 or L_T4_2)  # a train comes into T2 at T2|T4@201B.toe (R9)
        NU_T3_1 = VALID and F_T3 and (not D_T3) and (not U_T3) and L_T3_1 and OCC_T3 and OCC_P1  # a train comes into T3 at P1|T3@203.normal (R9)
        NU_T3_2 = VALID and F_T3 and (not D_T3) and (not U_T3) and L_T3_2 and OCC_T3 and OCC_P2  # a train comes into T3 at P2|T3@203.reverse (R9)
        NU_T3_3 = VALID and F_T3 and (not D_T3) and (not U_T3) and (L_T3_3 or L_T3_4) and OCC_T3 and OCC_T1 and U_T1 and L_T1_2  # a train comes into T3 at T1|T3@202B.toe (R9)
        NU_T4_1 = VALID and F_T4 and (not D_T4) and (not U_T4) and L_T4_1 and OCC_T4 and OCC_P3  # a train comes into T4 at P3|T4@204.normal (R9)
        NU_T4_2 = VALID and F_T4 and (not D_T4) and (not U_T4) and L_T4_2 and OCC_T4 and OCC_P4  # a train comes into T4 at P4|T4@204.reverse (R9)
        NU_T4_3 = VALID and F_T4 and (not D_T4) and (not U_T4) and (L_T4_3 or L_T4_4) and OCC_T4 and OCC_T2 and U_T2 and L_T2_1  # a train comes into T4 at T2|T4@201B.toe (R9)
        NU_UA_1 = VALID and F_UA and (not D_UA) and (not U_UA) and L_UA_1 and OCC_UA and OCC_T2 and U_T2 and (L_T2_2 or L_T2_4)  # a train comes into UA at T2|UA@202A.toe (R9)
        ATI_S1 = X_S1 or ((not (A_R1 or A_R2 or A_R3 or A_R4)) and (L_T1_1 or L_T1_2) and REL_T1)  # S1 at stop, waiting for a train that may still come (R8)
        ATI_S11 = X_S11 or ((not (A_R5 or A_R6)) and L_T3_1 and REL_T3)  # S11 at stop, waiting for a train that may still come (R8)
        ATI_S12 = X_S12 or ((not (A_R7 or A_R8)) and L_T3_2 and REL_T3)  # S12 at stop, waiting for a train that may still come (R8)
        ATI_S13 = X_S13 or ((not (A_R9 or A_R10)) and L_T4_1 and REL_T4)  # S13 at stop, waiting for a train that may still come (R8)
        ATI_S14 = X_S14 or ((not (A_R11 or A_R12)) and L_T4_2 and REL_T4)  # S14 at stop, waiting for a train that may still come (R8)
        AT_S1 = self._timer('AT_S1', ATI_S1, dt_ms)  # S1: approach locking delay (R8)
        AT_S11 = self._timer('AT_S11', ATI_S11, dt_ms)  # S11: approach locking delay (R8)
        AT_S12 = self._timer('AT_S12', ATI_S12, dt_ms)  # S12: approach locking delay (R8)
        AT_S13 = self._timer('AT_S13', ATI_S13, dt_ms)  # S13: approach locking delay (R8)
        AT_S14 = self._timer('AT_S14', ATI_S14, dt_ms)  # S14: approach locking delay (R8)
        CD_S1 = X_S1 and (A_R1 or A_R2 or A_R3 or A_R4) and VALID and (not OCC_T1) and ((not OCC_DA) or AT_S1 or (not (H_R1 or H_R2 or H_R3 or H_R4)))  # the route from S1 is cancelled (R8)
        CD_S11 = X_S11 and (A_R5 or A_R6) and VALID and (not OCC_T3) and ((not OCC_P1) or AT_S11 or (not (H_R5 or H_R6)))  # the route from S11 is cancelled (R8)
        CD_S12 = X_S12 and (A_R7 or A_R8) and VALID and (not OCC_T3) and ((not OCC_P2) or AT_S12 or (not (H_R7 or H_R8)))  # the route from S12 is cancelled (R8)
        CD_S13 = X_S13 and (A_R9 or A_R10) and VALID and (not OCC_T4) and ((not OCC_P3) or AT_S13 or (not (H_R9 or H_R10)))  # the route from S13 is cancelled (R8)
        CD_S14 = X_S14 and (A_R11 or A_R12) and VALID and (not OCC_T4) and ((not OCC_P4) or AT_S14 or (not (H_R11 or H_R12)))  # the route from S14 is cancelled (R8)
        EX_P1 = P_P1  # a train in P1 leaves over a boundary, or has passed on
        RTI_P1 = VALID and U_P1 and (not OCC_P1) and (not (L_P1_2 and L_T3_3)) and EX_P1  # P1 may be released behind the train (R9)
        EX_P2 = P_P2  # a train in P2 leaves over a boundary, or has passed on
        RTI_P2 = VALID and U_P2 and (not OCC_P2) and (not (L_P2_2 and L_T3_4)) and EX_P2  # P2 may be released behind the train (R9)
        EX_P3 = P_P3  # a train in P3 leaves over a boundary, or has passed on
        RTI_P3 = VALID and U_P3 and (not OCC_P3) and (not (L_P3_2 and L_T4_3)) and EX_P3  # P3 may be released behind the train (R9)
        EX_P4 = P_P4  # a train in P4 leaves over a boundary, or has passed on
        RTI_P4 = VALID and U_P4 and (not OCC_P4) and (not (L_P4_2 and L_T4_4)) and EX_P4  # P4 may be released behind the train (R9)
        EX_T1 = P_T1 or L_T1_3 or L_T1_5  # a train in T1 leaves over a boundary, or has passed on
        RTI_T1 = VALID and U_T1 and (not OCC_T1) and (not (L_T1_3 and L_T2_3)) and (not ((L_T1_5 or L_T1_6) and (L_T3_1 or L_T3_2))) and EX_T1  # T1 may be released behind the train (R9)
        EX_T2 = P_T2  # a train in T2 leaves over a boundary, or has passed on
        RTI_T2 = VALID and U_T2 and (not OCC_T2) and (not (L_T2_1 and L_T1_1)) and (not (L_T2_2 and L_T1_6)) and (not ((L_T2_3 or L_T2_4) and (L_T4_1 or L_T4_2))) and EX_T2  # T2 may be released behind the train (R9)
        EX_T3 = P_T3  # a train in T3 leaves over a boundary, or has passed on
        RTI_T3 = VALID and U_T3 and (not OCC_T3) and (not ((L_T3_3 or L_T3_4) and L_T1_2)) and EX_T3  # T3 may be released behind the train (R9)
        EX_T4 = P_T4  # a train in T4 leaves over a boundary, or has passed on
        RTI_T4 = VALID and U_T4 and (not OCC_T4) and (not ((L_T4_3 or L_T4_4) and L_T2_1)) and EX_T4  # T4 may be released behind the train (R9)
        EX_UA = P_UA or L_UA_1  # a train in UA leaves over a boundary, or has passed on
        RTI_UA = VALID and U_UA and (not OCC_UA) and (not (L_UA_1 and (L_T2_2 or L_T2_4))) and EX_UA  # UA may be released behind the train (R9)
        RT_P1 = self._timer('RT_P1', RTI_P1, dt_ms)  # P1: release delay (R9)
        RT_P2 = self._timer('RT_P2', RTI_P2, dt_ms)  # P2: release delay (R9)
        RT_P3 = self._timer('RT_P3', RTI_P3, dt_ms)  # P3: release delay (R9)
        RT_P4 = self._timer('RT_P4', RTI_P4, dt_ms)  # P4: release delay (R9)
        RT_T1 = self._timer('RT_T1', RTI_T1, dt_ms)  # T1: release delay (R9)
        RT_T2 = self._timer('RT_T2', RTI_T2, dt_ms)  # T2: release delay (R9)
        RT_T3 = self._timer('RT_T3', RTI_T3, dt_ms)  # T3: release delay (R9)
        RT_T4 = self._timer('RT_T4', RTI_T4, dt_ms)  # T4: release delay (R9)
        RT_UA = self._timer('RT_UA', RTI_UA, dt_ms)  # UA: release delay (R9)
        CA_P1 = VALID and (not OCC_P1) and (not U_P1) and L_P1_2 and (not (L_P1_2 and L_T3_3))  # the lock before P1 was withdrawn (R8)
        HR_P1 = VALID and (not OCC_P1) and (not (L_P1_2 and L_T3_3)) and REL_P1 and L_P1_2  # P1 released by hand (R8, section fault release)
        SR_P1 = VALID and (not OCC_P1) and K_P1 and (REL_P1 or RELALL)  # P1 released after a restart (R16)
        RLS_P1 = RT_P1 or CA_P1 or HR_P1 or SR_P1  # P1 is released
        CA_P2 = VALID and (not OCC_P2) and (not U_P2) and L_P2_2 and (not (L_P2_2 and L_T3_4))  # the lock before P2 was withdrawn (R8)
        HR_P2 = VALID and (not OCC_P2) and (not (L_P2_2 and L_T3_4)) and REL_P2 and L_P2_2  # P2 released by hand (R8, section fault release)
        SR_P2 = VALID and (not OCC_P2) and K_P2 and (REL_P2 or RELALL)  # P2 released after a restart (R16)
        RLS_P2 = RT_P2 or CA_P2 or HR_P2 or SR_P2  # P2 is released
        CA_P3 = VALID and (not OCC_P3) and (not U_P3) and L_P3_2 and (not (L_P3_2 and L_T4_3))  # the lock before P3 was withdrawn (R8)
        HR_P3 = VALID and (not OCC_P3) and (not (L_P3_2 and L_T4_3)) and REL_P3 and L_P3_2  # P3 released by hand (R8, section fault release)
        SR_P3 = VALID and (not OCC_P3) and K_P3 and (REL_P3 or RELALL)  # P3 released after a restart (R16)
        RLS_P3 = RT_P3 or CA_P3 or HR_P3 or SR_P3  # P3 is released
        CA_P4 = VALID and (not OCC_P4) and (not U_P4) and L_P4_2 and (not (L_P4_2 and L_T4_4))  # the lock before P4 was withdrawn (R8)
        HR_P4 = VALID and (not OCC_P4) and (not (L_P4_2 and L_T4_4)) and REL_P4 and L_P4_2  # P4 released by hand (R8, section fault release)
        SR_P4 = VALID and (not OCC_P4) and K_P4 and (REL_P4 or RELALL)  # P4 released after a restart (R16)
        RLS_P4 = RT_P4 or CA_P4 or HR_P4 or SR_P4  # P4 is released
        CA_T1 = VALID and (not OCC_T1) and (not U_T1) and (L_T1_3 or L_T1_5 or L_T1_6) and (not (L_T1_3 and L_T2_3)) and (not ((L_T1_5 or L_T1_6) and (L_T3_1 or L_T3_2)))  # the lock before T1 was withdrawn (R8)
        HR_T1 = VALID and (not OCC_T1) and (not (L_T1_3 and L_T2_3)) and (not ((L_T1_5 or L_T1_6) and (L_T3_1 or L_T3_2))) and REL_T1 and (L_T1_1 or L_T1_2 or L_T1_3 or L_T1_5 or L_T1_6) and ((not (L_T1_1 or L_T1_2)) or ((not (A_R1 or A_R2 or A_R3 or A_R4)) and ((not OCC_DA) or AT_S1)))  # T1 released by hand (R8, section fault release)
        SR_T1 = VALID and (not OCC_T1) and K_T1 and (REL_T1 or RELALL)  # T1 released after a restart (R16)
        RLS_T1 = RT_T1 or CA_T1 or CD_S1 or HR_T1 or SR_T1  # T1 is released
        CA_T2 = VALID and (not OCC_T2) and (not U_T2) and (L_T2_1 or L_T2_2 or L_T2_3 or L_T2_4) and (not (L_T2_1 and L_T1_1)) and (not (L_T2_2 and L_T1_6)) and (not ((L_T2_3 or L_T2_4) and (L_T4_1 or L_T4_2)))  # the lock before T2 was withdrawn (R8)
        HR_T2 = VALID and (not OCC_T2) and (not (L_T2_1 and L_T1_1)) and (not (L_T2_2 and L_T1_6)) and (not ((L_T2_3 or L_T2_4) and (L_T4_1 or L_T4_2))) and REL_T2 and (L_T2_1 or L_T2_2 or L_T2_3 or L_T2_4)  # T2 released by hand (R8, section fault release)
        SR_T2 = VALID and (not OCC_T2) and K_T2 and (REL_T2 or RELALL)  # T2 released after a restart (R16)
        RLS_T2 = RT_T2 or CA_T2 or HR_T2 or SR_T2  # T2 is released
        CA_T3 = VALID and (not OCC_T3) and (not U_T3) and (L_T3_3 or L_T3_4) and (not ((L_T3_3 or L_T3_4) and L_T1_2))  # the lock before T3 was withdrawn (R8)
        HR_T3 = VALID and (not OCC_T3) and (not ((L_T3_3 or L_T3_4) and L_T1_2)) and REL_T3 and (L_T3_1 or L_T3_2 or L_T3_3 or L_T3_4) and ((not L_T3_1) or ((not (A_R5 or A_R6)) and ((not OCC_P1) or AT_S11))) and ((not L_T3_2) or ((not (A_R7 or A_R8)) and ((not OCC_P2) or AT_S12)))  # T3 released by hand (R8, section fault release)
        SR_T3 = VALID and (not OCC_T3) and K_T3 and (REL_T3 or RELALL)  # T3 released after a restart (R16)
        RLS_T3 = RT_T3 or CA_T3 or CD_S11 or CD_S12 or HR_T3 or SR_T3  # T3 is released
        CA_T4 = VALID and (not OCC_T4) and (not U_T4) and (L_T4_3 or L_T4_4) and (not ((L_T4_3 or L_T4_4) and L_T2_1))  # the lock before T4 was withdrawn (R8)
        HR_T4 = VALID and (not OCC_T4) and (not ((L_T4_3 or L_T4_4) and L_T2_1)) and REL_T4 and (L_T4_1 or L_T4_2 or L_T4_3 or L_T4_4) and ((not L_T4_1) or ((not (A_R9 or A_R10)) and ((not OCC_P3) or AT_S13))) and ((not L_T4_2) or ((not (A_R11 or A_R12)) and ((not OCC_P4) or AT_S14)))  # T4 released by hand (R8, section fault release)
        SR_T4 = VALID and (not OCC_T4) and K_T4 and (REL_T4 or RELALL)  # T4 released after a restart (R16)
        RLS_T4 = RT_T4 or CA_T4 or CD_S13 or CD_S14 or HR_T4 or SR_T4  # T4 is released
        CA_UA = VALID and (not OCC_UA) and (not U_UA) and L_UA_1 and (not (L_UA_1 and (L_T2_2 or L_T2_4)))  # the lock before UA was withdrawn (R8)
        HR_UA = VALID and (not OCC_UA) and (not (L_UA_1 and (L_T2_2 or L_T2_4))) and REL_UA and L_UA_1  # UA released by hand (R8, section fault release)
        SR_UA = VALID and (not OCC_UA) and K_UA and (REL_UA or RELALL)  # UA released after a restart (R16)
        RLS_UA = RT_UA or CA_UA or HR_UA or SR_UA  # UA is released
        TG_201 = (GW_T1_1 or GW_T1_2 or GW_T1_3 or GW_T1_5 or GW_T1_6 or GW_T2_1 or GW_T2_2 or GW_T2_3 or GW_T2_4)  # a grant touches machine 201 in this scan
        GPN_201 = (GW_T1_2 or GW_T1_5 or GW_T2_4)  # a grant needs 201 N
        MAN_201 = MN_201 and (not MR_201) and MOV_201 and (not TG_201)  # machine 201 moved N by hand
        GPR_201 = (GW_T1_1 or GW_T1_3 or GW_T1_6 or GW_T2_1 or GW_T2_2 or GW_T2_3)  # a grant needs 201 R
        MAR_201 = MR_201 and (not MN_201) and MOV_201 and (not TG_201)  # machine 201 moved R by hand
        HDN_201 = CN_201 and (not GPR_201) and (not MAR_201)  # the command N stays
        HDR_201 = CR_201 and (not GPN_201) and (not MAN_201)  # the command R stays
        TG_202 = (GW_T1_1 or GW_T1_2 or GW_T1_3 or GW_T1_5 or GW_T1_6 or GW_T2_1 or GW_T2_2 or GW_T2_3 or GW_T2_4)  # a grant touches machine 202 in this scan
        GPN_202 = (GW_T1_2 or GW_T1_5 or GW_T2_4)  # a grant needs 202 N
        MAN_202 = MN_202 and (not MR_202) and MOV_202 and (not TG_202)  # machine 202 moved N by hand
        GPR_202 = (GW_T1_1 or GW_T1_3 or GW_T1_6 or GW_T2_2)  # a grant needs 202 R
        MAR_202 = MR_202 and (not MN_202) and MOV_202 and (not TG_202)  # machine 202 moved R by hand
        HDN_202 = CN_202 and (not GPR_202) and (not MAR_202)  # the command N stays
        HDR_202 = CR_202 and (not GPN_202) and (not MAN_202)  # the command R stays
        TG_203 = (GW_T3_1 or GW_T3_2 or GW_T3_3 or GW_T3_4)  # a grant touches machine 203 in this scan
        GPN_203 = (GW_T3_1 or GW_T3_3)  # a grant needs 203 N
        MAN_203 = MN_203 and (not MR_203) and MOV_203 and (not TG_203)  # machine 203 moved N by hand
        GPR_203 = (GW_T3_2 or GW_T3_4)  # a grant needs 203 R
        MAR_203 = MR_203 and (not MN_203) and MOV_203 and (not TG_203)  # machine 203 moved R by hand
        HDN_203 = CN_203 and (not GPR_203) and (not MAR_203)  # the command N stays
        HDR_203 = CR_203 and (not GPN_203) and (not MAN_203)  # the command R stays
        TG_204 = (GW_T4_1 or GW_T4_2 or GW_T4_3 or GW_T4_4)  # a grant touches machine 204 in this scan
        GPN_204 = (GW_T4_1 or GW_T4_3)  # a grant needs 204 N
        MAN_204 = MN_204 and (not MR_204) and MOV_204 and (not TG_204)  # machine 204 moved N by hand
        GPR_204 = (GW_T4_2 or GW_T4_4)  # a grant needs 204 R
        MAR_204 = MR_204 and (not MN_204) and MOV_204 and (not TG_204)  # machine 204 moved R by hand
        HDN_204 = CN_204 and (not GPR_204) and (not MAR_204)  # the command N stays
        HDR_204 = CR_204 and (not GPN_204) and (not MAN_204)  # the command R stays
        STI_201 = (CN_201 and (not QN_201)) or (CR_201 and (not QR_201))  # machine 201 is not where it was commanded
        STI_202 = (CN_202 and (not QN_202)) or (CR_202 and (not QR_202))  # machine 202 is not where it was commanded
        STI_203 = (CN_203 and (not QN_203)) or (CR_203 and (not QR_203))  # machine 203 is not where it was commanded
        STI_204 = (CN_204 and (not QN_204)) or (CR_204 and (not QR_204))  # machine 204 is not where it was commanded
        ST_201 = self._timer('ST_201', STI_201, dt_ms)  # machine 201: time-out
        ST_202 = self._timer('ST_202', STI_202, dt_ms)  # machine 202: time-out
        ST_203 = self._timer('ST_203', STI_203, dt_ms)  # machine 203: time-out
        ST_204 = self._timer('ST_204', STI_204, dt_ms)  # machine 204: time-out
        KP_R1 = (not NU_T1_1) and (not CD_S1)  # route S1-B1 stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_S1) and (not CAN_S1)  # proceed for route S1-B1 (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route S1-B1: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_T1_1) and (not CD_S1)  # route S1-B2 stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_S1) and (not CAN_S1)  # proceed for route S1-B2 (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route S1-B2: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_T1_1) and (not CD_S1)  # route S1-B3 stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_S1) and (not CAN_S1)  # proceed for route S1-B3 (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route S1-B3: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_T1_1) and (not CD_S1)  # route S1-B4 stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_S1) and (not CAN_S1)  # proceed for route S1-B4 (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route S1-B4: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_T3_1) and (not CD_S11)  # route S11-D stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_S11) and (not CAN_S11)  # proceed for route S11-D (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route S11-D: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_T3_1) and (not CD_S11)  # route S11-U stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_S11) and (not CAN_S11)  # proceed for route S11-U (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route S11-U: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_T3_2) and (not CD_S12)  # route S12-D stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_S12) and (not CAN_S12)  # proceed for route S12-D (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route S12-D: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_T3_2) and (not CD_S12)  # route S12-U stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_S12) and (not CAN_S12)  # proceed for route S12-U (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route S12-U: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_T4_1) and (not CD_S13)  # route S13-D stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_S13) and (not CAN_S13)  # proceed for route S13-D (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route S13-D: a condition was lost; no reopening by itself (R14)
        KP_R10 = (not NU_T4_1) and (not CD_S13)  # route S13-U stays set
        PR_R10 = A_R10 and B_R10 and W_R10 and CO_R10 and KP_R10 and (not X_S13) and (not CAN_S13)  # proceed for route S13-U (R3, R11)
        LS_R10 = S_R10 and (not CO_R10)  # route S13-U: a condition was lost; no reopening by itself (R14)
        KP_R11 = (not NU_T4_2) and (not CD_S14)  # route S14-D stays set
        PR_R11 = A_R11 and B_R11 and W_R11 and CO_R11 and KP_R11 and (not X_S14) and (not CAN_S14)  # proceed for route S14-D (R3, R11)
        LS_R11 = S_R11 and (not CO_R11)  # route S14-D: a condition was lost; no reopening by itself (R14)
        KP_R12 = (not NU_T4_2) and (not CD_S14)  # route S14-U stays set
        PR_R12 = A_R12 and B_R12 and W_R12 and CO_R12 and KP_R12 and (not X_S14) and (not CAN_S14)  # proceed for route S14-U (R3, R11)
        LS_R12 = S_R12 and (not CO_R12)  # route S14-U: a condition was lost; no reopening by itself (R14)
        N_CN_201 = GPN_201 or MAN_201 or HDN_201  # machine 201 commanded N
        N_CR_201 = GPR_201 or MAR_201 or HDR_201  # machine 201 commanded R
        N_CN_202 = GPN_202 or MAN_202 or HDN_202  # machine 202 commanded N
        N_CR_202 = GPR_202 or MAR_202 or HDR_202  # machine 202 commanded R
        N_CN_203 = GPN_203 or MAN_203 or HDN_203  # machine 203 commanded N
        N_CR_203 = GPR_203 or MAR_203 or HDR_203  # machine 203 commanded R
        N_CN_204 = GPN_204 or MAN_204 or HDN_204  # machine 204 commanded N
        N_CR_204 = GPR_204 or MAR_204 or HDR_204  # machine 204 commanded R
        N_AL_201 = ST_201  # alarm: machine 201 not detected
        N_AL_202 = ST_202  # alarm: machine 202 not detected
        N_AL_203 = ST_203  # alarm: machine 203 not detected
        N_AL_204 = ST_204  # alarm: machine 204 not detected
        N_TH_201 = ((CN_201 and QN_201) or (CR_201 and QR_201)) and (not (GPN_201 or GPR_201 or MAN_201 or MAR_201))  # machine 201 was detected where it is commanded
        N_TR_201 = (TH_201 and VALID and ((CN_201 and (not QN_201) and (not GPR_201) and (not MAR_201)) or (CR_201 and (not QR_201) and (not GPN_201) and (not MAN_201)))) or (TR_201 and (not (TC_201 and VALID and (not OCC_T1) and (not OCC_T2))))  # machine 201 was trailed
        N_TH_202 = ((CN_202 and QN_202) or (CR_202 and QR_202)) and (not (GPN_202 or GPR_202 or MAN_202 or MAR_202))  # machine 202 was detected where it is commanded
        N_TR_202 = (TH_202 and VALID and ((CN_202 and (not QN_202) and (not GPR_202) and (not MAR_202)) or (CR_202 and (not QR_202) and (not GPN_202) and (not MAN_202)))) or (TR_202 and (not (TC_202 and VALID and (not OCC_T1) and (not OCC_T2))))  # machine 202 was trailed
        N_TH_203 = ((CN_203 and QN_203) or (CR_203 and QR_203)) and (not (GPN_203 or GPR_203 or MAN_203 or MAR_203))  # machine 203 was detected where it is commanded
        N_TR_203 = (TH_203 and VALID and ((CN_203 and (not QN_203) and (not GPR_203) and (not MAR_203)) or (CR_203 and (not QR_203) and (not GPN_203) and (not MAN_203)))) or (TR_203 and (not (TC_203 and VALID and (not OCC_T3))))  # machine 203 was trailed
        N_TH_204 = ((CN_204 and QN_204) or (CR_204 and QR_204)) and (not (GPN_204 or GPR_204 or MAN_204 or MAR_204))  # machine 204 was detected where it is commanded
        N_TR_204 = (TH_204 and VALID and ((CN_204 and (not QN_204) and (not GPR_204) and (not MAR_204)) or (CR_204 and (not QR_204) and (not GPN_204) and (not MAN_204)))) or (TR_204 and (not (TC_204 and VALID and (not OCC_T4))))  # machine 204 was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route S1-B1 active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route S1-B1 locked
        N_W_R1 = (W_R1 or LK_R1 or ((REQ == 1) and B_R1)) and (not LS_R1) and KP_R1 and (not X_S1) and (not CAN_S1)  # route S1-B1: proceed wanted
        N_S_R1 = PR_R1  # route S1-B1: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route S1-B1: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route S1-B2 active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route S1-B2 locked
        N_W_R2 = (W_R2 or LK_R2 or ((REQ == 2) and B_R2)) and (not LS_R2) and KP_R2 and (not X_S1) and (not CAN_S1)  # route S1-B2: proceed wanted
        N_S_R2 = PR_R2  # route S1-B2: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route S1-B2: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route S1-B3 active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route S1-B3 locked
        N_W_R3 = (W_R3 or LK_R3 or ((REQ == 3) and B_R3)) and (not LS_R3) and KP_R3 and (not X_S1) and (not CAN_S1)  # route S1-B3: proceed wanted
        N_S_R3 = PR_R3  # route S1-B3: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route S1-B3: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route S1-B4 active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route S1-B4 locked
        N_W_R4 = (W_R4 or LK_R4 or ((REQ == 4) and B_R4)) and (not LS_R4) and KP_R4 and (not X_S1) and (not CAN_S1)  # route S1-B4: proceed wanted
        N_S_R4 = PR_R4  # route S1-B4: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route S1-B4: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route S11-D active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route S11-D locked
        N_W_R5 = (W_R5 or LK_R5 or ((REQ == 5) and B_R5)) and (not LS_R5) and KP_R5 and (not X_S11) and (not CAN_S11)  # route S11-D: proceed wanted
        N_S_R5 = PR_R5  # route S11-D: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route S11-D: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route S11-U active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route S11-U locked
        N_W_R6 = (W_R6 or LK_R6 or ((REQ == 6) and B_R6)) and (not LS_R6) and KP_R6 and (not X_S11) and (not CAN_S11)  # route S11-U: proceed wanted
        N_S_R6 = PR_R6  # route S11-U: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route S11-U: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route S12-D active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route S12-D locked
        N_W_R7 = (W_R7 or LK_R7 or ((REQ == 7) and B_R7)) and (not LS_R7) and KP_R7 and (not X_S12) and (not CAN_S12)  # route S12-D: proceed wanted
        N_S_R7 = PR_R7  # route S12-D: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route S12-D: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route S12-U active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route S12-U locked
        N_W_R8 = (W_R8 or LK_R8 or ((REQ == 8) and B_R8)) and (not LS_R8) and KP_R8 and (not X_S12) and (not CAN_S12)  # route S12-U: proceed wanted
        N_S_R8 = PR_R8  # route S12-U: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route S12-U: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route S13-D active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route S13-D locked
        N_W_R9 = (W_R9 or LK_R9 or ((REQ == 9) and B_R9)) and (not LS_R9) and KP_R9 and (not X_S13) and (not CAN_S13)  # route S13-D: proceed wanted
        N_S_R9 = PR_R9  # route S13-D: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route S13-D: signal has been open
        N_A_R10 = (A_R10 or G_R10) and KP_R10  # route S13-U active
        N_B_R10 = (B_R10 or LK_R10) and KP_R10  # route S13-U locked
        N_W_R10 = (W_R10 or LK_R10 or ((REQ == 10) and B_R10)) and (not LS_R10) and KP_R10 and (not X_S13) and (not CAN_S13)  # route S13-U: proceed wanted
        N_S_R10 = PR_R10  # route S13-U: proceed
        N_H_R10 = (H_R10 or PR_R10) and KP_R10  # route S13-U: signal has been open
        N_A_R11 = (A_R11 or G_R11) and KP_R11  # route S14-D active
        N_B_R11 = (B_R11 or LK_R11) and KP_R11  # route S14-D locked
        N_W_R11 = (W_R11 or LK_R11 or ((REQ == 11) and B_R11)) and (not LS_R11) and KP_R11 and (not X_S14) and (not CAN_S14)  # route S14-D: proceed wanted
        N_S_R11 = PR_R11  # route S14-D: proceed
        N_H_R11 = (H_R11 or PR_R11) and KP_R11  # route S14-D: signal has been open
        N_A_R12 = (A_R12 or G_R12) and KP_R12  # route S14-U active
        N_B_R12 = (B_R12 or LK_R12) and KP_R12  # route S14-U locked
        N_W_R12 = (W_R12 or LK_R12 or ((REQ == 12) and B_R12)) and (not LS_R12) and KP_R12 and (not X_S14) and (not CAN_S14)  # route S14-U: proceed wanted
        N_S_R12 = PR_R12  # route S14-U: proceed
        N_H_R12 = (H_R12 or PR_R12) and KP_R12  # route S14-U: signal has been open
        N_X_S1 = (X_S1 or CAN_S1) and (A_R1 or A_R2 or A_R3 or A_R4) and (not CD_S1)  # S1: cancelling
        N_X_S11 = (X_S11 or CAN_S11) and (A_R5 or A_R6) and (not CD_S11)  # S11: cancelling
        N_X_S12 = (X_S12 or CAN_S12) and (A_R7 or A_R8) and (not CD_S12)  # S12: cancelling
        N_X_S13 = (X_S13 or CAN_S13) and (A_R9 or A_R10) and (not CD_S13)  # S13: cancelling
        N_X_S14 = (X_S14 or CAN_S14) and (A_R11 or A_R12) and (not CD_S14)  # S14: cancelling
        N_K_P1 = K_P1 and (not RLS_P1)  # P1: restart lock (R16)
        N_L_P1_2 = (L_P1_2 or GW_P1_2) and (not RLS_P1)  # P1 locked from P1|T3@203.normal to B1
        N_F_P1 = (F_P1 or LK_R1) and (not RLS_P1)  # P1 firmly locked
        N_U_P1 = (U_P1 or NU_P1_2) and (not RLS_P1)  # P1 used by a train (R9)
        N_P_P1 = (P_P1 or (U_P1 and OCC_P1 and NU_T3_1)) and (not RLS_P1)  # P1: the train went on (R9)
        N_D_P1 = (D_P1 or ((not VALID) and L_P1_2)) and (not RLS_P1)  # P1: detection is not relied on, inputs were lost or a train is called on
        N_K_P2 = K_P2 and (not RLS_P2)  # P2: restart lock (R16)
        N_L_P2_2 = (L_P2_2 or GW_P2_2) and (not RLS_P2)  # P2 locked from P2|T3@203.reverse to B2
        N_F_P2 = (F_P2 or LK_R2) and (not RLS_P2)  # P2 firmly locked
        N_U_P2 = (U_P2 or NU_P2_2) and (not RLS_P2)  # P2 used by a train (R9)
        N_P_P2 = (P_P2 or (U_P2 and OCC_P2 and NU_T3_2)) and (not RLS_P2)  # P2: the train went on (R9)
        N_D_P2 = (D_P2 or ((not VALID) and L_P2_2)) and (not RLS_P2)  # P2: detection is not relied on, inputs were lost or a train is called on
        N_K_P3 = K_P3 and (not RLS_P3)  # P3: restart lock (R16)
        N_L_P3_2 = (L_P3_2 or GW_P3_2) and (not RLS_P3)  # P3 locked from P3|T4@204.normal to B3
        N_F_P3 = (F_P3 or LK_R3) and (not RLS_P3)  # P3 firmly locked
        N_U_P3 = (U_P3 or NU_P3_2) and (not RLS_P3)  # P3 used by a train (R9)
        N_P_P3 = (P_P3 or (U_P3 and OCC_P3 and NU_T4_1)) and (not RLS_P3)  # P3: the train went on (R9)
        N_D_P3 = (D_P3 or ((not VALID) and L_P3_2)) and (not RLS_P3)  # P3: detection is not relied on, inputs were lost or a train is called on
        N_K_P4 = K_P4 and (not RLS_P4)  # P4: restart lock (R16)
        N_L_P4_2 = (L_P4_2 or GW_P4_2) and (not RLS_P4)  # P4 locked from P4|T4@204.reverse to B4
        N_F_P4 = (F_P4 or LK_R4) and (not RLS_P4)  # P4 firmly locked
        N_U_P4 = (U_P4 or NU_P4_2) and (not RLS_P4)  # P4 used by a train (R9)
        N_P_P4 = (P_P4 or (U_P4 and OCC_P4 and NU_T4_2)) and (not RLS_P4)  # P4: the train went on (R9)
        N_D_P4 = (D_P4 or ((not VALID) and L_P4_2)) and (not RLS_P4)  # P4: detection is not relied on, inputs were lost or a train is called on
        N_K_T1 = K_T1 and (not RLS_T1)  # T1: restart lock (R16)
        N_L_T1_1 = (L_T1_1 or GW_T1_1) and (not RLS_T1)  # T1 locked from D to T1|T2@201B.reverse
        N_L_T1_2 = (L_T1_2 or GW_T1_2) and (not RLS_T1)  # T1 locked from D to T1|T3@202B.toe
        N_L_T1_3 = (L_T1_3 or GW_T1_3) and (not RLS_T1)  # T1 locked from T1|T2@201B.reverse to D
        N_L_T1_5 = (L_T1_5 or GW_T1_5) and (not RLS_T1)  # T1 locked from T1|T3@202B.toe to D
        N_L_T1_6 = (L_T1_6 or GW_T1_6) and (not RLS_T1)  # T1 locked from T1|T3@202B.toe to T1|T2@202B.reverse
        N_F_T1 = (F_T1 or LK_R3 or LK_R4 or LK_R1 or LK_R2 or LK_R9 or LK_R11 or LK_R5 or LK_R7 or LK_R6 or LK_R8) and (not RLS_T1)  # T1 firmly locked
        N_U_T1 = (U_T1 or NU_T1_1 or NU_T1_2 or NU_T1_4) and (not RLS_T1)  # T1 used by a train (R9)
        N_P_T1 = (P_T1 or (U_T1 and OCC_T1 and (NU_T2_1 or NU_T2_2 or NU_T3_3))) and (not RLS_T1)  # T1: the train went on (R9)
        N_D_T1 = (D_T1 or ((not VALID) and (L_T1_1 or L_T1_2 or L_T1_3 or L_T1_5 or L_T1_6))) and (not RLS_T1)  # T1: detection is not relied on, inputs were lost or a train is called on
        N_K_T2 = K_T2 and (not RLS_T2)  # T2: restart lock (R16)
        N_L_T2_1 = (L_T2_1 or GW_T2_1) and (not RLS_T2)  # T2 locked from T1|T2@201B.reverse to T2|T4@201B.toe
        N_L_T2_2 = (L_T2_2 or GW_T2_2) and (not RLS_T2)  # T2 locked from T1|T2@202B.reverse to T2|UA@202A.toe
        N_L_T2_3 = (L_T2_3 or GW_T2_3) and (not RLS_T2)  # T2 locked from T2|T4@201B.toe to T1|T2@201B.reverse
        N_L_T2_4 = (L_T2_4 or GW_T2_4) and (not RLS_T2)  # T2 locked from T2|T4@201B.toe to T2|UA@202A.toe
        N_F_T2 = (F_T2 or LK_R3 or LK_R4 or LK_R6 or LK_R8 or LK_R9 or LK_R11 or LK_R10 or LK_R12) and (not RLS_T2)  # T2 firmly locked
        N_U_T2 = (U_T2 or NU_T2_1 or NU_T2_2 or NU_T2_3) and (not RLS_T2)  # T2 used by a train (R9)
        N_P_T2 = (P_T2 or (U_T2 and OCC_T2 and (NU_T1_2 or NU_T4_3 or NU_UA_1))) and (not RLS_T2)  # T2: the train went on (R9)
        N_D_T2 = (D_T2 or ((not VALID) and (L_T2_1 or L_T2_2 or L_T2_3 or L_T2_4))) and (not RLS_T2)  # T2: detection is not relied on, inputs were lost or a train is called on
        N_K_T3 = K_T3 and (not RLS_T3)  # T3: restart lock (R16)
        N_L_T3_1 = (L_T3_1 or GW_T3_1) and (not RLS_T3)  # T3 locked from P1|T3@203.normal to T1|T3@202B.toe
        N_L_T3_2 = (L_T3_2 or GW_T3_2) and (not RLS_T3)  # T3 locked from P2|T3@203.reverse to T1|T3@202B.toe
        N_L_T3_3 = (L_T3_3 or GW_T3_3) and (not RLS_T3)  # T3 locked from T1|T3@202B.toe to P1|T3@203.normal
        N_L_T3_4 = (L_T3_4 or GW_T3_4) and (not RLS_T3)  # T3 locked from T1|T3@202B.toe to P2|T3@203.reverse
        N_F_T3 = (F_T3 or LK_R5 or LK_R6 or LK_R7 or LK_R8 or LK_R1 or LK_R2) and (not RLS_T3)  # T3 firmly locked
        N_U_T3 = (U_T3 or NU_T3_1 or NU_T3_2 or NU_T3_3) and (not RLS_T3)  # T3 used by a train (R9)
        N_P_T3 = (P_T3 or (U_T3 and OCC_T3 and (NU_P1_2 or NU_P2_2 or NU_T1_4))) and (not RLS_T3)  # T3: the train went on (R9)
        N_D_T3 = (D_T3 or ((not VALID) and (L_T3_1 or L_T3_2 or L_T3_3 or L_T3_4))) and (not RLS_T3)  # T3: detection is not relied on, inputs were lost or a train is called on
        N_K_T4 = K_T4 and (not RLS_T4)  # T4: restart lock (R16)
        N_L_T4_1 = (L_T4_1 or GW_T4_1) and (not RLS_T4)  # T4 locked from P3|T4@204.normal to T2|T4@201B.toe
        N_L_T4_2 = (L_T4_2 or GW_T4_2) and (not RLS_T4)  # T4 locked from P4|T4@204.reverse to T2|T4@201B.toe
        N_L_T4_3 = (L_T4_3 or GW_T4_3) and (not RLS_T4)  # T4 locked from T2|T4@201B.toe to P3|T4@204.normal
        N_L_T4_4 = (L_T4_4 or GW_T4_4) and (not RLS_T4)  # T4 locked from T2|T4@201B.toe to P4|T4@204.reverse
        N_F_T4 = (F_T4 or LK_R9 or LK_R10 or LK_R11 or LK_R12 or LK_R3 or LK_R4) and (not RLS_T4)  # T4 firmly locked
        N_U_T4 = (U_T4 or NU_T4_1 or NU_T4_2 or NU_T4_3) and (not RLS_T4)  # T4 used by a train (R9)
        N_P_T4 = (P_T4 or (U_T4 and OCC_T4 and (NU_P3_2 or NU_P4_2 or NU_T2_3))) and (not RLS_T4)  # T4: the train went on (R9)
        N_D_T4 = (D_T4 or ((not VALID) and (L_T4_1 or L_T4_2 or L_T4_3 or L_T4_4))) and (not RLS_T4)  # T4: detection is not relied on, inputs were lost or a train is called on
        N_K_UA = K_UA and (not RLS_UA)  # UA: restart lock (R16)
        N_L_UA_1 = (L_UA_1 or GW_UA_1) and (not RLS_UA)  # UA locked from T2|UA@202A.toe to U
        N_F_UA = (F_UA or LK_R6 or LK_R8 or LK_R10 or LK_R12) and (not RLS_UA)  # UA firmly locked
        N_U_UA = (U_UA or NU_UA_1) and (not RLS_UA)  # UA used by a train (R9)
        N_P_UA = P_UA and (not RLS_UA)  # UA: the train went on (R9)
        N_D_UA = (D_UA or ((not VALID) and L_UA_1)) and (not RLS_UA)  # UA: detection is not relied on, inputs were lost or a train is called on
        N_C_S1 = (PR_R1 or PR_R2 or PR_R3 or PR_R4) and False  # S1 shows clear
        N_C_S11 = (PR_R5 or PR_R6) and PR_R5  # S11 shows clear
        N_C_S12 = (PR_R7 or PR_R8) and PR_R7  # S12 shows clear
        N_C_S13 = (PR_R9 or PR_R10) and PR_R9  # S13 shows clear
        N_C_S14 = (PR_R11 or PR_R12) and PR_R11  # S14 shows clear
        self.state = {
            'CN_201': bool(N_CN_201),
            'CR_201': bool(N_CR_201),
            'CN_202': bool(N_CN_202),
            'CR_202': bool(N_CR_202),
            'CN_203': bool(N_CN_203),
            'CR_203': bool(N_CR_203),
            'CN_204': bool(N_CN_204),
            'CR_204': bool(N_CR_204),
            'AL_201': bool(N_AL_201),
            'AL_202': bool(N_AL_202),
            'AL_203': bool(N_AL_203),
            'AL_204': bool(N_AL_204),
            'TH_201': bool(N_TH_201),
            'TR_201': bool(N_TR_201),
            'TH_202': bool(N_TH_202),
            'TR_202': bool(N_TR_202),
            'TH_203': bool(N_TH_203),
            'TR_203': bool(N_TR_203),
            'TH_204': bool(N_TH_204),
            'TR_204': bool(N_TR_204),
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
            'X_S1': bool(N_X_S1),
            'X_S11': bool(N_X_S11),
            'X_S12': bool(N_X_S12),
            'X_S13': bool(N_X_S13),
            'X_S14': bool(N_X_S14),
            'K_P1': bool(N_K_P1),
            'L_P1_2': bool(N_L_P1_2),
            'F_P1': bool(N_F_P1),
            'U_P1': bool(N_U_P1),
            'P_P1': bool(N_P_P1),
            'D_P1': bool(N_D_P1),
            'K_P2': bool(N_K_P2),
            'L_P2_2': bool(N_L_P2_2),
            'F_P2': bool(N_F_P2),
            'U_P2': bool(N_U_P2),
            'P_P2': bool(N_P_P2),
            'D_P2': bool(N_D_P2),
            'K_P3': bool(N_K_P3),
            'L_P3_2': bool(N_L_P3_2),
            'F_P3': bool(N_F_P3),
            'U_P3': bool(N_U_P3),
            'P_P3': bool(N_P_P3),
            'D_P3': bool(N_D_P3),
            'K_P4': bool(N_K_P4),
            'L_P4_2': bool(N_L_P4_2),
            'F_P4': bool(N_F_P4),
            'U_P4': bool(N_U_P4),
            'P_P4': bool(N_P_P4),
            'D_P4': bool(N_D_P4),
            'K_T1': bool(N_K_T1),
            'L_T1_1': bool(N_L_T1_1),
            'L_T1_2': bool(N_L_T1_2),
            'L_T1_3': bool(N_L_T1_3),
            'L_T1_5': bool(N_L_T1_5),
            'L_T1_6': bool(N_L_T1_6),
            'F_T1': bool(N_F_T1),
            'U_T1': bool(N_U_T1),
            'P_T1': bool(N_P_T1),
            'D_T1': bool(N_D_T1),
            'K_T2': bool(N_K_T2),
            'L_T2_1': bool(N_L_T2_1),
            'L_T2_2': bool(N_L_T2_2),
            'L_T2_3': bool(N_L_T2_3),
            'L_T2_4': bool(N_L_T2_4),
            'F_T2': bool(N_F_T2),
            'U_T2': bool(N_U_T2),
            'P_T2': bool(N_P_T2),
            'D_T2': bool(N_D_T2),
            'K_T3': bool(N_K_T3),
            'L_T3_1': bool(N_L_T3_1),
            'L_T3_2': bool(N_L_T3_2),
            'L_T3_3': bool(N_L_T3_3),
            'L_T3_4': bool(N_L_T3_4),
            'F_T3': bool(N_F_T3),
            'U_T3': bool(N_U_T3),
            'P_T3': bool(N_P_T3),
            'D_T3': bool(N_D_T3),
            'K_T4': bool(N_K_T4),
            'L_T4_1': bool(N_L_T4_1),
            'L_T4_2': bool(N_L_T4_2),
            'L_T4_3': bool(N_L_T4_3),
            'L_T4_4': bool(N_L_T4_4),
            'F_T4': bool(N_F_T4),
            'U_T4': bool(N_U_T4),
            'P_T4': bool(N_P_T4),
            'D_T4': bool(N_D_T4),
            'K_UA': bool(N_K_UA),
            'L_UA_1': bool(N_L_UA_1),
            'F_UA': bool(N_F_UA),
            'U_UA': bool(N_U_UA),
            'P_UA': bool(N_P_UA),
            'D_UA': bool(N_D_UA),
            'C_S1': bool(N_C_S1),
            'C_S11': bool(N_C_S11),
            'C_S12': bool(N_C_S12),
            'C_S13': bool(N_C_S13),
            'C_S14': bool(N_C_S14),
        }
        CN_201 = self.state['CN_201']
        CR_201 = self.state['CR_201']
        CN_202 = self.state['CN_202']
        CR_202 = self.state['CR_202']
        CN_203 = self.state['CN_203']
        CR_203 = self.state['CR_203']
        CN_204 = self.state['CN_204']
        CR_204 = self.state['CR_204']
        AL_201 = self.state['AL_201']
        AL_202 = self.state['AL_202']
        AL_203 = self.state['AL_203']
        AL_204 = self.state['AL_204']
        TH_201 = self.state['TH_201']
        TR_201 = self.state['TR_201']
        TH_202 = self.state['TH_202']
        TR_202 = self.state['TR_202']
        TH_203 = self.state['TH_203']
        TR_203 = self.state['TR_203']
        TH_204 = self.state['TH_204']
        TR_204 = self.state['TR_204']
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
        X_S1 = self.state['X_S1']
        X_S11 = self.state['X_S11']
        X_S12 = self.state['X_S12']
        X_S13 = self.state['X_S13']
        X_S14 = self.state['X_S14']
        K_P1 = self.state['K_P1']
        L_P1_2 = self.state['L_P1_2']
        F_P1 = self.state['F_P1']
        U_P1 = self.state['U_P1']
        P_P1 = self.state['P_P1']
        D_P1 = self.state['D_P1']
        K_P2 = self.state['K_P2']
        L_P2_2 = self.state['L_P2_2']
        F_P2 = self.state['F_P2']
        U_P2 = self.state['U_P2']
        P_P2 = self.state['P_P2']
        D_P2 = self.state['D_P2']
        K_P3 = self.state['K_P3']
        L_P3_2 = self.state['L_P3_2']
        F_P3 = self.state['F_P3']
        U_P3 = self.state['U_P3']
        P_P3 = self.state['P_P3']
        D_P3 = self.state['D_P3']
        K_P4 = self.state['K_P4']
        L_P4_2 = self.state['L_P4_2']
        F_P4 = self.state['F_P4']
        U_P4 = self.state['U_P4']
        P_P4 = self.state['P_P4']
        D_P4 = self.state['D_P4']
        K_T1 = self.state['K_T1']
        L_T1_1 = self.state['L_T1_1']
        L_T1_2 = self.state['L_T1_2']
        L_T1_3 = self.state['L_T1_3']
        L_T1_5 = self.state['L_T1_5']
        L_T1_6 = self.state['L_T1_6']
        F_T1 = self.state['F_T1']
        U_T1 = self.state['U_T1']
        P_T1 = self.state['P_T1']
        D_T1 = self.state['D_T1']
        K_T2 = self.state['K_T2']
        L_T2_1 = self.state['L_T2_1']
        L_T2_2 = self.state['L_T2_2']
        L_T2_3 = self.state['L_T2_3']
        L_T2_4 = self.state['L_T2_4']
        F_T2 = self.state['F_T2']
        U_T2 = self.state['U_T2']
        P_T2 = self.state['P_T2']
        D_T2 = self.state['D_T2']
        K_T3 = self.state['K_T3']
        L_T3_1 = self.state['L_T3_1']
        L_T3_2 = self.state['L_T3_2']
        L_T3_3 = self.state['L_T3_3']
        L_T3_4 = self.state['L_T3_4']
        F_T3 = self.state['F_T3']
        U_T3 = self.state['U_T3']
        P_T3 = self.state['P_T3']
        D_T3 = self.state['D_T3']
        K_T4 = self.state['K_T4']
        L_T4_1 = self.state['L_T4_1']
        L_T4_2 = self.state['L_T4_2']
        L_T4_3 = self.state['L_T4_3']
        L_T4_4 = self.state['L_T4_4']
        F_T4 = self.state['F_T4']
        U_T4 = self.state['U_T4']
        P_T4 = self.state['P_T4']
        D_T4 = self.state['D_T4']
        K_UA = self.state['K_UA']
        L_UA_1 = self.state['L_UA_1']
        F_UA = self.state['F_UA']
        U_UA = self.state['U_UA']
        P_UA = self.state['P_UA']
        D_UA = self.state['D_UA']
        C_S1 = self.state['C_S1']
        C_S11 = self.state['C_S11']
        C_S12 = self.state['C_S12']
        C_S13 = self.state['C_S13']
        C_S14 = self.state['C_S14']
        return {
            'YN_201': bool(CN_201),
            'YR_201': bool(CR_201),
            'YN_202': bool(CN_202),
            'YR_202': bool(CR_202),
            'YN_203': bool(CN_203),
            'YR_203': bool(CR_203),
            'YN_204': bool(CN_204),
            'YR_204': bool(CR_204),
            'YA_201': bool(AL_201),
            'YA_202': bool(AL_202),
            'YA_203': bool(AL_203),
            'YA_204': bool(AL_204),
            'YT_201': bool(TR_201),
            'YT_202': bool(TR_202),
            'YT_203': bool(TR_203),
            'YT_204': bool(TR_204),
            'YL_P1': bool(K_P1 or L_P1_2),
            'YL_P2': bool(K_P2 or L_P2_2),
            'YL_P3': bool(K_P3 or L_P3_2),
            'YL_P4': bool(K_P4 or L_P4_2),
            'YL_T1': bool(K_T1 or L_T1_1 or L_T1_2 or L_T1_3 or L_T1_5 or L_T1_6),
            'YL_T2': bool(K_T2 or L_T2_1 or L_T2_2 or L_T2_3 or L_T2_4),
            'YL_T3': bool(K_T3 or L_T3_1 or L_T3_2 or L_T3_3 or L_T3_4),
            'YL_T4': bool(K_T4 or L_T4_1 or L_T4_2 or L_T4_3 or L_T4_4),
            'YL_UA': bool(K_UA or L_UA_1),
            'YP_S1': bool(C_S1),
            'YY_S1': bool((S_R1 or S_R2 or S_R3 or S_R4) and (not C_S1)),
            'YS_S1': bool((not (S_R1 or S_R2 or S_R3 or S_R4))),
            'YP_S11': bool(C_S11),
            'YY_S11': bool((S_R5 or S_R6) and (not C_S11)),
            'YS_S11': bool((not (S_R5 or S_R6))),
            'YP_S12': bool(C_S12),
            'YY_S12': bool((S_R7 or S_R8) and (not C_S12)),
            'YS_S12': bool((not (S_R7 or S_R8))),
            'YP_S13': bool(C_S13),
            'YY_S13': bool((S_R9 or S_R10) and (not C_S13)),
            'YS_S13': bool((not (S_R9 or S_R10))),
            'YP_S14': bool(C_S14),
            'YY_S14': bool((S_R11 or S_R12) and (not C_S14)),
            'YS_S14': bool((not (S_R11 or S_R12))),
        }
