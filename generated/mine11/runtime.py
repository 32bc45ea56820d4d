# Interlocking mine11, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout c8959546ad8b3153313384257f05acc6d6ab6516d70f9c531bbeb73e9e2fb90c
# claims f466c89ef9155015f1597011fa57c85e371e5b794c3390aa8d8b9887e8fe6df5
"""Interlocking mine11: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_X1': (0, 2),  # operator: cancel the route from X1
    'CAN_X2': (0, 2),  # operator: cancel the route from X2
    'CAN_X3': (0, 2),  # operator: cancel the route from X3
    'CAN_X4': (0, 2),  # operator: cancel the route from X4
    'CAN_X5': (0, 2),  # operator: cancel the route from X5
    'CAN_X6': (0, 2),  # operator: cancel the route from X6
    'CAN_X7': (0, 2),  # operator: cancel the route from X7
    'REQ': (0, 10),  # operator: set route number, 0 = none
    'LREQ': (0, 10),  # operator on the spot: set route number, 0 = none
    'VOY': (0, 3),  # operator: voyage number, 0 = none
    'CLR_ap_E': (0, 2),  # section ap_E reported clear
    'CLR_ap_W': (0, 2),  # section ap_W reported clear
    'CLR_q1': (0, 2),  # section q1 reported clear
    'CLR_q10': (0, 2),  # section q10 reported clear
    'CLR_q11': (0, 2),  # section q11 reported clear
    'CLR_q2': (0, 2),  # section q2 reported clear
    'CLR_q3': (0, 2),  # section q3 reported clear
    'CLR_q4': (0, 2),  # section q4 reported clear
    'CLR_q5': (0, 2),  # section q5 reported clear
    'CLR_q6': (0, 2),  # section q6 reported clear
    'CLR_q7': (0, 2),  # section q7 reported clear
    'CLR_q8': (0, 2),  # section q8 reported clear
    'CLR_q9': (0, 2),  # section q9 reported clear
    'REL_q1': (0, 2),  # operator: release section q1 (hold until released)
    'REL_q10': (0, 2),  # operator: release section q10 (hold until released)
    'REL_q11': (0, 2),  # operator: release section q11 (hold until released)
    'REL_q2': (0, 2),  # operator: release section q2 (hold until released)
    'REL_q3': (0, 2),  # operator: release section q3 (hold until released)
    'REL_q4': (0, 2),  # operator: release section q4 (hold until released)
    'REL_q5': (0, 2),  # operator: release section q5 (hold until released)
    'REL_q6': (0, 2),  # operator: release section q6 (hold until released)
    'REL_q7': (0, 2),  # operator: release section q7 (hold until released)
    'REL_q8': (0, 2),  # operator: release section q8 (hold until released)
    'REL_q9': (0, 2),  # operator: release section q9 (hold until released)
    'BLK_q1': (1, 2),  # operator: section q1 is blocked
    'BLK_q10': (1, 2),  # operator: section q10 is blocked
    'BLK_q11': (1, 2),  # operator: section q11 is blocked
    'BLK_q2': (1, 2),  # operator: section q2 is blocked
    'BLK_q3': (1, 2),  # operator: section q3 is blocked
    'BLK_q4': (1, 2),  # operator: section q4 is blocked
    'BLK_q5': (1, 2),  # operator: section q5 is blocked
    'BLK_q6': (1, 2),  # operator: section q6 is blocked
    'BLK_q7': (1, 2),  # operator: section q7 is blocked
    'BLK_q8': (1, 2),  # operator: section q8 is blocked
    'BLK_q9': (1, 2),  # operator: section q9 is blocked
    'RELALL': (0, 2),  # operator: release all clear sections after a restart
    'DN_P1': (0, 2),  # machine P1 detected normal
    'DR_P1': (0, 2),  # machine P1 detected reverse
    'MN_P1': (0, 2),  # operator: move machine P1 normal
    'MR_P1': (0, 2),  # operator: move machine P1 reverse
    'TC_P1': (0, 2),  # operator: machine P1 has been looked at after it was trailed
    'DN_P2': (0, 2),  # machine P2 detected normal
    'DR_P2': (0, 2),  # machine P2 detected reverse
    'MN_P2': (0, 2),  # operator: move machine P2 normal
    'MR_P2': (0, 2),  # operator: move machine P2 reverse
    'TC_P2': (0, 2),  # operator: machine P2 has been looked at after it was trailed
}
# name: value at a restart, meaning
STATE = {
    'CN_P1': False,  # machine P1 commanded N
    'CR_P1': False,  # machine P1 commanded R
    'CN_P2': False,  # machine P2 commanded N
    'CR_P2': False,  # machine P2 commanded R
    'AL_P1': False,  # alarm: machine P1 not detected
    'AL_P2': False,  # alarm: machine P2 not detected
    'TH_P1': False,  # machine P1 was detected where it is commanded
    'TR_P1': False,  # machine P1 was trailed
    'TH_P2': False,  # machine P2 was detected where it is commanded
    'TR_P2': False,  # machine P2 was trailed
    'A_R1': False,  # route X1-X3 active
    'B_R1': False,  # route X1-X3 locked
    'W_R1': False,  # route X1-X3: proceed wanted
    'S_R1': False,  # route X1-X3: proceed
    'H_R1': False,  # route X1-X3: signal has been open
    'A_R2': False,  # route X1-X5 active
    'B_R2': False,  # route X1-X5 locked
    'W_R2': False,  # route X1-X5: proceed wanted
    'S_R2': False,  # route X1-X5: proceed
    'H_R2': False,  # route X1-X5: signal has been open
    'A_R3': False,  # route X2-W active
    'B_R3': False,  # route X2-W locked
    'W_R3': False,  # route X2-W: proceed wanted
    'S_R3': False,  # route X2-W: proceed
    'H_R3': False,  # route X2-W: signal has been open
    'A_R4': False,  # route X3-E active
    'B_R4': False,  # route X3-E locked
    'W_R4': False,  # route X3-E: proceed wanted
    'S_R4': False,  # route X3-E: proceed
    'H_R4': False,  # route X3-E: signal has been open
    'A_R5': False,  # route X4-X2 active
    'B_R5': False,  # route X4-X2 locked
    'W_R5': False,  # route X4-X2: proceed wanted
    'S_R5': False,  # route X4-X2: proceed
    'H_R5': False,  # route X4-X2: signal has been open
    'A_R6': False,  # route X4-X6 active
    'B_R6': False,  # route X4-X6 locked
    'W_R6': False,  # route X4-X6: proceed wanted
    'S_R6': False,  # route X4-X6: proceed
    'H_R6': False,  # route X4-X6: signal has been open
    'A_R7': False,  # route X5-E active
    'B_R7': False,  # route X5-E locked
    'W_R7': False,  # route X5-E: proceed wanted
    'S_R7': False,  # route X5-E: proceed
    'H_R7': False,  # route X5-E: signal has been open
    'A_R8': False,  # route X6-W active
    'B_R8': False,  # route X6-W locked
    'W_R8': False,  # route X6-W: proceed wanted
    'S_R8': False,  # route X6-W: proceed
    'H_R8': False,  # route X6-W: signal has been open
    'A_R9': False,  # route X7-X1 active
    'B_R9': False,  # route X7-X1 locked
    'W_R9': False,  # route X7-X1: proceed wanted
    'S_R9': False,  # route X7-X1: proceed
    'H_R9': False,  # route X7-X1: signal has been open
    'X_X1': False,  # X1: cancelling
    'X_X2': False,  # X2: cancelling
    'X_X3': False,  # X3: cancelling
    'X_X4': False,  # X4: cancelling
    'X_X5': False,  # X5: cancelling
    'X_X6': False,  # X6: cancelling
    'X_X7': False,  # X7: cancelling
    'N_R2': False,  # route X1-X5 is noted
    'T_R2': True,  # it is the turn of route X1-X5
    'N_R3': False,  # route X2-W is noted
    'T_R3': False,  # it is the turn of route X2-W
    'N_R5': False,  # route X4-X2 is noted
    'T_R5': False,  # it is the turn of route X4-X2
    'N_R7': False,  # route X5-E is noted
    'T_R7': False,  # it is the turn of route X5-E
    'N_R9': False,  # route X7-X1 is noted
    'T_R9': False,  # it is the turn of route X7-X1
    'K_q1': True,  # q1: restart lock (R16)
    'L_q1_1': False,  # q1 locked from W to q1|q2@P1.toe
    'L_q1_2': False,  # q1 locked from q1|q2@P1.toe to W
    'F_q1': False,  # q1 firmly locked
    'U_q1': True,  # q1 used by a train (R9)
    'P_q1': False,  # q1: the train went on (R9)
    'D_q1': False,  # q1: detection is not relied on, inputs were lost or a train is called on
    'K_q10': True,  # q10: restart lock (R16)
    'L_q10_1': False,  # q10 locked from q10|q11@P2.reverse to q10|q8@even.2
    'L_q10_2': False,  # q10 locked from q10|q8@even.2 to q10|q11@P2.reverse
    'F_q10': False,  # q10 firmly locked
    'U_q10': True,  # q10 used by a train (R9)
    'P_q10': False,  # q10: the train went on (R9)
    'D_q10': False,  # q10: detection is not relied on, inputs were lost or a train is called on
    'K_q11': True,  # q11: restart lock (R16)
    'L_q11_1': False,  # q11 locked from E to q10|q11@P2.reverse
    'L_q11_2': False,  # q11 locked from E to q11|q9@P2.normal
    'L_q11_3': False,  # q11 locked from q10|q11@P2.reverse to E
    'L_q11_4': False,  # q11 locked from q11|q9@P2.normal to E
    'F_q11': False,  # q11 firmly locked
    'U_q11': True,  # q11 used by a train (R9)
    'P_q11': False,  # q11: the train went on (R9)
    'D_q11': False,  # q11: detection is not relied on, inputs were lost or a train is called on
    'K_q2': True,  # q2: restart lock (R16)
    'L_q2_1': False,  # q2 locked from q1|q2@P1.toe to q2|q3@P1.normal
    'L_q2_2': False,  # q2 locked from q1|q2@P1.toe to q2|q4@P1.reverse
    'L_q2_3': False,  # q2 locked from q2|q3@P1.normal to q1|q2@P1.toe
    'L_q2_4': False,  # q2 locked from q2|q4@P1.reverse to q1|q2@P1.toe
    'F_q2': False,  # q2 firmly locked
    'U_q2': True,  # q2 used by a train (R9)
    'P_q2': False,  # q2: the train went on (R9)
    'D_q2': False,  # q2: detection is not relied on, inputs were lost or a train is called on
    'K_q3': True,  # q3: restart lock (R16)
    'L_q3_1': False,  # q3 locked from q2|q3@P1.normal to q3|q5@odd.0
    'L_q3_2': False,  # q3 locked from q3|q5@odd.0 to q2|q3@P1.normal
    'F_q3': False,  # q3 firmly locked
    'U_q3': True,  # q3 used by a train (R9)
    'P_q3': False,  # q3: the train went on (R9)
    'D_q3': False,  # q3: detection is not relied on, inputs were lost or a train is called on
    'K_q4': True,  # q4: restart lock (R16)
    'L_q4_1': False,  # q4 locked from q2|q4@P1.reverse to q4|q6@even.0
    'L_q4_2': False,  # q4 locked from q4|q6@even.0 to q2|q4@P1.reverse
    'F_q4': False,  # q4 firmly locked
    'U_q4': True,  # q4 used by a train (R9)
    'P_q4': False,  # q4: the train went on (R9)
    'D_q4': False,  # q4: detection is not relied on, inputs were lost or a train is called on
    'K_q5': True,  # q5: restart lock (R16)
    'L_q5_1': False,  # q5 locked from q3|q5@odd.0 to q5|q7@odd.1
    'L_q5_2': False,  # q5 locked from q5|q7@odd.1 to q3|q5@odd.0
    'F_q5': False,  # q5 firmly locked
    'U_q5': True,  # q5 used by a train (R9)
    'P_q5': False,  # q5: the train went on (R9)
    'D_q5': False,  # q5: detection is not relied on, inputs were lost or a train is called on
    'K_q6': True,  # q6: restart lock (R16)
    'L_q6_1': False,  # q6 locked from q4|q6@even.0 to q6|q8@even.1
    'L_q6_2': False,  # q6 locked from q6|q8@even.1 to q4|q6@even.0
    'F_q6': False,  # q6 firmly locked
    'U_q6': True,  # q6 used by a train (R9)
    'P_q6': False,  # q6: the train went on (R9)
    'D_q6': False,  # q6: detection is not relied on, inputs were lost or a train is called on
    'K_q7': True,  # q7: restart lock (R16)
    'L_q7_1': False,  # q7 locked from q5|q7@odd.1 to q7|q9@odd.2
    'L_q7_2': False,  # q7 locked from q7|q9@odd.2 to q5|q7@odd.1
    'F_q7': False,  # q7 firmly locked
    'U_q7': True,  # q7 used by a train (R9)
    'P_q7': False,  # q7: the train went on (R9)
    'D_q7': False,  # q7: detection is not relied on, inputs were lost or a train is called on
    'K_q8': True,  # q8: restart lock (R16)
    'L_q8_1': False,  # q8 locked from q10|q8@even.2 to q6|q8@even.1
    'L_q8_2': False,  # q8 locked from q6|q8@even.1 to q10|q8@even.2
    'F_q8': False,  # q8 firmly locked
    'U_q8': True,  # q8 used by a train (R9)
    'P_q8': False,  # q8: the train went on (R9)
    'D_q8': False,  # q8: detection is not relied on, inputs were lost or a train is called on
    'K_q9': True,  # q9: restart lock (R16)
    'L_q9_1': False,  # q9 locked from q11|q9@P2.normal to q7|q9@odd.2
    'L_q9_2': False,  # q9 locked from q7|q9@odd.2 to q11|q9@P2.normal
    'F_q9': False,  # q9 firmly locked
    'U_q9': True,  # q9 used by a train (R9)
    'P_q9': False,  # q9: the train went on (R9)
    'D_q9': False,  # q9: detection is not relied on, inputs were lost or a train is called on
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_X1': 60000,  # X1: approach locking delay (R8)
    'AT_X2': 60000,  # X2: approach locking delay (R8)
    'AT_X3': 60000,  # X3: approach locking delay (R8)
    'AT_X4': 60000,  # X4: approach locking delay (R8)
    'AT_X5': 60000,  # X5: approach locking delay (R8)
    'AT_X6': 60000,  # X6: approach locking delay (R8)
    'AT_X7': 60000,  # X7: approach locking delay (R8)
    'RT_q1': 3000,  # q1: release delay (R9)
    'RT_q10': 3000,  # q10: release delay (R9)
    'RT_q11': 3000,  # q11: release delay (R9)
    'RT_q2': 3000,  # q2: release delay (R9)
    'RT_q3': 3000,  # q3: release delay (R9)
    'RT_q4': 3000,  # q4: release delay (R9)
    'RT_q5': 3000,  # q5: release delay (R9)
    'RT_q6': 3000,  # q6: release delay (R9)
    'RT_q7': 3000,  # q7: release delay (R9)
    'RT_q8': 3000,  # q8: release delay (R9)
    'RT_q9': 3000,  # q9: release delay (R9)
    'ST_P1': 13000,  # machine P1: time-out
    'ST_P2': 13000,  # machine P2: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_P1': False,  # machine P1: normal
    'YR_P1': False,  # machine P1: reverse
    'YN_P2': False,  # machine P2: normal
    'YR_P2': False,  # machine P2: reverse
    'YA_P1': False,  # alarm: machine P1 not detected in time
    'YA_P2': False,  # alarm: machine P2 not detected in time
    'YT_P1': False,  # alarm: machine P1 was trailed
    'YT_P2': False,  # alarm: machine P2 was trailed
    'YL_q1': True,  # indication: q1 is locked
    'YL_q10': True,  # indication: q10 is locked
    'YL_q11': True,  # indication: q11 is locked
    'YL_q2': True,  # indication: q2 is locked
    'YL_q3': True,  # indication: q3 is locked
    'YL_q4': True,  # indication: q4 is locked
    'YL_q5': True,  # indication: q5 is locked
    'YL_q6': True,  # indication: q6 is locked
    'YL_q7': True,  # indication: q7 is locked
    'YL_q8': True,  # indication: q8 is locked
    'YL_q9': True,  # indication: q9 is locked
    'YP_X1': False,  # signal X1: clear (green)
    'YS_X1': True,  # signal X1: stop
    'YP_X2': False,  # signal X2: clear (green)
    'YS_X2': True,  # signal X2: stop
    'YP_X3': False,  # signal X3: clear (green)
    'YS_X3': True,  # signal X3: stop
    'YP_X4': False,  # signal X4: clear (green)
    'YS_X4': True,  # signal X4: stop
    'YP_X5': False,  # signal X5: clear (green)
    'YS_X5': True,  # signal X5: stop
    'YP_X6': False,  # signal X6: clear (green)
    'YS_X6': True,  # signal X6: stop
    'YP_X7': False,  # signal X7: clear (green)
    'YS_X7': True,  # signal X7: stop
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
        CAN_X4 = read['CAN_X4']
        CAN_X5 = read['CAN_X5']
        CAN_X6 = read['CAN_X6']
        CAN_X7 = read['CAN_X7']
        REQ = read['REQ']
        LREQ = read['LREQ']
        VOY = read['VOY']
        CLR_ap_E = read['CLR_ap_E']
        CLR_ap_W = read['CLR_ap_W']
        CLR_q1 = read['CLR_q1']
        CLR_q10 = read['CLR_q10']
        CLR_q11 = read['CLR_q11']
        CLR_q2 = read['CLR_q2']
        CLR_q3 = read['CLR_q3']
        CLR_q4 = read['CLR_q4']
        CLR_q5 = read['CLR_q5']
        CLR_q6 = read['CLR_q6']
        CLR_q7 = read['CLR_q7']
        CLR_q8 = read['CLR_q8']
        CLR_q9 = read['CLR_q9']
        REL_q1 = read['REL_q1']
        REL_q10 = read['REL_q10']
        REL_q11 = read['REL_q11']
        REL_q2 = read['REL_q2']
        REL_q3 = read['REL_q3']
        REL_q4 = read['REL_q4']
        REL_q5 = read['REL_q5']
        REL_q6 = read['REL_q6']
        REL_q7 = read['REL_q7']
        REL_q8 = read['REL_q8']
        REL_q9 = read['REL_q9']
        BLK_q1 = read['BLK_q1']
        BLK_q10 = read['BLK_q10']
        BLK_q11 = read['BLK_q11']
        BLK_q2 = read['BLK_q2']
        BLK_q3 = read['BLK_q3']
        BLK_q4 = read['BLK_q4']
        BLK_q5 = read['BLK_q5']
        BLK_q6 = read['BLK_q6']
        BLK_q7 = read['BLK_q7']
        BLK_q8 = read['BLK_q8']
        BLK_q9 = read['BLK_q9']
        RELALL = read['RELALL']
        DN_P1 = read['DN_P1']
        DR_P1 = read['DR_P1']
        MN_P1 = read['MN_P1']
        MR_P1 = read['MR_P1']
        TC_P1 = read['TC_P1']
        DN_P2 = read['DN_P2']
        DR_P2 = read['DR_P2']
        MN_P2 = read['MN_P2']
        MR_P2 = read['MR_P2']
        TC_P2 = read['TC_P2']
        CN_P1 = old['CN_P1']
        CR_P1 = old['CR_P1']
        CN_P2 = old['CN_P2']
        CR_P2 = old['CR_P2']
        AL_P1 = old['AL_P1']
        AL_P2 = old['AL_P2']
        TH_P1 = old['TH_P1']
        TR_P1 = old['TR_P1']
        TH_P2 = old['TH_P2']
        TR_P2 = old['TR_P2']
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
        X_X1 = old['X_X1']
        X_X2 = old['X_X2']
        X_X3 = old['X_X3']
        X_X4 = old['X_X4']
        X_X5 = old['X_X5']
        X_X6 = old['X_X6']
        X_X7 = old['X_X7']
        N_R2 = old['N_R2']
        T_R2 = old['T_R2']
        N_R3 = old['N_R3']
        T_R3 = old['T_R3']
        N_R5 = old['N_R5']
        T_R5 = old['T_R5']
        N_R7 = old['N_R7']
        T_R7 = old['T_R7']
        N_R9 = old['N_R9']
        T_R9 = old['T_R9']
        K_q1 = old['K_q1']
        L_q1_1 = old['L_q1_1']
        L_q1_2 = old['L_q1_2']
        F_q1 = old['F_q1']
        U_q1 = old['U_q1']
        P_q1 = old['P_q1']
        D_q1 = old['D_q1']
        K_q10 = old['K_q10']
        L_q10_1 = old['L_q10_1']
        L_q10_2 = old['L_q10_2']
        F_q10 = old['F_q10']
        U_q10 = old['U_q10']
        P_q10 = old['P_q10']
        D_q10 = old['D_q10']
        K_q11 = old['K_q11']
        L_q11_1 = old['L_q11_1']
        L_q11_2 = old['L_q11_2']
        L_q11_3 = old['L_q11_3']
        L_q11_4 = old['L_q11_4']
        F_q11 = old['F_q11']
        U_q11 = old['U_q11']
        P_q11 = old['P_q11']
        D_q11 = old['D_q11']
        K_q2 = old['K_q2']
        L_q2_1 = old['L_q2_1']
        L_q2_2 = old['L_q2_2']
        L_q2_3 = old['L_q2_3']
        L_q2_4 = old['L_q2_4']
        F_q2 = old['F_q2']
        U_q2 = old['U_q2']
        P_q2 = old['P_q2']
        D_q2 = old['D_q2']
        K_q3 = old['K_q3']
        L_q3_1 = old['L_q3_1']
        L_q3_2 = old['L_q3_2']
        F_q3 = old['F_q3']
        U_q3 = old['U_q3']
        P_q3 = old['P_q3']
        D_q3 = old['D_q3']
        K_q4 = old['K_q4']
        L_q4_1 = old['L_q4_1']
        L_q4_2 = old['L_q4_2']
        F_q4 = old['F_q4']
        U_q4 = old['U_q4']
        P_q4 = old['P_q4']
        D_q4 = old['D_q4']
        K_q5 = old['K_q5']
        L_q5_1 = old['L_q5_1']
        L_q5_2 = old['L_q5_2']
        F_q5 = old['F_q5']
        U_q5 = old['U_q5']
        P_q5 = old['P_q5']
        D_q5 = old['D_q5']
        K_q6 = old['K_q6']
        L_q6_1 = old['L_q6_1']
        L_q6_2 = old['L_q6_2']
        F_q6 = old['F_q6']
        U_q6 = old['U_q6']
        P_q6 = old['P_q6']
        D_q6 = old['D_q6']
        K_q7 = old['K_q7']
        L_q7_1 = old['L_q7_1']
        L_q7_2 = old['L_q7_2']
        F_q7 = old['F_q7']
        U_q7 = old['U_q7']
        P_q7 = old['P_q7']
        D_q7 = old['D_q7']
        K_q8 = old['K_q8']
        L_q8_1 = old['L_q8_1']
        L_q8_2 = old['L_q8_2']
        F_q8 = old['F_q8']
        U_q8 = old['U_q8']
        P_q8 = old['P_q8']
        D_q8 = old['D_q8']
        K_q9 = old['K_q9']
        L_q9_1 = old['L_q9_1']
        L_q9_2 = old['L_q9_2']
        F_q9 = old['F_q9']
        U_q9 = old['U_q9']
        P_q9 = old['P_q9']
        D_q9 = old['D_q9']
        OCC_ap_E = (not CLR_ap_E) or (not VALID)  # ap_E counts as occupied
        OCC_ap_W = (not CLR_ap_W) or (not VALID)  # ap_W counts as occupied
        OCC_q1 = (not CLR_q1) or (not VALID)  # q1 counts as occupied
        OCC_q10 = (not CLR_q10) or (not VALID)  # q10 counts as occupied
        OCC_q11 = (not CLR_q11) or (not VALID)  # q11 counts as occupied
        OCC_q2 = (not CLR_q2) or (not VALID)  # q2 counts as occupied
        OCC_q3 = (not CLR_q3) or (not VALID)  # q3 counts as occupied
        OCC_q4 = (not CLR_q4) or (not VALID)  # q4 counts as occupied
        OCC_q5 = (not CLR_q5) or (not VALID)  # q5 counts as occupied
        OCC_q6 = (not CLR_q6) or (not VALID)  # q6 counts as occupied
        OCC_q7 = (not CLR_q7) or (not VALID)  # q7 counts as occupied
        OCC_q8 = (not CLR_q8) or (not VALID)  # q8 counts as occupied
        OCC_q9 = (not CLR_q9) or (not VALID)  # q9 counts as occupied
        FREE_q1 = (not K_q1) and (not L_q1_1) and (not L_q1_2)  # q1 is not locked by anybody
        FREE_q10 = (not K_q10) and (not L_q10_1) and (not L_q10_2)  # q10 is not locked by anybody
        FREE_q11 = (not K_q11) and (not L_q11_1) and (not L_q11_2) and (not L_q11_3) and (not L_q11_4)  # q11 is not locked by anybody
        FREE_q2 = (not K_q2) and (not L_q2_1) and (not L_q2_2) and (not L_q2_3) and (not L_q2_4)  # q2 is not locked by anybody
        FREE_q3 = (not K_q3) and (not L_q3_1) and (not L_q3_2)  # q3 is not locked by anybody
        FREE_q4 = (not K_q4) and (not L_q4_1) and (not L_q4_2)  # q4 is not locked by anybody
        FREE_q5 = (not K_q5) and (not L_q5_1) and (not L_q5_2)  # q5 is not locked by anybody
        FREE_q6 = (not K_q6) and (not L_q6_1) and (not L_q6_2)  # q6 is not locked by anybody
        FREE_q7 = (not K_q7) and (not L_q7_1) and (not L_q7_2)  # q7 is not locked by anybody
        FREE_q8 = (not K_q8) and (not L_q8_1) and (not L_q8_2)  # q8 is not locked by anybody
        FREE_q9 = (not K_q9) and (not L_q9_1) and (not L_q9_2)  # q9 is not locked by anybody
        QN_P1 = VALID and DN_P1 and (not DR_P1)  # machine P1 lies N (R10)
        QR_P1 = VALID and DR_P1 and (not DN_P1)  # machine P1 lies R (R10)
        QN_P2 = VALID and DN_P2 and (not DR_P2)  # machine P2 lies N (R10)
        QR_P2 = VALID and DR_P2 and (not DN_P2)  # machine P2 lies R (R10)
        MOV_P1 = VALID and FREE_q2 and (not OCC_q2) and True and True  # machine P1 is free to move (R10)
        AVN_P1 = CN_P1 or MOV_P1 or (QN_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded N
        AVR_P1 = CR_P1 or MOV_P1 or (QR_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded R
        MOV_P2 = VALID and FREE_q11 and (not OCC_q11) and True and True  # machine P2 is free to move (R10)
        AVN_P2 = CN_P2 or MOV_P2 or (QN_P2 and (not CN_P2) and (not CR_P2))  # machine P2 can be demanded N
        AVR_P2 = CR_P2 or MOV_P2 or (QR_P2 and (not CN_P2) and (not CR_P2))  # machine P2 can be demanded R
        WF_q1_1 = FREE_q1 and (not OCC_q1) and (not BLK_q1)  # q1 from W to q1|q2@P1.toe: free for a route (R6)
        WF_q1_2 = FREE_q1 and (not OCC_q1) and (not BLK_q1)  # q1 from q1|q2@P1.toe to W: free for a route (R6)
        WF_q10_1 = FREE_q10 and (not OCC_q10) and (not BLK_q10)  # q10 from q10|q11@P2.reverse to q10|q8@even.2: free for a route (R6)
        WF_q10_2 = FREE_q10 and (not OCC_q10) and (not BLK_q10)  # q10 from q10|q8@even.2 to q10|q11@P2.reverse: free for a route (R6)
        WA_q11_1 = AVR_P2 and (not TR_P2)  # q11 from E to q10|q11@P2.reverse: could be locked
        WF_q11_1 = FREE_q11 and (not OCC_q11) and (not BLK_q11) and WA_q11_1  # q11 from E to q10|q11@P2.reverse: free for a route (R6)
        WA_q11_2 = AVN_P2 and (not TR_P2)  # q11 from E to q11|q9@P2.normal: could be locked
        WF_q11_2 = FREE_q11 and (not OCC_q11) and (not BLK_q11) and WA_q11_2  # q11 from E to q11|q9@P2.normal: free for a route (R6)
        WA_q11_3 = AVR_P2 and (not TR_P2)  # q11 from q10|q11@P2.reverse to E: could be locked
        WF_q11_3 = FREE_q11 and (not OCC_q11) and (not BLK_q11) and WA_q11_3  # q11 from q10|q11@P2.reverse to E: free for a route (R6)
        WA_q11_4 = AVN_P2 and (not TR_P2)  # q11 from q11|q9@P2.normal to E: could be locked
        WF_q11_4 = FREE_q11 and (not OCC_q11) and (not BLK_q11) and WA_q11_4  # q11 from q11|q9@P2.normal to E: free for a route (R6)
        WA_q2_1 = AVN_P1 and (not TR_P1)  # q2 from q1|q2@P1.toe to q2|q3@P1.normal: could be locked
        WF_q2_1 = FREE_q2 and (not OCC_q2) and (not BLK_q2) and WA_q2_1  # q2 from q1|q2@P1.toe to q2|q3@P1.normal: free for a route (R6)
        WA_q2_2 = AVR_P1 and (not TR_P1)  # q2 from q1|q2@P1.toe to q2|q4@P1.reverse: could be locked
        WF_q2_2 = FREE_q2 and (not OCC_q2) and (not BLK_q2) and WA_q2_2  # q2 from q1|q2@P1.toe to q2|q4@P1.reverse: free for a route (R6)
        WA_q2_3 = AVN_P1 and (not TR_P1)  # q2 from q2|q3@P1.normal to q1|q2@P1.toe: could be locked
        WF_q2_3 = FREE_q2 and (not OCC_q2) and (not BLK_q2) and WA_q2_3  # q2 from q2|q3@P1.normal to q1|q2@P1.toe: free for a route (R6)
        WA_q2_4 = AVR_P1 and (not TR_P1)  # q2 from q2|q4@P1.reverse to q1|q2@P1.toe: could be locked
        WF_q2_4 = FREE_q2 and (not OCC_q2) and (not BLK_q2) and WA_q2_4  # q2 from q2|q4@P1.reverse to q1|q2@P1.toe: free for a route (R6)
        WF_q3_1 = FREE_q3 and (not OCC_q3) and (not BLK_q3)  # q3 from q2|q3@P1.normal to q3|q5@odd.0: free for a route (R6)
        WF_q3_2 = FREE_q3 and (not OCC_q3) and (not BLK_q3)  # q3 from q3|q5@odd.0 to q2|q3@P1.normal: free for a route (R6)
        WF_q4_1 = FREE_q4 and (not OCC_q4) and (not BLK_q4)  # q4 from q2|q4@P1.reverse to q4|q6@even.0: free for a route (R6)
        WF_q4_2 = FREE_q4 and (not OCC_q4) and (not BLK_q4)  # q4 from q4|q6@even.0 to q2|q4@P1.reverse: free for a route (R6)
        WF_q5_1 = FREE_q5 and (not OCC_q5) and (not BLK_q5)  # q5 from q3|q5@odd.0 to q5|q7@odd.1: free for a route (R6)
        WF_q5_2 = FREE_q5 and (not OCC_q5) and (not BLK_q5)  # q5 from q5|q7@odd.1 to q3|q5@odd.0: free for a route (R6)
        WF_q6_1 = FREE_q6 and (not OCC_q6) and (not BLK_q6)  # q6 from q4|q6@even.0 to q6|q8@even.1: free for a route (R6)
        WF_q6_2 = FREE_q6 and (not OCC_q6) and (not BLK_q6)  # q6 from q6|q8@even.1 to q4|q6@even.0: free for a route (R6)
        WF_q7_1 = FREE_q7 and (not OCC_q7) and (not BLK_q7)  # q7 from q5|q7@odd.1 to q7|q9@odd.2: free for a route (R6)
        WF_q7_2 = FREE_q7 and (not OCC_q7) and (not BLK_q7)  # q7 from q7|q9@odd.2 to q5|q7@odd.1: free for a route (R6)
        WF_q8_1 = FREE_q8 and (not OCC_q8) and (not BLK_q8)  # q8 from q10|q8@even.2 to q6|q8@even.1: free for a route (R6)
        WF_q8_2 = FREE_q8 and (not OCC_q8) and (not BLK_q8)  # q8 from q6|q8@even.1 to q10|q8@even.2: free for a route (R6)
        WF_q9_1 = FREE_q9 and (not OCC_q9) and (not BLK_q9)  # q9 from q11|q9@P2.normal to q7|q9@odd.2: free for a route (R6)
        WF_q9_2 = FREE_q9 and (not OCC_q9) and (not BLK_q9)  # q9 from q7|q9@odd.2 to q11|q9@P2.normal: free for a route (R6)
        WL_q1_1 = (not OCC_q1)  # q1 from W to q1|q2@P1.toe: lies and is clear
        WP_q1_1 = WL_q1_1 and (not BLK_q1)  # q1 from W to q1|q2@P1.toe: proceed may be shown over it (R3)
        WL_q1_2 = (not OCC_q1)  # q1 from q1|q2@P1.toe to W: lies and is clear
        WP_q1_2 = WL_q1_2 and (not BLK_q1)  # q1 from q1|q2@P1.toe to W: proceed may be shown over it (R3)
        WL_q10_1 = (not OCC_q10)  # q10 from q10|q11@P2.reverse to q10|q8@even.2: lies and is clear
        WP_q10_1 = WL_q10_1 and (not BLK_q10)  # q10 from q10|q11@P2.reverse to q10|q8@even.2: proceed may be shown over it (R3)
        WL_q10_2 = (not OCC_q10)  # q10 from q10|q8@even.2 to q10|q11@P2.reverse: lies and is clear
        WP_q10_2 = WL_q10_2 and (not BLK_q10)  # q10 from q10|q8@even.2 to q10|q11@P2.reverse: proceed may be shown over it (R3)
        WD_q11_1 = QR_P2 and (not TR_P2)  # q11 from E to q10|q11@P2.reverse: its points lie, nothing is foul of it
        WL_q11_1 = (not OCC_q11) and WD_q11_1  # q11 from E to q10|q11@P2.reverse: lies and is clear
        WP_q11_1 = WL_q11_1 and (not BLK_q11)  # q11 from E to q10|q11@P2.reverse: proceed may be shown over it (R3)
        WD_q11_2 = QN_P2 and (not TR_P2)  # q11 from E to q11|q9@P2.normal: its points lie, nothing is foul of it
        WL_q11_2 = (not OCC_q11) and WD_q11_2  # q11 from E to q11|q9@P2.normal: lies and is clear
        WP_q11_2 = WL_q11_2 and (not BLK_q11)  # q11 from E to q11|q9@P2.normal: proceed may be shown over it (R3)
        WD_q11_3 = QR_P2 and (not TR_P2)  # q11 from q10|q11@P2.reverse to E: its points lie, nothing is foul of it
        WL_q11_3 = (not OCC_q11) and WD_q11_3  # q11 from q10|q11@P2.reverse to E: lies and is clear
        WP_q11_3 = WL_q11_3 and (not BLK_q11)  # q11 from q10|q11@P2.reverse to E: proceed may be shown over it (R3)
        WD_q11_4 = QN_P2 and (not TR_P2)  # q11 from q11|q9@P2.normal to E: its points lie, nothing is foul of it
        WL_q11_4 = (not OCC_q11) and WD_q11_4  # q11 from q11|q9@P2.normal to E: lies and is clear
        WP_q11_4 = WL_q11_4 and (not BLK_q11)  # q11 from q11|q9@P2.normal to E: proceed may be shown over it (R3)
        WD_q2_1 = QN_P1 and (not TR_P1)  # q2 from q1|q2@P1.toe to q2|q3@P1.normal: its points lie, nothing is foul of it
        WL_q2_1 = (not OCC_q2) and WD_q2_1  # q2 from q1|q2@P1.toe to q2|q3@P1.normal: lies and is clear
        WP_q2_1 = WL_q2_1 and (not BLK_q2)  # q2 from q1|q2@P1.toe to q2|q3@P1.normal: proceed may be shown over it (R3)
        WD_q2_2 = QR_P1 and (not TR_P1)  # q2 from q1|q2@P1.toe to q2|q4@P1.reverse: its points lie, nothing is foul of it
        WL_q2_2 = (not OCC_q2) and WD_q2_2  # q2 from q1|q2@P1.toe to q2|q4@P1.reverse: lies and is clear
        WP_q2_2 = WL_q2_2 and (not BLK_q2)  # q2 from q1|q2@P1.toe to q2|q4@P1.reverse: proceed may be shown over it (R3)
        WD_q2_3 = QN_P1 and (not TR_P1)  # q2 from q2|q3@P1.normal to q1|q2@P1.toe: its points lie, nothing is foul of it
        WL_q2_3 = (not OCC_q2) and WD_q2_3  # q2 from q2|q3@P1.normal to q1|q2@P1.toe: lies and is clear
        WP_q2_3 = WL_q2_3 and (not BLK_q2)  # q2 from q2|q3@P1.normal to q1|q2@P1.toe: proceed may be shown over it (R3)
        WD_q2_4 = QR_P1 and (not TR_P1)  # q2 from q2|q4@P1.reverse to q1|q2@P1.toe: its points lie, nothing is foul of it
        WL_q2_4 = (not OCC_q2) and WD_q2_4  # q2 from q2|q4@P1.reverse to q1|q2@P1.toe: lies and is clear
        WP_q2_4 = WL_q2_4 and (not BLK_q2)  # q2 from q2|q4@P1.reverse to q1|q2@P1.toe: proceed may be shown over it (R3)
        WL_q3_1 = (not OCC_q3)  # q3 from q2|q3@P1.normal to q3|q5@odd.0: lies and is clear
        WP_q3_1 = WL_q3_1 and (not BLK_q3)  # q3 from q2|q3@P1.normal to q3|q5@odd.0: proceed may be shown over it (R3)
        WL_q3_2 = (not OCC_q3)  # q3 from q3|q5@odd.0 to q2|q3@P1.normal: lies and is clear
        WP_q3_2 = WL_q3_2 and (not BLK_q3)  # q3 from q3|q5@odd.0 to q2|q3@P1.normal: proceed may be shown over it (R3)
        WL_q4_1 = (not OCC_q4)  # q4 from q2|q4@P1.reverse to q4|q6@even.0: lies and is clear
        WP_q4_1 = WL_q4_1 and (not BLK_q4)  # q4 from q2|q4@P1.reverse to q4|q6@even.0: proceed may be shown over it (R3)
        WL_q4_2 = (not OCC_q4)  # q4 from q4|q6@even.0 to q2|q4@P1.reverse: lies and is clear
        WP_q4_2 = WL_q4_2 and (not BLK_q4)  # q4 from q4|q6@even.0 to q2|q4@P1.reverse: proceed may be shown over it (R3)
        WL_q5_1 = (not OCC_q5)  # q5 from q3|q5@odd.0 to q5|q7@odd.1: lies and is clear
        WP_q5_1 = WL_q5_1 and (not BLK_q5)  # q5 from q3|q5@odd.0 to q5|q7@odd.1: proceed may be shown over it (R3)
        WL_q5_2 = (not OCC_q5)  # q5 from q5|q7@odd.1 to q3|q5@odd.0: lies and is clear
        WP_q5_2 = WL_q5_2 and (not BLK_q5)  # q5 from q5|q7@odd.1 to q3|q5@odd.0: proceed may be shown over it (R3)
        WL_q6_1 = (not OCC_q6)  # q6 from q4|q6@even.0 to q6|q8@even.1: lies and is clear
        WP_q6_1 = WL_q6_1 and (not BLK_q6)  # q6 from q4|q6@even.0 to q6|q8@even.1: proceed may be shown over it (R3)
        WL_q6_2 = (not OCC_q6)  # q6 from q6|q8@even.1 to q4|q6@even.0: lies and is clear
        WP_q6_2 = WL_q6_2 and (not BLK_q6)  # q6 from q6|q8@even.1 to q4|q6@even.0: proceed may be shown over it (R3)
        WL_q7_1 = (not OCC_q7)  # q7 from q5|q7@odd.1 to q7|q9@odd.2: lies and is clear
        WP_q7_1 = WL_q7_1 and (not BLK_q7)  # q7 from q5|q7@odd.1 to q7|q9@odd.2: proceed may be shown over it (R3)
        WL_q7_2 = (not OCC_q7)  # q7 from q7|q9@odd.2 to q5|q7@odd.1: lies and is clear
        WP_q7_2 = WL_q7_2 and (not BLK_q7)  # q7 from q7|q9@odd.2 to q5|q7@odd.1: proceed may be shown over it (R3)
        WL_q8_1 = (not OCC_q8)  # q8 from q10|q8@even.2 to q6|q8@even.1: lies and is clear
        WP_q8_1 = WL_q8_1 and (not BLK_q8)  # q8 from q10|q8@even.2 to q6|q8@even.1: proceed may be shown over it (R3)
        WL_q8_2 = (not OCC_q8)  # q8 from q6|q8@even.1 to q10|q8@even.2: lies and is clear
        WP_q8_2 = WL_q8_2 and (not BLK_q8)  # q8 from q6|q8@even.1 to q10|q8@even.2: proceed may be shown over it (R3)
        WL_q9_1 = (not OCC_q9)  # q9 from q11|q9@P2.normal to q7|q9@odd.2: lies and is clear
        WP_q9_1 = WL_q9_1 and (not BLK_q9)  # q9 from q11|q9@P2.normal to q7|q9@odd.2: proceed may be shown over it (R3)
        WL_q9_2 = (not OCC_q9)  # q9 from q7|q9@odd.2 to q11|q9@P2.normal: lies and is clear
        WP_q9_2 = WL_q9_2 and (not BLK_q9)  # q9 from q7|q9@odd.2 to q11|q9@P2.normal: proceed may be shown over it (R3)
        AD_R2 = VALID and WF_q2_2 and WF_q4_1  # route X1-X5 could be granted (R6)
        AD_R3 = VALID and WF_q3_2 and WF_q2_3 and WF_q1_2  # route X2-W could be granted (R6)
        AD_R5 = VALID and WF_q11_2 and WF_q9_1 and WF_q7_2 and WF_q5_2  # route X4-X2 could be granted (R6)
        AD_R7 = VALID and WF_q6_1 and WF_q8_2 and WF_q10_2 and WF_q11_3  # route X5-E could be granted (R6)
        AD_R9 = VALID and WF_q1_1  # route X7-X1 could be granted (R6)
        NT_R2 = (N_R2 and (not L_q1_2) and (not L_q2_3))  # 
        WT_R2 = NT_R2 and AD_R2  # route X1-X5 is noted and could be set
        NT_R3 = (N_R3 and (not L_q1_1) and (not L_q2_2))  # 
        WT_R3 = NT_R3 and AD_R3  # route X2-W is noted and could be set
        NT_R5 = (N_R5 and (not L_q11_3))  # 
        WT_R5 = NT_R5 and AD_R5  # route X4-X2 is noted and could be set
        NT_R7 = (N_R7 and (not L_q11_2))  # 
        WT_R7 = NT_R7 and AD_R7  # route X5-E is noted and could be set
        NT_R9 = (N_R9 and (not L_q1_2) and (not L_q2_3))  # 
        WT_R9 = NT_R9 and AD_R9  # route X7-X1 is noted and could be set
        PC_1 = WT_R2 or WT_R7 or WT_R9  # a route of class 1 waits that could be set
        PC_2 = WT_R3 or WT_R5  # a route of class 2 waits that could be set
        RQ_R2 = ((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) or ((LREQ == 0) and (REQ == 0) and T_R2 and NT_R2)  # route X1-X5 is asked for (R14, R18)
        RQ_R3 = ((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) or ((LREQ == 0) and (REQ == 0) and T_R3 and NT_R3 and (not PC_1))  # route X2-W is asked for (R14, R18)
        RQ_R5 = ((LREQ == 5) or ((LREQ == 0) and (REQ == 5))) or ((LREQ == 0) and (REQ == 0) and T_R5 and NT_R5 and (not PC_1))  # route X4-X2 is asked for (R14, R18)
        RQ_R7 = ((LREQ == 7) or ((LREQ == 0) and (REQ == 7))) or ((LREQ == 0) and (REQ == 0) and T_R7 and NT_R7)  # route X5-E is asked for (R14, R18)
        RQ_R9 = ((LREQ == 9) or ((LREQ == 0) and (REQ == 9))) or ((LREQ == 0) and (REQ == 0) and T_R9 and NT_R9)  # route X7-X1 is asked for (R14, R18)
        G_R1 = ((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and VALID and WF_q2_1 and WF_q3_1  # grant of route X1-X3 (R6)
        G_R2 = RQ_R2 and AD_R2  # grant of route X1-X5 (R6)
        G_R3 = RQ_R3 and AD_R3  # grant of route X2-W (R6)
        G_R4 = ((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and VALID and WF_q5_1 and WF_q7_1 and WF_q9_2 and WF_q11_4  # grant of route X3-E (R6)
        G_R5 = RQ_R5 and AD_R5  # grant of route X4-X2 (R6)
        G_R6 = ((LREQ == 6) or ((LREQ == 0) and (REQ == 6))) and VALID and WF_q11_1 and WF_q10_1  # grant of route X4-X6 (R6)
        G_R7 = RQ_R7 and AD_R7  # grant of route X5-E (R6)
        G_R8 = ((LREQ == 8) or ((LREQ == 0) and (REQ == 8))) and VALID and WF_q8_1 and WF_q6_2 and WF_q4_2 and WF_q2_4 and WF_q1_2  # grant of route X6-W (R6)
        G_R9 = RQ_R9 and AD_R9  # grant of route X7-X1 (R6)
        GW_q1_1 = G_R9  # q1 from W to q1|q2@P1.toe: granted
        GW_q1_2 = G_R3 or G_R8  # q1 from q1|q2@P1.toe to W: granted
        GW_q10_1 = G_R6  # q10 from q10|q11@P2.reverse to q10|q8@even.2: granted
        GW_q10_2 = G_R7  # q10 from q10|q8@even.2 to q10|q11@P2.reverse: granted
        GW_q11_1 = G_R6  # q11 from E to q10|q11@P2.reverse: granted
        GW_q11_2 = G_R5  # q11 from E to q11|q9@P2.normal: granted
        GW_q11_3 = G_R7  # q11 from q10|q11@P2.reverse to E: granted
        GW_q11_4 = G_R4  # q11 from q11|q9@P2.normal to E: granted
        GW_q2_1 = G_R1  # q2 from q1|q2@P1.toe to q2|q3@P1.normal: granted
        GW_q2_2 = G_R2  # q2 from q1|q2@P1.toe to q2|q4@P1.reverse: granted
        GW_q2_3 = G_R3  # q2 from q2|q3@P1.normal to q1|q2@P1.toe: granted
        GW_q2_4 = G_R8  # q2 from q2|q4@P1.reverse to q1|q2@P1.toe: granted
        GW_q3_1 = G_R1  # q3 from q2|q3@P1.normal to q3|q5@odd.0: granted
        GW_q3_2 = G_R3  # q3 from q3|q5@odd.0 to q2|q3@P1.normal: granted
        GW_q4_1 = G_R2  # q4 from q2|q4@P1.reverse to q4|q6@even.0: granted
        GW_q4_2 = G_R8  # q4 from q4|q6@even.0 to q2|q4@P1.reverse: granted
        GW_q5_1 = G_R4  # q5 from q3|q5@odd.0 to q5|q7@odd.1: granted
        GW_q5_2 = G_R5  # q5 from q5|q7@odd.1 to q3|q5@odd.0: granted
        GW_q6_1 = G_R7  # q6 from q4|q6@even.0 to q6|q8@even.1: granted
        GW_q6_2 = G_R8  # q6 from q6|q8@even.1 to q4|q6@even.0: granted
        GW_q7_1 = G_R4  # q7 from q5|q7@odd.1 to q7|q9@odd.2: granted
        GW_q7_2 = G_R5  # q7 from q7|q9@odd.2 to q5|q7@odd.1: granted
        GW_q8_1 = G_R8  # q8 from q10|q8@even.2 to q6|q8@even.1: granted
        GW_q8_2 = G_R7  # q8 from q6|q8@even.1 to q10|q8@even.2: granted
        GW_q9_1 = G_R5  # q9 from q11|q9@P2.normal to q7|q9@odd.2: granted
        GW_q9_2 = G_R4  # q9 from q7|q9@odd.2 to q11|q9@P2.normal: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_X1) and (not CAN_X1) and WL_q2_1 and WL_q3_1  # route X1-X3 becomes locked (R3)
        CO_R1 = VALID and WP_q2_1 and WP_q3_1 and (not D_q2)  # conditions of proceed for route X1-X3 (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_X1) and (not CAN_X1) and WL_q2_2 and WL_q4_1  # route X1-X5 becomes locked (R3)
        CO_R2 = VALID and WP_q2_2 and WP_q4_1 and (not D_q2)  # conditions of proceed for route X1-X5 (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_X2) and (not CAN_X2) and WL_q3_2 and WL_q2_3 and WL_q1_2  # route X2-W becomes locked (R3)
        CO_R3 = VALID and WP_q3_2 and WP_q2_3 and WP_q1_2 and (not OCC_ap_W) and (not D_q3)  # conditions of proceed for route X2-W (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_X3) and (not CAN_X3) and WL_q5_1 and WL_q7_1 and WL_q9_2 and WL_q11_4  # route X3-E becomes locked (R3)
        CO_R4 = VALID and WP_q5_1 and WP_q7_1 and WP_q9_2 and WP_q11_4 and (not OCC_ap_E) and (not D_q5)  # conditions of proceed for route X3-E (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_X4) and (not CAN_X4) and WL_q11_2 and WL_q9_1 and WL_q7_2 and WL_q5_2  # route X4-X2 becomes locked (R3)
        CO_R5 = VALID and WP_q11_2 and WP_q9_1 and WP_q7_2 and WP_q5_2 and (not D_q11)  # conditions of proceed for route X4-X2 (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_X4) and (not CAN_X4) and WL_q11_1 and WL_q10_1  # route X4-X6 becomes locked (R3)
        CO_R6 = VALID and WP_q11_1 and WP_q10_1 and (not D_q11)  # conditions of proceed for route X4-X6 (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_X5) and (not CAN_X5) and WL_q6_1 and WL_q8_2 and WL_q10_2 and WL_q11_3  # route X5-E becomes locked (R3)
        CO_R7 = VALID and WP_q6_1 and WP_q8_2 and WP_q10_2 and WP_q11_3 and (not OCC_ap_E) and (not D_q6)  # conditions of proceed for route X5-E (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_X6) and (not CAN_X6) and WL_q8_1 and WL_q6_2 and WL_q4_2 and WL_q2_4 and WL_q1_2  # route X6-W becomes locked (R3)
        CO_R8 = VALID and WP_q8_1 and WP_q6_2 and WP_q4_2 and WP_q2_4 and WP_q1_2 and (not OCC_ap_W) and (not D_q8)  # conditions of proceed for route X6-W (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_X7) and (not CAN_X7) and WL_q1_1  # route X7-X1 becomes locked (R3)
        CO_R9 = VALID and WP_q1_1 and (not D_q1)  # conditions of proceed for route X7-X1 (R3)
        NU_q1_1 = VALID and F_q1 and (not D_q1) and (not U_q1) and L_q1_1 and OCC_q1 and OCC_ap_W  # a train comes into q1 at W (R9)
        NU_q1_2 = VALID and F_q1 and (not D_q1) and (not U_q1) and L_q1_2 and OCC_q1 and OCC_q2 and U_q2 and (L_q2_3 or L_q2_4)  # a train comes into q1 at q1|q2@P1.toe (R9)
        NU_q10_1 = VALID and F_q10 and (not D_q10) and (not U_q10) and L_q10_1 and OCC_q10 and OCC_q11 and U_q11 and L_q11_1  # a train comes into q10 at q10|q11@P2.reverse (R9)
        NU_q10_2 = VALID and F_q10 and (not D_q10) and (not U_q10) and L_q10_2 and OCC_q10 and OCC_q8 and U_q8 and L_q8_2  # a train comes into q10 at q10|q8@even.2 (R9)
        NU_q11_1 = VALID and F_q11 and (not D_q11) and (not U_q11) and (L_q11_1 or L_q11_2) and OCC_q11 and OCC_ap_E  # a train comes into q11 at E (R9)
        NU_q11_2 = VALID and F_q11 and (not D_q11) and (not U_q11) and L_q11_3 and OCC_q11 and OCC_q10 and U_q10 and L_q10_2  # a train comes into q11 at q10|q11@P2.reverse (R9)
        NU_q11_3 = VALID and F_q11 and (not D_q11) and (not U_q11) and L_q11_4 and OCC_q11 and OCC_q9 and U_q9 and L_q9_2  # a train comes into q11 at q11|q9@P2.normal (R9)
        NU_q2_1 = VALID and F_q2 and (not D_q2) and (not U_q2) and (L_q2_1 or L_q2_2) and OCC_q2 and OCC_q1  # a train comes into q2 at q1|q2@P1.toe (R9)
        NU_q2_2 = VALID and F_q2 and (not D_q2) and (not U_q2) and L_q2_3 and OCC_q2 and OCC_q3 and U_q3 and L_q3_2  # a train comes into q2 at q2|q3@P1.normal (R9)
        NU_q2_3 = VALID and F_q2 and (not D_q2) and (not U_q2) and L_q2_4 and OCC_q2 and OCC_q4 and U_q4 and L_q4_2  # a train comes into q2 at q2|q4@P1.reverse (R9)
        NU_q3_1 = VALID and F_q3 and (not D_q3) and (not U_q3) and L_q3_1 and OCC_q3 and OCC_q2 and U_q2 and L_q2_1  # a train comes into q3 at q2|q3@P1.normal (R9)
        NU_q3_2 = VALID and F_q3 and (not D_q3) and (not U_q3) and L_q3_2 and OCC_q3 and OCC_q5  # a train comes into q3 at q3|q5@odd.0 (R9)
        NU_q4_1 = VALID and F_q4 and (not D_q4) and (not U_q4) and L_q4_1 and OCC_q4 and OCC_q2 and U_q2 and L_q2_2  # a train comes into q4 at q2|q4@P1.reverse (R9)
        NU_q4_2 = VALID and F_q4 and (not D_q4) and (not U_q4) and L_q4_2 and OCC_q4 and OCC_q6 and U_q6 and L_q6_2  # a train comes into q4 at q4|q6@even.0 (R9)
        NU_q5_1 = VALID and F_q5 and (not D_q5) and (not U_q5) and L_q5_1 and OCC_q5 and OCC_q3  # a train comes into q5 at q3|q5@odd.0 (R9)
        NU_q5_2 = VALID and F_q5 and (not D_q5) and (not U_q5) and L_q5_2 and OCC_q5 and OCC_q7 and U_q7 and L_q7_2  # a train comes into q5 at q5|q7@odd.1 (R9)
        NU_q6_1 = VALID and F_q6 and (not D_q6) and (not U_q6) and L_q6_1 and OCC_q6 and OCC_q4  # a train comes into q6 at q4|q6@even.0 (R9)
        NU_q6_2 = VALID and F_q6 and (not D_q6) and (not U_q6) and L_q6_2 and OCC_q6 and OCC_q8 and U_q8 and L_q8_1  # a train comes into q6 at q6|q8@even.1 (R9)
        NU_q7_1 = VALID and F_q7 and (not D_q7) and (not U_q7) and L_q7_1 and OCC_q7 and OCC_q5 and U_q5 and L_q5_1  # a train comes into q7 at q5|q7@odd.1 (R9)
        NU_q7_2 = VALID and F_q7 and (not D_q7) and (not U_q7) and L_q7_2 and OCC_q7 and OCC_q9 and U_q9 and L_q9_1  # a train comes into q7 at q7|q9@odd.2 (R9)
        NU_q8_1 = VALID and F_q8 and (not D_q8) and (not U_q8) and L_q8_1 and OCC_q8 and OCC_q10  # a train comes into q8 at q10|q8@even.2 (R9)
        NU_q8_2 = VALID and F_q8 and (not D_q8) and (not U_q8) and L_q8_2 and OCC_q8 and OCC_q6 and U_q6 and L_q6_1  # a train comes into q8 at q6|q8@even.1 (R9)
        NU_q9_1 = VALID and F_q9 and (not D_q9) and (not U_q9) and L_q9_1 and OCC_q9 and OCC_q11 and U_q11 and L_q11_2  # a train comes into q9 at q11|q9@P2.normal (R9)
        NU_q9_2 = VALID and F_q9 and (not D_q9) and (not U_q9) and L_q9_2 and OCC_q9 and OCC_q7 and U_q7 and L_q7_1  # a train comes into q9 at q7|q9@odd.2 (R9)
        ATI_X1 = X_X1 or ((not (A_R1 or A_R2)) and (L_q2_1 or L_q2_2) and REL_q2)  # X1 at stop, waiting for a train that may still come (R8)
        ATI_X2 = X_X2 or ((not A_R3) and L_q3_2 and REL_q3)  # X2 at stop, waiting for a train that may still come (R8)
        ATI_X3 = X_X3 or ((not A_R4) and L_q5_1 and REL_q5)  # X3 at stop, waiting for a train that may still come (R8)
        ATI_X4 = X_X4 or ((not (A_R5 or A_R6)) and (L_q11_1 or L_q11_2) and REL_q11)  # X4 at stop, waiting for a train that may still come (R8)
        ATI_X5 = X_X5 or ((not A_R7) and L_q6_1 and REL_q6)  # X5 at stop, waiting for a train that may still come (R8)
        ATI_X6 = X_X6 or ((not A_R8) and L_q8_1 and REL_q8)  # X6 at stop, waiting for a train that may still come (R8)
        ATI_X7 = X_X7 or ((not A_R9) and L_q1_1 and REL_q1)  # X7 at stop, waiting for a train that may still come (R8)
        AT_X1 = self._timer('AT_X1', ATI_X1, dt_ms)  # X1: approach locking delay (R8)
        AT_X2 = self._timer('AT_X2', ATI_X2, dt_ms)  # X2: approach locking delay (R8)
        AT_X3 = self._timer('AT_X3', ATI_X3, dt_ms)  # X3: approach locking delay (R8)
        AT_X4 = self._timer('AT_X4', ATI_X4, dt_ms)  # X4: approach locking delay (R8)
        AT_X5 = self._timer('AT_X5', ATI_X5, dt_ms)  # X5: approach locking delay (R8)
        AT_X6 = self._timer('AT_X6', ATI_X6, dt_ms)  # X6: approach locking delay (R8)
        AT_X7 = self._timer('AT_X7', ATI_X7, dt_ms)  # X7: approach locking delay (R8)
        CD_X1 = X_X1 and (A_R1 or A_R2) and VALID and (not OCC_q2) and ((not OCC_q1) or AT_X1 or (not (H_R1 or H_R2)))  # the route from X1 is cancelled (R8)
        CD_X2 = X_X2 and A_R3 and VALID and (not OCC_q3) and ((not OCC_q5) or AT_X2 or (not H_R3))  # the route from X2 is cancelled (R8)
        CD_X3 = X_X3 and A_R4 and VALID and (not OCC_q5) and ((not OCC_q3) or AT_X3 or (not H_R4))  # the route from X3 is cancelled (R8)
        CD_X4 = X_X4 and (A_R5 or A_R6) and VALID and (not OCC_q11) and ((not OCC_ap_E) or AT_X4 or (not (H_R5 or H_R6)))  # the route from X4 is cancelled (R8)
        CD_X5 = X_X5 and A_R7 and VALID and (not OCC_q6) and ((not OCC_q4) or AT_X5 or (not H_R7))  # the route from X5 is cancelled (R8)
        CD_X6 = X_X6 and A_R8 and VALID and (not OCC_q8) and ((not OCC_q10) or AT_X6 or (not H_R8))  # the route from X6 is cancelled (R8)
        CD_X7 = X_X7 and A_R9 and VALID and (not OCC_q1) and ((not OCC_ap_W) or AT_X7 or (not H_R9))  # the route from X7 is cancelled (R8)
        EX_q1 = P_q1 or L_q1_2  # a train in q1 leaves over a boundary, or has passed on
        RTI_q1 = VALID and U_q1 and (not OCC_q1) and (not (L_q1_2 and (L_q2_3 or L_q2_4))) and EX_q1  # q1 may be released behind the train (R9)
        EX_q10 = P_q10  # a train in q10 leaves over a boundary, or has passed on
        RTI_q10 = VALID and U_q10 and (not OCC_q10) and (not (L_q10_1 and L_q11_1)) and (not (L_q10_2 and L_q8_2)) and EX_q10  # q10 may be released behind the train (R9)
        EX_q11 = P_q11 or L_q11_3 or L_q11_4  # a train in q11 leaves over a boundary, or has passed on
        RTI_q11 = VALID and U_q11 and (not OCC_q11) and (not (L_q11_3 and L_q10_2)) and (not (L_q11_4 and L_q9_2)) and EX_q11  # q11 may be released behind the train (R9)
        EX_q2 = P_q2  # a train in q2 leaves over a boundary, or has passed on
        RTI_q2 = VALID and U_q2 and (not OCC_q2) and (not (L_q2_3 and L_q3_2)) and (not (L_q2_4 and L_q4_2)) and EX_q2  # q2 may be released behind the train (R9)
        EX_q3 = P_q3  # a train in q3 leaves over a boundary, or has passed on
        RTI_q3 = VALID and U_q3 and (not OCC_q3) and (not (L_q3_1 and L_q2_1)) and EX_q3  # q3 may be released behind the train (R9)
        EX_q4 = P_q4  # a train in q4 leaves over a boundary, or has passed on
        RTI_q4 = VALID and U_q4 and (not OCC_q4) and (not (L_q4_1 and L_q2_2)) and (not (L_q4_2 and L_q6_2)) and EX_q4  # q4 may be released behind the train (R9)
        EX_q5 = P_q5  # a train in q5 leaves over a boundary, or has passed on
        RTI_q5 = VALID and U_q5 and (not OCC_q5) and (not (L_q5_2 and L_q7_2)) and EX_q5  # q5 may be released behind the train (R9)
        EX_q6 = P_q6  # a train in q6 leaves over a boundary, or has passed on
        RTI_q6 = VALID and U_q6 and (not OCC_q6) and (not (L_q6_2 and L_q8_1)) and EX_q6  # q6 may be released behind the train (R9)
        EX_q7 = P_q7  # a train in q7 leaves over a boundary, or has passed on
        RTI_q7 = VALID and U_q7 and (not OCC_q7) and (not (L_q7_1 and L_q5_1)) and (not (L_q7_2 and L_q9_1)) and EX_q7  # q7 may be released behind the train (R9)
        EX_q8 = P_q8  # a train in q8 leaves over a boundary, or has passed on
        RTI_q8 = VALID and U_q8 and (not OCC_q8) and (not (L_q8_2 and L_q6_1)) and EX_q8  # q8 may be released behind the train (R9)
        EX_q9 = P_q9  # a train in q9 leaves over a boundary, or has passed on
        RTI_q9 = VALID and U_q9 and (not OCC_q9) and (not (L_q9_1 and L_q11_2)) and (not (L_q9_2 and L_q7_1)) and EX_q9  # q9 may be released behind the train (R9)
        RT_q1 = self._timer('RT_q1', RTI_q1, dt_ms)  # q1: release delay (R9)
        RT_q10 = self._timer('RT_q10', RTI_q10, dt_ms)  # q10: release delay (R9)
        RT_q11 = self._timer('RT_q11', RTI_q11, dt_ms)  # q11: release delay (R9)
        RT_q2 = self._timer('RT_q2', RTI_q2, dt_ms)  # q2: release delay (R9)
        RT_q3 = self._timer('RT_q3', RTI_q3, dt_ms)  # q3: release delay (R9)
        RT_q4 = self._timer('RT_q4', RTI_q4, dt_ms)  # q4: release delay (R9)
        RT_q5 = self._timer('RT_q5', RTI_q5, dt_ms)  # q5: release delay (R9)
        RT_q6 = self._timer('RT_q6', RTI_q6, dt_ms)  # q6: release delay (R9)
        RT_q7 = self._timer('RT_q7', RTI_q7, dt_ms)  # q7: release delay (R9)
        RT_q8 = self._timer('RT_q8', RTI_q8, dt_ms)  # q8: release delay (R9)
        RT_q9 = self._timer('RT_q9', RTI_q9, dt_ms)  # q9: release delay (R9)
        CA_q1 = VALID and (not OCC_q1) and (not U_q1) and L_q1_2 and (not (L_q1_2 and (L_q2_3 or L_q2_4)))  # the lock before q1 was withdrawn (R8)
        HR_q1 = VALID and (not OCC_q1) and (not (L_q1_2 and (L_q2_3 or L_q2_4))) and REL_q1 and (L_q1_1 or L_q1_2) and ((not L_q1_1) or ((not A_R9) and ((not OCC_ap_W) or AT_X7)))  # q1 released by hand (R8, section fault release)
        SR_q1 = VALID and (not OCC_q1) and K_q1 and (REL_q1 or RELALL)  # q1 released after a restart (R16)
        RLS_q1 = RT_q1 or CA_q1 or CD_X7 or HR_q1 or SR_q1  # q1 is released
        CA_q10 = VALID and (not OCC_q10) and (not U_q10) and (L_q10_1 or L_q10_2) and (not (L_q10_1 and L_q11_1)) and (not (L_q10_2 and L_q8_2))  # the lock before q10 was withdrawn (R8)
        HR_q10 = VALID and (not OCC_q10) and (not (L_q10_1 and L_q11_1)) and (not (L_q10_2 and L_q8_2)) and REL_q10 and (L_q10_1 or L_q10_2)  # q10 released by hand (R8, section fault release)
        SR_q10 = VALID and (not OCC_q10) and K_q10 and (REL_q10 or RELALL)  # q10 released after a restart (R16)
        RLS_q10 = RT_q10 or CA_q10 or HR_q10 or SR_q10  # q10 is released
        CA_q11 = VALID and (not OCC_q11) and (not U_q11) and (L_q11_3 or L_q11_4) and (not (L_q11_3 and L_q10_2)) and (not (L_q11_4 and L_q9_2))  # the lock before q11 was withdrawn (R8)
        HR_q11 = VALID and (not OCC_q11) and (not (L_q11_3 and L_q10_2)) and (not (L_q11_4 and L_q9_2)) and REL_q11 and (L_q11_1 or L_q11_2 or L_q11_3 or L_q11_4) and ((not (L_q11_1 or L_q11_2)) or ((not (A_R5 or A_R6)) and ((not OCC_ap_E) or AT_X4)))  # q11 released by hand (R8, section fault release)
        SR_q11 = VALID and (not OCC_q11) and K_q11 and (REL_q11 or RELALL)  # q11 released after a restart (R16)
        RLS_q11 = RT_q11 or CA_q11 or CD_X4 or HR_q11 or SR_q11  # q11 is released
        CA_q2 = VALID and (not OCC_q2) and (not U_q2) and (L_q2_3 or L_q2_4) and (not (L_q2_3 and L_q3_2)) and (not (L_q2_4 and L_q4_2))  # the lock before q2 was withdrawn (R8)
        HR_q2 = VALID and (not OCC_q2) and (not (L_q2_3 and L_q3_2)) and (not (L_q2_4 and L_q4_2)) and REL_q2 and (L_q2_1 or L_q2_2 or L_q2_3 or L_q2_4) and ((not (L_q2_1 or L_q2_2)) or ((not (A_R1 or A_R2)) and ((not OCC_q1) or AT_X1)))  # q2 released by hand (R8, section fault release)
        SR_q2 = VALID and (not OCC_q2) and K_q2 and (REL_q2 or RELALL)  # q2 released after a restart (R16)
        RLS_q2 = RT_q2 or CA_q2 or CD_X1 or HR_q2 or SR_q2  # q2 is released
        CA_q3 = VALID and (not OCC_q3) and (not U_q3) and L_q3_1 and (not (L_q3_1 and L_q2_1))  # the lock before q3 was withdrawn (R8)
        HR_q3 = VALID and (not OCC_q3) and (not (L_q3_1 and L_q2_1)) and REL_q3 and (L_q3_1 or L_q3_2) and ((not L_q3_2) or ((not A_R3) and ((not OCC_q5) or AT_X2)))  # q3 released by hand (R8, section fault release)
        SR_q3 = VALID and (not OCC_q3) and K_q3 and (REL_q3 or RELALL)  # q3 released after a restart (R16)
        RLS_q3 = RT_q3 or CA_q3 or CD_X2 or HR_q3 or SR_q3  # q3 is released
        CA_q4 = VALID and (not OCC_q4) and (not U_q4) and (L_q4_1 or L_q4_2) and (not (L_q4_1 and L_q2_2)) and (not (L_q4_2 and L_q6_2))  # the lock before q4 was withdrawn (R8)
        HR_q4 = VALID and (not OCC_q4) and (not (L_q4_1 and L_q2_2)) and (not (L_q4_2 and L_q6_2)) and REL_q4 and (L_q4_1 or L_q4_2)  # q4 released by hand (R8, section fault release)
        SR_q4 = VALID and (not OCC_q4) and K_q4 and (REL_q4 or RELALL)  # q4 released after a restart (R16)
        RLS_q4 = RT_q4 or CA_q4 or HR_q4 or SR_q4  # q4 is released
        CA_q5 = VALID and (not OCC_q5) and (not U_q5) and L_q5_2 and (not (L_q5_2 and L_q7_2))  # the lock before q5 was withdrawn (R8)
        HR_q5 = VALID and (not OCC_q5) and (not (L_q5_2 and L_q7_2)) and REL_q5 and (L_q5_1 or L_q5_2) and ((not L_q5_1) or ((not A_R4) and ((not OCC_q3) or AT_X3)))  # q5 released by hand (R8, section fault release)
        SR_q5 = VALID and (not OCC_q5) and K_q5 and (REL_q5 or RELALL)  # q5 released after a restart (R16)
        RLS_q5 = RT_q5 or CA_q5 or CD_X3 or HR_q5 or SR_q5  # q5 is released
        CA_q6 = VALID and (not OCC_q6) and (not U_q6) and L_q6_2 and (not (L_q6_2 and L_q8_1))  # the lock before q6 was withdrawn (R8)
        HR_q6 = VALID and (not OCC_q6) and (not (L_q6_2 and L_q8_1)) and REL_q6 and (L_q6_1 or L_q6_2) and ((not L_q6_1) or ((not A_R7) and ((not OCC_q4) or AT_X5)))  # q6 released by hand (R8, section fault release)
        SR_q6 = VALID and (not OCC_q6) and K_q6 and (REL_q6 or RELALL)  # q6 released after a restart (R16)
        RLS_q6 = RT_q6 or CA_q6 or CD_X5 or HR_q6 or SR_q6  # q6 is released
        CA_q7 = VALID and (not OCC_q7) and (not U_q7) and (L_q7_1 or L_q7_2) and (not (L_q7_1 and L_q5_1)) and (not (L_q7_2 and L_q9_1))  # the lock before q7 was withdrawn (R8)
        HR_q7 = VALID and (not OCC_q7) and (not (L_q7_1 and L_q5_1)) and (not (L_q7_2 and L_q9_1)) and REL_q7 and (L_q7_1 or L_q7_2)  # q7 released by hand (R8, section fault release)
        SR_q7 = VALID and (not OCC_q7) and K_q7 and (REL_q7 or RELALL)  # q7 released after a restart (R16)
        RLS_q7 = RT_q7 or CA_q7 or HR_q7 or SR_q7  # q7 is released
        CA_q8 = VALID and (not OCC_q8) and (not U_q8) and L_q8_2 and (not (L_q8_2 and L_q6_1))  # the lock before q8 was withdrawn (R8)
        HR_q8 = VALID and (not OCC_q8) and (not (L_q8_2 and L_q6_1)) and REL_q8 and (L_q8_1 or L_q8_2) and ((not L_q8_1) or ((not A_R8) and ((not OCC_q10) or AT_X6)))  # q8 released by hand (R8, section fault release)
        SR_q8 = VALID and (not OCC_q8) and K_q8 and (REL_q8 or RELALL)  # q8 released after a restart (R16)
        RLS_q8 = RT_q8 or CA_q8 or CD_X6 or HR_q8 or SR_q8  # q8 is released
        CA_q9 = VALID and (not OCC_q9) and (not U_q9) and (L_q9_1 or L_q9_2) and (not (L_q9_1 and L_q11_2)) and (not (L_q9_2 and L_q7_1))  # the lock before q9 was withdrawn (R8)
        HR_q9 = VALID and (not OCC_q9) and (not (L_q9_1 and L_q11_2)) and (not (L_q9_2 and L_q7_1)) and REL_q9 and (L_q9_1 or L_q9_2)  # q9 released by hand (R8, section fault release)
        SR_q9 = VALID and (not OCC_q9) and K_q9 and (REL_q9 or RELALL)  # q9 released after a restart (R16)
        RLS_q9 = RT_q9 or CA_q9 or HR_q9 or SR_q9  # q9 is released
        TG_P1 = (GW_q2_1 or GW_q2_2 or GW_q2_3 or GW_q2_4)  # a grant touches machine P1 in this scan
        GPN_P1 = (GW_q2_1 or GW_q2_3)  # a grant needs P1 N
        MAN_P1 = MN_P1 and (not MR_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved N by hand
        GPR_P1 = (GW_q2_2 or GW_q2_4)  # a grant needs P1 R
        MAR_P1 = MR_P1 and (not MN_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved R by hand
        HDN_P1 = CN_P1 and (not GPR_P1) and (not MAR_P1)  # the command N stays
        HDR_P1 = CR_P1 and (not GPN_P1) and (not MAN_P1)  # the command R stays
        TG_P2 = (GW_q11_1 or GW_q11_2 or GW_q11_3 or GW_q11_4)  # a grant touches machine P2 in this scan
        GPN_P2 = (GW_q11_2 or GW_q11_4)  # a grant needs P2 N
        MAN_P2 = MN_P2 and (not MR_P2) and MOV_P2 and (not TG_P2)  # machine P2 moved N by hand
        GPR_P2 = (GW_q11_1 or GW_q11_3)  # a grant needs P2 R
        MAR_P2 = MR_P2 and (not MN_P2) and MOV_P2 and (not TG_P2)  # machine P2 moved R by hand
        HDN_P2 = CN_P2 and (not GPR_P2) and (not MAR_P2)  # the command N stays
        HDR_P2 = CR_P2 and (not GPN_P2) and (not MAN_P2)  # the command R stays
        STI_P1 = (CN_P1 and (not QN_P1)) or (CR_P1 and (not QR_P1))  # machine P1 is not where it was commanded
        STI_P2 = (CN_P2 and (not QN_P2)) or (CR_P2 and (not QR_P2))  # machine P2 is not where it was commanded
        ST_P1 = self._timer('ST_P1', STI_P1, dt_ms)  # machine P1: time-out
        ST_P2 = self._timer('ST_P2', STI_P2, dt_ms)  # machine P2: time-out
        KP_R1 = (not NU_q2_1) and (not CD_X1)  # route X1-X3 stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_X1) and (not CAN_X1)  # proceed for route X1-X3 (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route X1-X3: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_q2_1) and (not CD_X1)  # route X1-X5 stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_X1) and (not CAN_X1)  # proceed for route X1-X5 (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route X1-X5: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_q3_2) and (not CD_X2)  # route X2-W stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_X2) and (not CAN_X2)  # proceed for route X2-W (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route X2-W: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_q5_1) and (not CD_X3)  # route X3-E stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_X3) and (not CAN_X3)  # proceed for route X3-E (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route X3-E: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_q11_1) and (not CD_X4)  # route X4-X2 stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_X4) and (not CAN_X4)  # proceed for route X4-X2 (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route X4-X2: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_q11_1) and (not CD_X4)  # route X4-X6 stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_X4) and (not CAN_X4)  # proceed for route X4-X6 (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route X4-X6: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_q6_1) and (not CD_X5)  # route X5-E stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_X5) and (not CAN_X5)  # proceed for route X5-E (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route X5-E: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_q8_1) and (not CD_X6)  # route X6-W stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_X6) and (not CAN_X6)  # proceed for route X6-W (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route X6-W: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_q1_1) and (not CD_X7)  # route X7-X1 stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_X7) and (not CAN_X7)  # proceed for route X7-X1 (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route X7-X1: a condition was lost; no reopening by itself (R14)
        N_CN_P1 = GPN_P1 or MAN_P1 or HDN_P1  # machine P1 commanded N
        N_CR_P1 = GPR_P1 or MAR_P1 or HDR_P1  # machine P1 commanded R
        N_CN_P2 = GPN_P2 or MAN_P2 or HDN_P2  # machine P2 commanded N
        N_CR_P2 = GPR_P2 or MAR_P2 or HDR_P2  # machine P2 commanded R
        N_AL_P1 = ST_P1  # alarm: machine P1 not detected
        N_AL_P2 = ST_P2  # alarm: machine P2 not detected
        N_TH_P1 = ((CN_P1 and QN_P1) or (CR_P1 and QR_P1)) and (not (GPN_P1 or GPR_P1 or MAN_P1 or MAR_P1))  # machine P1 was detected where it is commanded
        N_TR_P1 = (TH_P1 and VALID and ((CN_P1 and (not QN_P1) and (not GPR_P1) and (not MAR_P1)) or (CR_P1 and (not QR_P1) and (not GPN_P1) and (not MAN_P1)))) or (TR_P1 and (not (TC_P1 and VALID and (not OCC_q2))))  # machine P1 was trailed
        N_TH_P2 = ((CN_P2 and QN_P2) or (CR_P2 and QR_P2)) and (not (GPN_P2 or GPR_P2 or MAN_P2 or MAR_P2))  # machine P2 was detected where it is commanded
        N_TR_P2 = (TH_P2 and VALID and ((CN_P2 and (not QN_P2) and (not GPR_P2) and (not MAR_P2)) or (CR_P2 and (not QR_P2) and (not GPN_P2) and (not MAN_P2)))) or (TR_P2 and (not (TC_P2 and VALID and (not OCC_q11))))  # machine P2 was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route X1-X3 active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route X1-X3 locked
        N_W_R1 = (W_R1 or LK_R1 or (((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and B_R1)) and (not LS_R1) and KP_R1 and (not X_X1) and (not CAN_X1)  # route X1-X3: proceed wanted
        N_S_R1 = PR_R1  # route X1-X3: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route X1-X3: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route X1-X5 active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route X1-X5 locked
        N_W_R2 = (W_R2 or LK_R2 or (((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) and B_R2)) and (not LS_R2) and KP_R2 and (not X_X1) and (not CAN_X1)  # route X1-X5: proceed wanted
        N_S_R2 = PR_R2  # route X1-X5: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route X1-X5: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route X2-W active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route X2-W locked
        N_W_R3 = (W_R3 or LK_R3 or (((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and B_R3)) and (not LS_R3) and KP_R3 and (not X_X2) and (not CAN_X2)  # route X2-W: proceed wanted
        N_S_R3 = PR_R3  # route X2-W: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route X2-W: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route X3-E active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route X3-E locked
        N_W_R4 = (W_R4 or LK_R4 or (((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and B_R4)) and (not LS_R4) and KP_R4 and (not X_X3) and (not CAN_X3)  # route X3-E: proceed wanted
        N_S_R4 = PR_R4  # route X3-E: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route X3-E: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route X4-X2 active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route X4-X2 locked
        N_W_R5 = (W_R5 or LK_R5 or (((LREQ == 5) or ((LREQ == 0) and (REQ == 5))) and B_R5)) and (not LS_R5) and KP_R5 and (not X_X4) and (not CAN_X4)  # route X4-X2: proceed wanted
        N_S_R5 = PR_R5  # route X4-X2: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route X4-X2: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route X4-X6 active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route X4-X6 locked
        N_W_R6 = (W_R6 or LK_R6 or (((LREQ == 6) or ((LREQ == 0) and (REQ == 6))) and B_R6)) and (not LS_R6) and KP_R6 and (not X_X4) and (not CAN_X4)  # route X4-X6: proceed wanted
        N_S_R6 = PR_R6  # route X4-X6: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route X4-X6: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route X5-E active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route X5-E locked
        N_W_R7 = (W_R7 or LK_R7 or (((LREQ == 7) or ((LREQ == 0) and (REQ == 7))) and B_R7)) and (not LS_R7) and KP_R7 and (not X_X5) and (not CAN_X5)  # route X5-E: proceed wanted
        N_S_R7 = PR_R7  # route X5-E: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route X5-E: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route X6-W active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route X6-W locked
        N_W_R8 = (W_R8 or LK_R8 or (((LREQ == 8) or ((LREQ == 0) and (REQ == 8))) and B_R8)) and (not LS_R8) and KP_R8 and (not X_X6) and (not CAN_X6)  # route X6-W: proceed wanted
        N_S_R8 = PR_R8  # route X6-W: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route X6-W: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route X7-X1 active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route X7-X1 locked
        N_W_R9 = (W_R9 or LK_R9 or (((LREQ == 9) or ((LREQ == 0) and (REQ == 9))) and B_R9)) and (not LS_R9) and KP_R9 and (not X_X7) and (not CAN_X7)  # route X7-X1: proceed wanted
        N_S_R9 = PR_R9  # route X7-X1: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route X7-X1: signal has been open
        N_X_X1 = (X_X1 or CAN_X1) and (A_R1 or A_R2) and (not CD_X1)  # X1: cancelling
        N_X_X2 = (X_X2 or CAN_X2) and A_R3 and (not CD_X2)  # X2: cancelling
        N_X_X3 = (X_X3 or CAN_X3) and A_R4 and (not CD_X3)  # X3: cancelling
        N_X_X4 = (X_X4 or CAN_X4) and (A_R5 or A_R6) and (not CD_X4)  # X4: cancelling
        N_X_X5 = (X_X5 or CAN_X5) and A_R7 and (not CD_X5)  # X5: cancelling
        N_X_X6 = (X_X6 or CAN_X6) and A_R8 and (not CD_X6)  # X6: cancelling
        N_X_X7 = (X_X7 or CAN_X7) and A_R9 and (not CD_X7)  # X7: cancelling
        N_N_R2 = (N_R2 or (VOY == 1)) and (not G_R2) and (not CAN_X1)  # route X1-X5 is noted
        N_T_R2 = T_R9  # it is the turn of route X1-X5
        N_N_R3 = (N_R3 or (VOY == 2)) and (not G_R3) and (not CAN_X2)  # route X2-W is noted
        N_T_R3 = T_R2  # it is the turn of route X2-W
        N_N_R5 = (N_R5 or (VOY == 2)) and (not G_R5) and (not CAN_X4)  # route X4-X2 is noted
        N_T_R5 = T_R3  # it is the turn of route X4-X2
        N_N_R7 = (N_R7 or (VOY == 1)) and (not G_R7) and (not CAN_X5)  # route X5-E is noted
        N_T_R7 = T_R5  # it is the turn of route X5-E
        N_N_R9 = (N_R9 or (VOY == 1)) and (not G_R9) and (not CAN_X7)  # route X7-X1 is noted
        N_T_R9 = T_R7  # it is the turn of route X7-X1
        N_K_q1 = K_q1 and (not RLS_q1)  # q1: restart lock (R16)
        N_L_q1_1 = (L_q1_1 or GW_q1_1) and (not RLS_q1)  # q1 locked from W to q1|q2@P1.toe
        N_L_q1_2 = (L_q1_2 or GW_q1_2) and (not RLS_q1)  # q1 locked from q1|q2@P1.toe to W
        N_F_q1 = (F_q1 or LK_R9 or LK_R3 or LK_R8) and (not RLS_q1)  # q1 firmly locked
        N_U_q1 = (U_q1 or NU_q1_1 or NU_q1_2) and (not RLS_q1)  # q1 used by a train (R9)
        N_P_q1 = (P_q1 or (U_q1 and OCC_q1 and NU_q2_1)) and (not RLS_q1)  # q1: the train went on (R9)
        N_D_q1 = (D_q1 or ((not VALID) and (L_q1_1 or L_q1_2))) and (not RLS_q1)  # q1: detection is not relied on, inputs were lost or a train is called on
        N_K_q10 = K_q10 and (not RLS_q10)  # q10: restart lock (R16)
        N_L_q10_1 = (L_q10_1 or GW_q10_1) and (not RLS_q10)  # q10 locked from q10|q11@P2.reverse to q10|q8@even.2
        N_L_q10_2 = (L_q10_2 or GW_q10_2) and (not RLS_q10)  # q10 locked from q10|q8@even.2 to q10|q11@P2.reverse
        N_F_q10 = (F_q10 or LK_R6 or LK_R7) and (not RLS_q10)  # q10 firmly locked
        N_U_q10 = (U_q10 or NU_q10_1 or NU_q10_2) and (not RLS_q10)  # q10 used by a train (R9)
        N_P_q10 = (P_q10 or (U_q10 and OCC_q10 and (NU_q11_2 or NU_q8_1))) and (not RLS_q10)  # q10: the train went on (R9)
        N_D_q10 = (D_q10 or ((not VALID) and (L_q10_1 or L_q10_2))) and (not RLS_q10)  # q10: detection is not relied on, inputs were lost or a train is called on
        N_K_q11 = K_q11 and (not RLS_q11)  # q11: restart lock (R16)
        N_L_q11_1 = (L_q11_1 or GW_q11_1) and (not RLS_q11)  # q11 locked from E to q10|q11@P2.reverse
        N_L_q11_2 = (L_q11_2 or GW_q11_2) and (not RLS_q11)  # q11 locked from E to q11|q9@P2.normal
        N_L_q11_3 = (L_q11_3 or GW_q11_3) and (not RLS_q11)  # q11 locked from q10|q11@P2.reverse to E
        N_L_q11_4 = (L_q11_4 or GW_q11_4) and (not RLS_q11)  # q11 locked from q11|q9@P2.normal to E
        N_F_q11 = (F_q11 or LK_R6 or LK_R5 or LK_R7 or LK_R4) and (not RLS_q11)  # q11 firmly locked
        N_U_q11 = (U_q11 or NU_q11_1 or NU_q11_2 or NU_q11_3) and (not RLS_q11)  # q11 used by a train (R9)
        N_P_q11 = (P_q11 or (U_q11 and OCC_q11 and (NU_q10_1 or NU_q9_1))) and (not RLS_q11)  # q11: the train went on (R9)
        N_D_q11 = (D_q11 or ((not VALID) and (L_q11_1 or L_q11_2 or L_q11_3 or L_q11_4))) and (not RLS_q11)  # q11: detection is not relied on, inputs were lost or a train is called on
        N_K_q2 = K_q2 and (not RLS_q2)  # q2: restart lock (R16)
        N_L_q2_1 = (L_q2_1 or GW_q2_1) and (not RLS_q2)  # q2 locked from q1|q2@P1.toe to q2|q3@P1.normal
        N_L_q2_2 = (L_q2_2 or GW_q2_2) and (not RLS_q2)  # q2 locked from q1|q2@P1.toe to q2|q4@P1.reverse
        N_L_q2_3 = (L_q2_3 or GW_q2_3) and (not RLS_q2)  # q2 locked from q2|q3@P1.normal to q1|q2@P1.toe
        N_L_q2_4 = (L_q2_4 or GW_q2_4) and (not RLS_q2)  # q2 locked from q2|q4@P1.reverse to q1|q2@P1.toe
        N_F_q2 = (F_q2 or LK_R1 or LK_R2 or LK_R3 or LK_R8) and (not RLS_q2)  # q2 firmly locked
        N_U_q2 = (U_q2 or NU_q2_1 or NU_q2_2 or NU_q2_3) and (not RLS_q2)  # q2 used by a train (R9)
        N_P_q2 = (P_q2 or (U_q2 and OCC_q2 and (NU_q1_2 or NU_q3_1 or NU_q4_1))) and (not RLS_q2)  # q2: the train went on (R9)
        N_D_q2 = (D_q2 or ((not VALID) and (L_q2_1 or L_q2_2 or L_q2_3 or L_q2_4))) and (not RLS_q2)  # q2: detection is not relied on, inputs were lost or a train is called on
        N_K_q3 = K_q3 and (not RLS_q3)  # q3: restart lock (R16)
        N_L_q3_1 = (L_q3_1 or GW_q3_1) and (not RLS_q3)  # q3 locked from q2|q3@P1.normal to q3|q5@odd.0
        N_L_q3_2 = (L_q3_2 or GW_q3_2) and (not RLS_q3)  # q3 locked from q3|q5@odd.0 to q2|q3@P1.normal
        N_F_q3 = (F_q3 or LK_R1 or LK_R3) and (not RLS_q3)  # q3 firmly locked
        N_U_q3 = (U_q3 or NU_q3_1 or NU_q3_2) and (not RLS_q3)  # q3 used by a train (R9)
        N_P_q3 = (P_q3 or (U_q3 and OCC_q3 and (NU_q2_2 or NU_q5_1))) and (not RLS_q3)  # q3: the train went on (R9)
        N_D_q3 = (D_q3 or ((not VALID) and (L_q3_1 or L_q3_2))) and (not RLS_q3)  # q3: detection is not relied on, inputs were lost or a train is called on
        N_K_q4 = K_q4 and (not RLS_q4)  # q4: restart lock (R16)
        N_L_q4_1 = (L_q4_1 or GW_q4_1) and (not RLS_q4)  # q4 locked from q2|q4@P1.reverse to q4|q6@even.0
        N_L_q4_2 = (L_q4_2 or GW_q4_2) and (not RLS_q4)  # q4 locked from q4|q6@even.0 to q2|q4@P1.reverse
        N_F_q4 = (F_q4 or LK_R2 or LK_R8) and (not RLS_q4)  # q4 firmly locked
        N_U_q4 = (U_q4 or NU_q4_1 or NU_q4_2) and (not RLS_q4)  # q4 used by a train (R9)
        N_P_q4 = (P_q4 or (U_q4 and OCC_q4 and (NU_q2_3 or NU_q6_1))) and (not RLS_q4)  # q4: the train went on (R9)
        N_D_q4 = (D_q4 or ((not VALID) and (L_q4_1 or L_q4_2))) and (not RLS_q4)  # q4: detection is not relied on, inputs were lost or a train is called on
        N_K_q5 = K_q5 and (not RLS_q5)  # q5: restart lock (R16)
        N_L_q5_1 = (L_q5_1 or GW_q5_1) and (not RLS_q5)  # q5 locked from q3|q5@odd.0 to q5|q7@odd.1
        N_L_q5_2 = (L_q5_2 or GW_q5_2) and (not RLS_q5)  # q5 locked from q5|q7@odd.1 to q3|q5@odd.0
        N_F_q5 = (F_q5 or LK_R4 or LK_R5) and (not RLS_q5)  # q5 firmly locked
        N_U_q5 = (U_q5 or NU_q5_1 or NU_q5_2) and (not RLS_q5)  # q5 used by a train (R9)
        N_P_q5 = (P_q5 or (U_q5 and OCC_q5 and (NU_q3_2 or NU_q7_1))) and (not RLS_q5)  # q5: the train went on (R9)
        N_D_q5 = (D_q5 or ((not VALID) and (L_q5_1 or L_q5_2))) and (not RLS_q5)  # q5: detection is not relied on, inputs were lost or a train is called on
        N_K_q6 = K_q6 and (not RLS_q6)  # q6: restart lock (R16)
        N_L_q6_1 = (L_q6_1 or GW_q6_1) and (not RLS_q6)  # q6 locked from q4|q6@even.0 to q6|q8@even.1
        N_L_q6_2 = (L_q6_2 or GW_q6_2) and (not RLS_q6)  # q6 locked from q6|q8@even.1 to q4|q6@even.0
        N_F_q6 = (F_q6 or LK_R7 or LK_R8) and (not RLS_q6)  # q6 firmly locked
        N_U_q6 = (U_q6 or NU_q6_1 or NU_q6_2) and (not RLS_q6)  # q6 used by a train (R9)
        N_P_q6 = (P_q6 or (U_q6 and OCC_q6 and (NU_q4_2 or NU_q8_2))) and (not RLS_q6)  # q6: the train went on (R9)
        N_D_q6 = (D_q6 or ((not VALID) and (L_q6_1 or L_q6_2))) and (not RLS_q6)  # q6: detection is not relied on, inputs were lost or a train is called on
        N_K_q7 = K_q7 and (not RLS_q7)  # q7: restart lock (R16)
        N_L_q7_1 = (L_q7_1 or GW_q7_1) and (not RLS_q7)  # q7 locked from q5|q7@odd.1 to q7|q9@odd.2
        N_L_q7_2 = (L_q7_2 or GW_q7_2) and (not RLS_q7)  # q7 locked from q7|q9@odd.2 to q5|q7@odd.1
        N_F_q7 = (F_q7 or LK_R4 or LK_R5) and (not RLS_q7)  # q7 firmly locked
        N_U_q7 = (U_q7 or NU_q7_1 or NU_q7_2) and (not RLS_q7)  # q7 used by a train (R9)
        N_P_q7 = (P_q7 or (U_q7 and OCC_q7 and (NU_q5_2 or NU_q9_2))) and (not RLS_q7)  # q7: the train went on (R9)
        N_D_q7 = (D_q7 or ((not VALID) and (L_q7_1 or L_q7_2))) and (not RLS_q7)  # q7: detection is not relied on, inputs were lost or a train is called on
        N_K_q8 = K_q8 and (not RLS_q8)  # q8: restart lock (R16)
        N_L_q8_1 = (L_q8_1 or GW_q8_1) and (not RLS_q8)  # q8 locked from q10|q8@even.2 to q6|q8@even.1
        N_L_q8_2 = (L_q8_2 or GW_q8_2) and (not RLS_q8)  # q8 locked from q6|q8@even.1 to q10|q8@even.2
        N_F_q8 = (F_q8 or LK_R8 or LK_R7) and (not RLS_q8)  # q8 firmly locked
        N_U_q8 = (U_q8 or NU_q8_1 or NU_q8_2) and (not RLS_q8)  # q8 used by a train (R9)
        N_P_q8 = (P_q8 or (U_q8 and OCC_q8 and (NU_q10_2 or NU_q6_2))) and (not RLS_q8)  # q8: the train went on (R9)
        N_D_q8 = (D_q8 or ((not VALID) and (L_q8_1 or L_q8_2))) and (not RLS_q8)  # q8: detection is not relied on, inputs were lost or a train is called on
        N_K_q9 = K_q9 and (not RLS_q9)  # q9: restart lock (R16)
        N_L_q9_1 = (L_q9_1 or GW_q9_1) and (not RLS_q9)  # q9 locked from q11|q9@P2.normal to q7|q9@odd.2
        N_L_q9_2 = (L_q9_2 or GW_q9_2) and (not RLS_q9)  # q9 locked from q7|q9@odd.2 to q11|q9@P2.normal
        N_F_q9 = (F_q9 or LK_R5 or LK_R4) and (not RLS_q9)  # q9 firmly locked
        N_U_q9 = (U_q9 or NU_q9_1 or NU_q9_2) and (not RLS_q9)  # q9 used by a train (R9)
        N_P_q9 = (P_q9 or (U_q9 and OCC_q9 and (NU_q11_3 or NU_q7_2))) and (not RLS_q9)  # q9: the train went on (R9)
        N_D_q9 = (D_q9 or ((not VALID) and (L_q9_1 or L_q9_2))) and (not RLS_q9)  # q9: detection is not relied on, inputs were lost or a train is called on
        self.state = {
            'CN_P1': bool(N_CN_P1),
            'CR_P1': bool(N_CR_P1),
            'CN_P2': bool(N_CN_P2),
            'CR_P2': bool(N_CR_P2),
            'AL_P1': bool(N_AL_P1),
            'AL_P2': bool(N_AL_P2),
            'TH_P1': bool(N_TH_P1),
            'TR_P1': bool(N_TR_P1),
            'TH_P2': bool(N_TH_P2),
            'TR_P2': bool(N_TR_P2),
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
            'X_X1': bool(N_X_X1),
            'X_X2': bool(N_X_X2),
            'X_X3': bool(N_X_X3),
            'X_X4': bool(N_X_X4),
            'X_X5': bool(N_X_X5),
            'X_X6': bool(N_X_X6),
            'X_X7': bool(N_X_X7),
            'N_R2': bool(N_N_R2),
            'T_R2': bool(N_T_R2),
            'N_R3': bool(N_N_R3),
            'T_R3': bool(N_T_R3),
            'N_R5': bool(N_N_R5),
            'T_R5': bool(N_T_R5),
            'N_R7': bool(N_N_R7),
            'T_R7': bool(N_T_R7),
            'N_R9': bool(N_N_R9),
            'T_R9': bool(N_T_R9),
            'K_q1': bool(N_K_q1),
            'L_q1_1': bool(N_L_q1_1),
            'L_q1_2': bool(N_L_q1_2),
            'F_q1': bool(N_F_q1),
            'U_q1': bool(N_U_q1),
            'P_q1': bool(N_P_q1),
            'D_q1': bool(N_D_q1),
            'K_q10': bool(N_K_q10),
            'L_q10_1': bool(N_L_q10_1),
            'L_q10_2': bool(N_L_q10_2),
            'F_q10': bool(N_F_q10),
            'U_q10': bool(N_U_q10),
            'P_q10': bool(N_P_q10),
            'D_q10': bool(N_D_q10),
            'K_q11': bool(N_K_q11),
            'L_q11_1': bool(N_L_q11_1),
            'L_q11_2': bool(N_L_q11_2),
            'L_q11_3': bool(N_L_q11_3),
            'L_q11_4': bool(N_L_q11_4),
            'F_q11': bool(N_F_q11),
            'U_q11': bool(N_U_q11),
            'P_q11': bool(N_P_q11),
            'D_q11': bool(N_D_q11),
            'K_q2': bool(N_K_q2),
            'L_q2_1': bool(N_L_q2_1),
            'L_q2_2': bool(N_L_q2_2),
            'L_q2_3': bool(N_L_q2_3),
            'L_q2_4': bool(N_L_q2_4),
            'F_q2': bool(N_F_q2),
            'U_q2': bool(N_U_q2),
            'P_q2': bool(N_P_q2),
            'D_q2': bool(N_D_q2),
            'K_q3': bool(N_K_q3),
            'L_q3_1': bool(N_L_q3_1),
            'L_q3_2': bool(N_L_q3_2),
            'F_q3': bool(N_F_q3),
            'U_q3': bool(N_U_q3),
            'P_q3': bool(N_P_q3),
            'D_q3': bool(N_D_q3),
            'K_q4': bool(N_K_q4),
            'L_q4_1': bool(N_L_q4_1),
            'L_q4_2': bool(N_L_q4_2),
            'F_q4': bool(N_F_q4),
            'U_q4': bool(N_U_q4),
            'P_q4': bool(N_P_q4),
            'D_q4': bool(N_D_q4),
            'K_q5': bool(N_K_q5),
            'L_q5_1': bool(N_L_q5_1),
            'L_q5_2': bool(N_L_q5_2),
            'F_q5': bool(N_F_q5),
            'U_q5': bool(N_U_q5),
            'P_q5': bool(N_P_q5),
            'D_q5': bool(N_D_q5),
            'K_q6': bool(N_K_q6),
            'L_q6_1': bool(N_L_q6_1),
            'L_q6_2': bool(N_L_q6_2),
            'F_q6': bool(N_F_q6),
            'U_q6': bool(N_U_q6),
            'P_q6': bool(N_P_q6),
            'D_q6': bool(N_D_q6),
            'K_q7': bool(N_K_q7),
            'L_q7_1': bool(N_L_q7_1),
            'L_q7_2': bool(N_L_q7_2),
            'F_q7': bool(N_F_q7),
            'U_q7': bool(N_U_q7),
            'P_q7': bool(N_P_q7),
            'D_q7': bool(N_D_q7),
            'K_q8': bool(N_K_q8),
            'L_q8_1': bool(N_L_q8_1),
            'L_q8_2': bool(N_L_q8_2),
            'F_q8': bool(N_F_q8),
            'U_q8': bool(N_U_q8),
            'P_q8': bool(N_P_q8),
            'D_q8': bool(N_D_q8),
            'K_q9': bool(N_K_q9),
            'L_q9_1': bool(N_L_q9_1),
            'L_q9_2': bool(N_L_q9_2),
            'F_q9': bool(N_F_q9),
            'U_q9': bool(N_U_q9),
            'P_q9': bool(N_P_q9),
            'D_q9': bool(N_D_q9),
        }
        CN_P1 = self.state['CN_P1']
        CR_P1 = self.state['CR_P1']
        CN_P2 = self.state['CN_P2']
        CR_P2 = self.state['CR_P2']
        AL_P1 = self.state['AL_P1']
        AL_P2 = self.state['AL_P2']
        TH_P1 = self.state['TH_P1']
        TR_P1 = self.state['TR_P1']
        TH_P2 = self.state['TH_P2']
        TR_P2 = self.state['TR_P2']
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
        X_X1 = self.state['X_X1']
        X_X2 = self.state['X_X2']
        X_X3 = self.state['X_X3']
        X_X4 = self.state['X_X4']
        X_X5 = self.state['X_X5']
        X_X6 = self.state['X_X6']
        X_X7 = self.state['X_X7']
        N_R2 = self.state['N_R2']
        T_R2 = self.state['T_R2']
        N_R3 = self.state['N_R3']
        T_R3 = self.state['T_R3']
        N_R5 = self.state['N_R5']
        T_R5 = self.state['T_R5']
        N_R7 = self.state['N_R7']
        T_R7 = self.state['T_R7']
        N_R9 = self.state['N_R9']
        T_R9 = self.state['T_R9']
        K_q1 = self.state['K_q1']
        L_q1_1 = self.state['L_q1_1']
        L_q1_2 = self.state['L_q1_2']
        F_q1 = self.state['F_q1']
        U_q1 = self.state['U_q1']
        P_q1 = self.state['P_q1']
        D_q1 = self.state['D_q1']
        K_q10 = self.state['K_q10']
        L_q10_1 = self.state['L_q10_1']
        L_q10_2 = self.state['L_q10_2']
        F_q10 = self.state['F_q10']
        U_q10 = self.state['U_q10']
        P_q10 = self.state['P_q10']
        D_q10 = self.state['D_q10']
        K_q11 = self.state['K_q11']
        L_q11_1 = self.state['L_q11_1']
        L_q11_2 = self.state['L_q11_2']
        L_q11_3 = self.state['L_q11_3']
        L_q11_4 = self.state['L_q11_4']
        F_q11 = self.state['F_q11']
        U_q11 = self.state['U_q11']
        P_q11 = self.state['P_q11']
        D_q11 = self.state['D_q11']
        K_q2 = self.state['K_q2']
        L_q2_1 = self.state['L_q2_1']
        L_q2_2 = self.state['L_q2_2']
        L_q2_3 = self.state['L_q2_3']
        L_q2_4 = self.state['L_q2_4']
        F_q2 = self.state['F_q2']
        U_q2 = self.state['U_q2']
        P_q2 = self.state['P_q2']
        D_q2 = self.state['D_q2']
        K_q3 = self.state['K_q3']
        L_q3_1 = self.state['L_q3_1']
        L_q3_2 = self.state['L_q3_2']
        F_q3 = self.state['F_q3']
        U_q3 = self.state['U_q3']
        P_q3 = self.state['P_q3']
        D_q3 = self.state['D_q3']
        K_q4 = self.state['K_q4']
        L_q4_1 = self.state['L_q4_1']
        L_q4_2 = self.state['L_q4_2']
        F_q4 = self.state['F_q4']
        U_q4 = self.state['U_q4']
        P_q4 = self.state['P_q4']
        D_q4 = self.state['D_q4']
        K_q5 = self.state['K_q5']
        L_q5_1 = self.state['L_q5_1']
        L_q5_2 = self.state['L_q5_2']
        F_q5 = self.state['F_q5']
        U_q5 = self.state['U_q5']
        P_q5 = self.state['P_q5']
        D_q5 = self.state['D_q5']
        K_q6 = self.state['K_q6']
        L_q6_1 = self.state['L_q6_1']
        L_q6_2 = self.state['L_q6_2']
        F_q6 = self.state['F_q6']
        U_q6 = self.state['U_q6']
        P_q6 = self.state['P_q6']
        D_q6 = self.state['D_q6']
        K_q7 = self.state['K_q7']
        L_q7_1 = self.state['L_q7_1']
        L_q7_2 = self.state['L_q7_2']
        F_q7 = self.state['F_q7']
        U_q7 = self.state['U_q7']
        P_q7 = self.state['P_q7']
        D_q7 = self.state['D_q7']
        K_q8 = self.state['K_q8']
        L_q8_1 = self.state['L_q8_1']
        L_q8_2 = self.state['L_q8_2']
        F_q8 = self.state['F_q8']
        U_q8 = self.state['U_q8']
        P_q8 = self.state['P_q8']
        D_q8 = self.state['D_q8']
        K_q9 = self.state['K_q9']
        L_q9_1 = self.state['L_q9_1']
        L_q9_2 = self.state['L_q9_2']
        F_q9 = self.state['F_q9']
        U_q9 = self.state['U_q9']
        P_q9 = self.state['P_q9']
        D_q9 = self.state['D_q9']
        return {
            'YN_P1': bool(CN_P1),
            'YR_P1': bool(CR_P1),
            'YN_P2': bool(CN_P2),
            'YR_P2': bool(CR_P2),
            'YA_P1': bool(AL_P1),
            'YA_P2': bool(AL_P2),
            'YT_P1': bool(TR_P1),
            'YT_P2': bool(TR_P2),
            'YL_q1': bool(K_q1 or L_q1_1 or L_q1_2),
            'YL_q10': bool(K_q10 or L_q10_1 or L_q10_2),
            'YL_q11': bool(K_q11 or L_q11_1 or L_q11_2 or L_q11_3 or L_q11_4),
            'YL_q2': bool(K_q2 or L_q2_1 or L_q2_2 or L_q2_3 or L_q2_4),
            'YL_q3': bool(K_q3 or L_q3_1 or L_q3_2),
            'YL_q4': bool(K_q4 or L_q4_1 or L_q4_2),
            'YL_q5': bool(K_q5 or L_q5_1 or L_q5_2),
            'YL_q6': bool(K_q6 or L_q6_1 or L_q6_2),
            'YL_q7': bool(K_q7 or L_q7_1 or L_q7_2),
            'YL_q8': bool(K_q8 or L_q8_1 or L_q8_2),
            'YL_q9': bool(K_q9 or L_q9_1 or L_q9_2),
            'YP_X1': bool(S_R1 or S_R2),
            'YS_X1': bool((not (S_R1 or S_R2))),
            'YP_X2': bool(S_R3),
            'YS_X2': bool((not S_R3)),
            'YP_X3': bool(S_R4),
            'YS_X3': bool((not S_R4)),
            'YP_X4': bool(S_R5 or S_R6),
            'YS_X4': bool((not (S_R5 or S_R6))),
            'YP_X5': bool(S_R7),
            'YS_X5': bool((not S_R7)),
            'YP_X6': bool(S_R8),
            'YS_X6': bool((not S_R8)),
            'YP_X7': bool(S_R9),
            'YS_X7': bool((not S_R9)),
        }
