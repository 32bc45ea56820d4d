# Interlocking flank_lab, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout ac60195d1b90ba982d3a9576c321210e45e0af52550bab70e55ca0a8dd2a6d7c
# claims 5c6b8e632397514d58b0bf3a3c8e391f9dc9842b4b9685abc50d681f5fe910b7
"""Interlocking flank_lab: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_F': (0, 2),  # operator: cancel the route from F
    'CAN_L5': (0, 2),  # operator: cancel the route from L5
    'CAN_N2': (0, 2),  # operator: cancel the route from N2
    'CAN_N8': (0, 2),  # operator: cancel the route from N8
    'CAN_S1': (0, 2),  # operator: cancel the route from S1
    'CAN_SA': (0, 2),  # operator: cancel the route from SA
    'RL_F': (0, 2),  # stop lamp of F intact
    'RL_L5': (0, 2),  # stop lamp of L5 intact
    'RL_N2': (0, 2),  # stop lamp of N2 intact
    'RL_N8': (0, 2),  # stop lamp of N8 intact
    'RL_S1': (0, 2),  # stop lamp of S1 intact
    'RL_SA': (0, 2),  # stop lamp of SA intact
    'GL_F': (0, 2),  # clear lamp of F intact, or not lit
    'CL_F': (0, 2),  # caution lamp of F intact, or not lit
    'GL_N2': (0, 2),  # clear lamp of N2 intact, or not lit
    'CL_N2': (0, 2),  # caution lamp of N2 intact, or not lit
    'GL_N8': (0, 2),  # clear lamp of N8 intact, or not lit
    'CL_N8': (0, 2),  # caution lamp of N8 intact, or not lit
    'GL_S1': (0, 2),  # clear lamp of S1 intact, or not lit
    'CL_S1': (0, 2),  # caution lamp of S1 intact, or not lit
    'GL_SA': (0, 2),  # clear lamp of SA intact, or not lit
    'CL_SA': (0, 2),  # caution lamp of SA intact, or not lit
    'REQ': (0, 12),  # operator: set route number, 0 = none; 11 = swing the overlap of F
    'CLR_g2': (0, 2),  # section g2 reported clear
    'CLR_g4': (0, 2),  # section g4 reported clear
    'CLR_g5': (0, 2),  # section g5 reported clear
    'CLR_g6': (0, 2),  # section g6 reported clear
    'CLR_g8': (0, 2),  # section g8 reported clear
    'CLR_ga': (0, 2),  # section ga reported clear
    'CLR_gb': (0, 2),  # section gb reported clear
    'CLR_sid': (0, 2),  # section sid reported clear
    'CLR_w0': (0, 2),  # section w0 reported clear
    'CLR_w1': (0, 2),  # section w1 reported clear
    'CLR_w2': (0, 2),  # section w2 reported clear
    'CLR_w5': (0, 2),  # section w5 reported clear
    'CLR_w6': (0, 2),  # section w6 reported clear
    'REL_g2': (0, 2),  # operator: release section g2 (hold until released)
    'REL_g4': (0, 2),  # operator: release section g4 (hold until released)
    'REL_g5': (0, 2),  # operator: release section g5 (hold until released)
    'REL_g6': (0, 2),  # operator: release section g6 (hold until released)
    'REL_g8': (0, 2),  # operator: release section g8 (hold until released)
    'REL_sid': (0, 2),  # operator: release section sid (hold until released)
    'REL_w0': (0, 2),  # operator: release section w0 (hold until released)
    'REL_w1': (0, 2),  # operator: release section w1 (hold until released)
    'REL_w2': (0, 2),  # operator: release section w2 (hold until released)
    'REL_w5': (0, 2),  # operator: release section w5 (hold until released)
    'REL_w6': (0, 2),  # operator: release section w6 (hold until released)
    'BLK_g2': (1, 2),  # operator: section g2 is blocked
    'BLK_g4': (1, 2),  # operator: section g4 is blocked
    'BLK_g5': (1, 2),  # operator: section g5 is blocked
    'BLK_g6': (1, 2),  # operator: section g6 is blocked
    'BLK_g8': (1, 2),  # operator: section g8 is blocked
    'BLK_w0': (1, 2),  # operator: section w0 is blocked
    'BLK_w1': (1, 2),  # operator: section w1 is blocked
    'BLK_w2': (1, 2),  # operator: section w2 is blocked
    'BLK_w5': (1, 2),  # operator: section w5 is blocked
    'BLK_w6': (1, 2),  # operator: section w6 is blocked
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
    'DN_5': (0, 2),  # machine 5 detected normal
    'DR_5': (0, 2),  # machine 5 detected reverse
    'MN_5': (0, 2),  # operator: move machine 5 normal
    'MR_5': (0, 2),  # operator: move machine 5 reverse
    'TC_5': (0, 2),  # operator: machine 5 has been looked at after it was trailed
    'DN_6': (0, 2),  # machine 6 detected normal
    'DR_6': (0, 2),  # machine 6 detected reverse
    'MN_6': (0, 2),  # operator: move machine 6 normal
    'MR_6': (0, 2),  # operator: move machine 6 reverse
    'TC_6': (0, 2),  # operator: machine 6 has been looked at after it was trailed
    'DN_Gs1': (0, 2),  # machine Gs1 detected on
    'DR_Gs1': (0, 2),  # machine Gs1 detected off
    'MN_Gs1': (0, 2),  # operator: move machine Gs1 on
    'MR_Gs1': (0, 2),  # operator: move machine Gs1 off
    'TC_Gs1': (0, 2),  # operator: machine Gs1 has been looked at after it was trailed
    'DN_LC1': (0, 2),  # machine LC1 detected open
    'DR_LC1': (0, 2),  # machine LC1 detected closed
    'MN_LC1': (0, 2),  # operator: move machine LC1 open
    'MR_LC1': (0, 2),  # operator: move machine LC1 closed
}
# name: value at a restart, meaning
STATE = {
    'CN_1': False,  # machine 1 commanded N
    'CR_1': False,  # machine 1 commanded R
    'CN_2': False,  # machine 2 commanded N
    'CR_2': False,  # machine 2 commanded R
    'CN_5': False,  # machine 5 commanded N
    'CR_5': False,  # machine 5 commanded R
    'CN_6': False,  # machine 6 commanded N
    'CR_6': False,  # machine 6 commanded R
    'CN_Gs1': False,  # machine Gs1 commanded N
    'CR_Gs1': False,  # machine Gs1 commanded R
    'CN_LC1': False,  # machine LC1 commanded N
    'CR_LC1': False,  # machine LC1 commanded R
    'AL_1': False,  # alarm: machine 1 not detected
    'AL_2': False,  # alarm: machine 2 not detected
    'AL_5': False,  # alarm: machine 5 not detected
    'AL_6': False,  # alarm: machine 6 not detected
    'AL_Gs1': False,  # alarm: machine Gs1 not detected
    'AL_LC1': False,  # alarm: machine LC1 not detected
    'TH_1': False,  # machine 1 was detected where it is commanded
    'TR_1': False,  # machine 1 was trailed
    'TH_2': False,  # machine 2 was detected where it is commanded
    'TR_2': False,  # machine 2 was trailed
    'TH_5': False,  # machine 5 was detected where it is commanded
    'TR_5': False,  # machine 5 was trailed
    'TH_6': False,  # machine 6 was detected where it is commanded
    'TR_6': False,  # machine 6 was trailed
    'TH_Gs1': False,  # machine Gs1 was detected where it is commanded
    'TR_Gs1': False,  # machine Gs1 was trailed
    'A_R1': False,  # route F-B active
    'B_R1': False,  # route F-B locked
    'W_R1': False,  # route F-B: proceed wanted
    'S_R1': False,  # route F-B: proceed
    'H_R1': False,  # route F-B: signal has been open
    'A_R2': False,  # route L5-N8 active
    'B_R2': False,  # route L5-N8 locked
    'W_R2': False,  # route L5-N8: proceed wanted
    'S_R2': False,  # route L5-N8: proceed
    'H_R2': False,  # route L5-N8: signal has been open
    'A_R3': False,  # route N2-F active
    'B_R3': False,  # route N2-F locked
    'W_R3': False,  # route N2-F: proceed wanted
    'S_R3': False,  # route N2-F: proceed
    'H_R3': False,  # route N2-F: signal has been open
    'A_R4': False,  # route N2-F.o2 active
    'B_R4': False,  # route N2-F.o2 locked
    'W_R4': False,  # route N2-F.o2: proceed wanted
    'S_R4': False,  # route N2-F.o2: proceed
    'H_R4': False,  # route N2-F.o2: signal has been open
    'A_R5': False,  # route N8-F active
    'B_R5': False,  # route N8-F locked
    'W_R5': False,  # route N8-F: proceed wanted
    'S_R5': False,  # route N8-F: proceed
    'H_R5': False,  # route N8-F: signal has been open
    'A_R6': False,  # route N8-F.o2 active
    'B_R6': False,  # route N8-F.o2 locked
    'W_R6': False,  # route N8-F.o2: proceed wanted
    'S_R6': False,  # route N8-F.o2: proceed
    'H_R6': False,  # route N8-F.o2: signal has been open
    'A_R7': False,  # route S1-N2 active
    'B_R7': False,  # route S1-N2 locked
    'W_R7': False,  # route S1-N2: proceed wanted
    'S_R7': False,  # route S1-N2: proceed
    'H_R7': False,  # route S1-N2: signal has been open
    'A_R8': False,  # route S1-N8 active
    'B_R8': False,  # route S1-N8 locked
    'W_R8': False,  # route S1-N8: proceed wanted
    'S_R8': False,  # route S1-N8: proceed
    'H_R8': False,  # route S1-N8: signal has been open
    'A_R9': False,  # route SA-S1 active
    'B_R9': False,  # route SA-S1 locked
    'W_R9': False,  # route SA-S1: proceed wanted
    'S_R9': False,  # route SA-S1: proceed
    'H_R9': False,  # route SA-S1: signal has been open
    'A_R10': False,  # route SA-S1.o2 active
    'B_R10': False,  # route SA-S1.o2 locked
    'W_R10': False,  # route SA-S1.o2: proceed wanted
    'S_R10': False,  # route SA-S1.o2: proceed
    'H_R10': False,  # route SA-S1.o2: signal has been open
    'X_F': False,  # F: cancelling
    'X_L5': False,  # L5: cancelling
    'X_N2': False,  # N2: cancelling
    'X_N8': False,  # N8: cancelling
    'X_S1': False,  # S1: cancelling
    'X_SA': False,  # SA: cancelling
    'K_g2': True,  # g2: restart lock (R16)
    'L_g2_1': False,  # g2 locked from g2|w1@1.normal to g2|w2@2.normal
    'M_g2': False,  # g2 locked for a train movement
    'F_g2': False,  # g2 firmly locked
    'U_g2': True,  # g2 used by a train (R9)
    'P_g2': False,  # g2: the train went on (R9)
    'D_g2': False,  # g2: detection is not relied on, inputs were lost or a train is called on
    'K_g4': True,  # g4: restart lock (R16)
    'L_g4_1': False,  # g4 locked from g4|w2@2.toe to g4|w6@6.toe
    'M_g4': False,  # g4 locked for a train movement
    'F_g4': False,  # g4 firmly locked
    'U_g4': True,  # g4 used by a train (R9)
    'P_g4': False,  # g4: the train went on (R9)
    'D_g4': False,  # g4: detection is not relied on, inputs were lost or a train is called on
    'K_g5': True,  # g5: restart lock (R16)
    'L_g5_2': False,  # g5 locked from g5|w6@6.normal to B
    'M_g5': False,  # g5 locked for a train movement
    'F_g5': False,  # g5 firmly locked
    'U_g5': True,  # g5 used by a train (R9)
    'P_g5': False,  # g5: the train went on (R9)
    'D_g5': False,  # g5: detection is not relied on, inputs were lost or a train is called on
    'K_g6': True,  # g6: restart lock (R16)
    'L_g6_2': False,  # g6 locked from g6|w6@6.reverse to C
    'M_g6': False,  # g6 locked for a train movement
    'F_g6': False,  # g6 firmly locked
    'U_g6': True,  # g6 used by a train (R9)
    'P_g6': False,  # g6: the train went on (R9)
    'D_g6': False,  # g6: detection is not relied on, inputs were lost or a train is called on
    'K_g8': True,  # g8: restart lock (R16)
    'L_g8_2': False,  # g8 locked from g8|w5@5.toe to g8|w2@2.reverse
    'M_g8': False,  # g8 locked for a train movement
    'F_g8': False,  # g8 firmly locked
    'U_g8': True,  # g8 used by a train (R9)
    'P_g8': False,  # g8: the train went on (R9)
    'D_g8': False,  # g8: detection is not relied on, inputs were lost or a train is called on
    'K_sid': True,  # sid: restart lock (R16)
    'M_sid': False,  # sid locked for a train movement
    'F_sid': False,  # sid firmly locked
    'U_sid': True,  # sid used by a train (R9)
    'P_sid': False,  # sid: the train went on (R9)
    'D_sid': False,  # sid: detection is not relied on, inputs were lost or a train is called on
    'K_w0': True,  # w0: restart lock (R16)
    'L_w0_1': False,  # w0 locked from A to w0|w1@1.toe
    'M_w0': False,  # w0 locked for a train movement
    'F_w0': False,  # w0 firmly locked
    'U_w0': True,  # w0 used by a train (R9)
    'P_w0': False,  # w0: the train went on (R9)
    'D_w0': False,  # w0: detection is not relied on, inputs were lost or a train is called on
    'K_w1': True,  # w1: restart lock (R16)
    'L_w1_2': False,  # w1 locked from w0|w1@1.toe to g2|w1@1.normal
    'L_w1_3': False,  # w1 locked from w0|w1@1.toe to w1|w5@1.reverse
    'M_w1': False,  # w1 locked for a train movement
    'F_w1': False,  # w1 firmly locked
    'U_w1': True,  # w1 used by a train (R9)
    'P_w1': False,  # w1: the train went on (R9)
    'D_w1': False,  # w1: detection is not relied on, inputs were lost or a train is called on
    'K_w2': True,  # w2: restart lock (R16)
    'L_w2_1': False,  # w2 locked from g2|w2@2.normal to g4|w2@2.toe
    'L_w2_4': False,  # w2 locked from g8|w2@2.reverse to g4|w2@2.toe
    'M_w2': False,  # w2 locked for a train movement
    'F_w2': False,  # w2 firmly locked
    'U_w2': True,  # w2 used by a train (R9)
    'P_w2': False,  # w2: the train went on (R9)
    'D_w2': False,  # w2: detection is not relied on, inputs were lost or a train is called on
    'K_w5': True,  # w5: restart lock (R16)
    'L_w5_4': False,  # w5 locked from sid|w5@Gs1.outer to g8|w5@5.toe
    'L_w5_5': False,  # w5 locked from w1|w5@1.reverse to g8|w5@5.toe
    'M_w5': False,  # w5 locked for a train movement
    'F_w5': False,  # w5 firmly locked
    'U_w5': True,  # w5 used by a train (R9)
    'P_w5': False,  # w5: the train went on (R9)
    'D_w5': False,  # w5: detection is not relied on, inputs were lost or a train is called on
    'K_w6': True,  # w6: restart lock (R16)
    'L_w6_1': False,  # w6 locked from g4|w6@6.toe to g5|w6@6.normal
    'L_w6_2': False,  # w6 locked from g4|w6@6.toe to g6|w6@6.reverse
    'M_w6': False,  # w6 locked for a train movement
    'F_w6': False,  # w6 firmly locked
    'U_w6': True,  # w6 used by a train (R9)
    'P_w6': False,  # w6: the train went on (R9)
    'D_w6': False,  # w6: detection is not relied on, inputs were lost or a train is called on
    'V_F_1': False,  # overlap 1 of F held
    'V_F_2': False,  # overlap 2 of F held
    'V_N2_1': False,  # overlap 1 of N2 held
    'V_S1_1': False,  # overlap 1 of S1 held
    'V_S1_2': False,  # overlap 2 of S1 held
    'VF_F': False,  # overlap of F firmly held
    'VS_F': False,  # the overlap of F swings
    'VF_N2': False,  # overlap of N2 firmly held
    'VF_S1': False,  # overlap of S1 firmly held
    'C_F': False,  # F shows clear
    'C_N2': False,  # N2 shows clear
    'C_N8': False,  # N8 shows clear
    'C_S1': False,  # S1 shows clear
    'C_SA': False,  # SA shows clear
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_F': 180000,  # F: approach locking delay (R8)
    'AT_L5': 30000,  # L5: approach locking delay (R8)
    'AT_N2': 180000,  # N2: approach locking delay (R8)
    'AT_N8': 180000,  # N8: approach locking delay (R8)
    'AT_S1': 180000,  # S1: approach locking delay (R8)
    'AT_SA': 180000,  # SA: approach locking delay (R8)
    'RT_g2': 3000,  # g2: release delay (R9)
    'RT_g4': 3000,  # g4: release delay (R9)
    'RT_g5': 3000,  # g5: release delay (R9)
    'RT_g6': 3000,  # g6: release delay (R9)
    'RT_g8': 3000,  # g8: release delay (R9)
    'RT_sid': 3000,  # sid: release delay (R9)
    'RT_w0': 3000,  # w0: release delay (R9)
    'RT_w1': 3000,  # w1: release delay (R9)
    'RT_w2': 3000,  # w2: release delay (R9)
    'RT_w5': 3000,  # w5: release delay (R9)
    'RT_w6': 3000,  # w6: release delay (R9)
    'OT_F': 40000,  # F: the train before it stands (R4)
    'OT_N2': 40000,  # N2: the train before it stands (R4)
    'OT_S1': 40000,  # S1: the train before it stands (R4)
    'ST_1': 13000,  # machine 1: time-out
    'ST_2': 13000,  # machine 2: time-out
    'ST_5': 13000,  # machine 5: time-out
    'ST_6': 13000,  # machine 6: time-out
    'ST_Gs1': 13000,  # machine Gs1: time-out
    'ST_LC1': 13000,  # machine LC1: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_1': False,  # machine 1: normal
    'YR_1': False,  # machine 1: reverse
    'YN_2': False,  # machine 2: normal
    'YR_2': False,  # machine 2: reverse
    'YN_5': False,  # machine 5: normal
    'YR_5': False,  # machine 5: reverse
    'YN_6': False,  # machine 6: normal
    'YR_6': False,  # machine 6: reverse
    'YN_Gs1': False,  # machine Gs1: on
    'YR_Gs1': False,  # machine Gs1: off
    'YN_LC1': False,  # machine LC1: open
    'YR_LC1': False,  # machine LC1: closed
    'YA_1': False,  # alarm: machine 1 not detected in time
    'YA_2': False,  # alarm: machine 2 not detected in time
    'YA_5': False,  # alarm: machine 5 not detected in time
    'YA_6': False,  # alarm: machine 6 not detected in time
    'YA_Gs1': False,  # alarm: machine Gs1 not detected in time
    'YA_LC1': False,  # alarm: machine LC1 not detected in time
    'YT_1': False,  # alarm: machine 1 was trailed
    'YT_2': False,  # alarm: machine 2 was trailed
    'YT_5': False,  # alarm: machine 5 was trailed
    'YT_6': False,  # alarm: machine 6 was trailed
    'YT_Gs1': False,  # alarm: machine Gs1 was trailed
    'YL_g2': True,  # indication: g2 is locked
    'YL_g4': True,  # indication: g4 is locked
    'YL_g5': True,  # indication: g5 is locked
    'YL_g6': True,  # indication: g6 is locked
    'YL_g8': True,  # indication: g8 is locked
    'YL_sid': True,  # indication: sid is locked
    'YL_w0': True,  # indication: w0 is locked
    'YL_w1': True,  # indication: w1 is locked
    'YL_w2': True,  # indication: w2 is locked
    'YL_w5': True,  # indication: w5 is locked
    'YL_w6': True,  # indication: w6 is locked
    'YP_F': False,  # signal F: clear (green)
    'YY_F': False,  # signal F: caution (yellow)
    'YS_F': True,  # signal F: stop
    'YW_L5': False,  # signal L5: shunt (white)
    'YS_L5': True,  # signal L5: stop
    'YP_N2': False,  # signal N2: clear (green)
    'YY_N2': False,  # signal N2: caution (yellow)
    'YV80_N2': False,  # signal N2: speed indicator 80 km/h
    'YS_N2': True,  # signal N2: stop
    'YP_N8': False,  # signal N8: clear (green)
    'YY_N8': False,  # signal N8: caution (yellow)
    'YV40_N8': False,  # signal N8: speed indicator 40 km/h
    'YS_N8': True,  # signal N8: stop
    'YP_S1': False,  # signal S1: clear (green)
    'YY_S1': False,  # signal S1: caution (yellow)
    'YV40_S1': False,  # signal S1: speed indicator 40 km/h
    'YV80_S1': False,  # signal S1: speed indicator 80 km/h
    'YS_S1': True,  # signal S1: stop
    'YP_SA': False,  # signal SA: clear (green)
    'YY_SA': False,  # signal SA: caution (yellow)
    'YS_SA': True,  # signal SA: stop
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
        CAN_F = read['CAN_F']
        CAN_L5 = read['CAN_L5']
        CAN_N2 = read['CAN_N2']
        CAN_N8 = read['CAN_N8']
        CAN_S1 = read['CAN_S1']
        CAN_SA = read['CAN_SA']
        RL_F = read['RL_F']
        RL_L5 = read['RL_L5']
        RL_N2 = read['RL_N2']
        RL_N8 = read['RL_N8']
        RL_S1 = read['RL_S1']
        RL_SA = read['RL_SA']
        GL_F = read['GL_F']
        CL_F = read['CL_F']
        GL_N2 = read['GL_N2']
        CL_N2 = read['CL_N2']
        GL_N8 = read['GL_N8']
        CL_N8 = read['CL_N8']
        GL_S1 = read['GL_S1']
        CL_S1 = read['CL_S1']
        GL_SA = read['GL_SA']
        CL_SA = read['CL_SA']
        REQ = read['REQ']
        CLR_g2 = read['CLR_g2']
        CLR_g4 = read['CLR_g4']
        CLR_g5 = read['CLR_g5']
        CLR_g6 = read['CLR_g6']
        CLR_g8 = read['CLR_g8']
        CLR_ga = read['CLR_ga']
        CLR_gb = read['CLR_gb']
        CLR_sid = read['CLR_sid']
        CLR_w0 = read['CLR_w0']
        CLR_w1 = read['CLR_w1']
        CLR_w2 = read['CLR_w2']
        CLR_w5 = read['CLR_w5']
        CLR_w6 = read['CLR_w6']
        REL_g2 = read['REL_g2']
        REL_g4 = read['REL_g4']
        REL_g5 = read['REL_g5']
        REL_g6 = read['REL_g6']
        REL_g8 = read['REL_g8']
        REL_sid = read['REL_sid']
        REL_w0 = read['REL_w0']
        REL_w1 = read['REL_w1']
        REL_w2 = read['REL_w2']
        REL_w5 = read['REL_w5']
        REL_w6 = read['REL_w6']
        BLK_g2 = read['BLK_g2']
        BLK_g4 = read['BLK_g4']
        BLK_g5 = read['BLK_g5']
        BLK_g6 = read['BLK_g6']
        BLK_g8 = read['BLK_g8']
        BLK_w0 = read['BLK_w0']
        BLK_w1 = read['BLK_w1']
        BLK_w2 = read['BLK_w2']
        BLK_w5 = read['BLK_w5']
        BLK_w6 = read['BLK_w6']
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
        DN_5 = read['DN_5']
        DR_5 = read['DR_5']
        MN_5 = read['MN_5']
        MR_5 = read['MR_5']
        TC_5 = read['TC_5']
        DN_6 = read['DN_6']
        DR_6 = read['DR_6']
        MN_6 = read['MN_6']
        MR_6 = read['MR_6']
        TC_6 = read['TC_6']
        DN_Gs1 = read['DN_Gs1']
        DR_Gs1 = read['DR_Gs1']
        MN_Gs1 = read['MN_Gs1']
        MR_Gs1 = read['MR_Gs1']
        TC_Gs1 = read['TC_Gs1']
        DN_LC1 = read['DN_LC1']
        DR_LC1 = read['DR_LC1']
        MN_LC1 = read['MN_LC1']
        MR_LC1 = read['MR_LC1']
        CN_1 = old['CN_1']
        CR_1 = old['CR_1']
        CN_2 = old['CN_2']
        CR_2 = old['CR_2']
        CN_5 = old['CN_5']
        CR_5 = old['CR_5']
        CN_6 = old['CN_6']
        CR_6 = old['CR_6']
        CN_Gs1 = old['CN_Gs1']
        CR_Gs1 = old['CR_Gs1']
        CN_LC1 = old['CN_LC1']
        CR_LC1 = old['CR_LC1']
        AL_1 = old['AL_1']
        AL_2 = old['AL_2']
        AL_5 = old['AL_5']
        AL_6 = old['AL_6']
        AL_Gs1 = old['AL_Gs1']
        AL_LC1 = old['AL_LC1']
        TH_1 = old['TH_1']
        TR_1 = old['TR_1']
        TH_2 = old['TH_2']
        TR_2 = old['TR_2']
        TH_5 = old['TH_5']
        TR_5 = old['TR_5']
        TH_6 = old['TH_6']
        TR_6 = old['TR_6']
        TH_Gs1 = old['TH_Gs1']
        TR_Gs1 = old['TR_Gs1']
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
        X_F = old['X_F']
        X_L5 = old['X_L5']
        X_N2 = old['X_N2']
        X_N8 = old['X_N8']
        X_S1 = old['X_S1']
        X_SA = old['X_SA']
        K_g2 = old['K_g2']
        L_g2_1 = old['L_g2_1']
        M_g2 = old['M_g2']
        F_g2 = old['F_g2']
        U_g2 = old['U_g2']
        P_g2 = old['P_g2']
        D_g2 = old['D_g2']
        K_g4 = old['K_g4']
        L_g4_1 = old['L_g4_1']
        M_g4 = old['M_g4']
        F_g4 = old['F_g4']
        U_g4 = old['U_g4']
        P_g4 = old['P_g4']
        D_g4 = old['D_g4']
        K_g5 = old['K_g5']
        L_g5_2 = old['L_g5_2']
        M_g5 = old['M_g5']
        F_g5 = old['F_g5']
        U_g5 = old['U_g5']
        P_g5 = old['P_g5']
        D_g5 = old['D_g5']
        K_g6 = old['K_g6']
        L_g6_2 = old['L_g6_2']
        M_g6 = old['M_g6']
        F_g6 = old['F_g6']
        U_g6 = old['U_g6']
        P_g6 = old['P_g6']
        D_g6 = old['D_g6']
        K_g8 = old['K_g8']
        L_g8_2 = old['L_g8_2']
        M_g8 = old['M_g8']
        F_g8 = old['F_g8']
        U_g8 = old['U_g8']
        P_g8 = old['P_g8']
        D_g8 = old['D_g8']
        K_sid = old['K_sid']
        M_sid = old['M_sid']
        F_sid = old['F_sid']
        U_sid = old['U_sid']
        P_sid = old['P_sid']
        D_sid = old['D_sid']
        K_w0 = old['K_w0']
        L_w0_1 = old['L_w0_1']
        M_w0 = old['M_w0']
        F_w0 = old['F_w0']
        U_w0 = old['U_w0']
        P_w0 = old['P_w0']
        D_w0 = old['D_w0']
        K_w1 = old['K_w1']
        L_w1_2 = old['L_w1_2']
        L_w1_3 = old['L_w1_3']
        M_w1 = old['M_w1']
        F_w1 = old['F_w1']
        U_w1 = old['U_w1']
        P_w1 = old['P_w1']
        D_w1 = old['D_w1']
        K_w2 = old['K_w2']
        L_w2_1 = old['L_w2_1']
        L_w2_4 = old['L_w2_4']
        M_w2 = old['M_w2']
        F_w2 = old['F_w2']
        U_w2 = old['U_w2']
        P_w2 = old['P_w2']
        D_w2 = old['D_w2']
        K_w5 = old['K_w5']
        L_w5_4 = old['L_w5_4']
        L_w5_5 = old['L_w5_5']
        M_w5 = old['M_w5']
        F_w5 = old['F_w5']
        U_w5 = old['U_w5']
        P_w5 = old['P_w5']
        D_w5 = old['D_w5']
        K_w6 = old['K_w6']
        L_w6_1 = old['L_w6_1']
        L_w6_2 = old['L_w6_2']
        M_w6 = old['M_w6']
        F_w6 = old['F_w6']
        U_w6 = old['U_w6']
        P_w6 = old['P_w6']
        D_w6 = old['D_w6']
        V_F_1 = old['V_F_1']
        V_F_2 = old['V_F_2']
        V_N2_1 = old['V_N2_1']
        V_S1_1 = old['V_S1_1']
        V_S1_2 = old['V_S1_2']
        VF_F = old['VF_F']
        VS_F = old['VS_F']
        VF_N2 = old['VF_N2']
        VF_S1 = old['VF_S1']
        C_F = old['C_F']
        C_N2 = old['C_N2']
        C_N8 = old['C_N8']
        C_S1 = old['C_S1']
        C_SA = old['C_SA']
        OCC_g2 = (not CLR_g2) or (not VALID)  # g2 counts as occupied
        OCC_g4 = (not CLR_g4) or (not VALID)  # g4 counts as occupied
        OCC_g5 = (not CLR_g5) or (not VALID)  # g5 counts as occupied
        OCC_g6 = (not CLR_g6) or (not VALID)  # g6 counts as occupied
        OCC_g8 = (not CLR_g8) or (not VALID)  # g8 counts as occupied
        OCC_ga = (not CLR_ga) or (not VALID)  # ga counts as occupied
        OCC_gb = (not CLR_gb) or (not VALID)  # gb counts as occupied
        OCC_sid = (not CLR_sid) or (not VALID)  # sid counts as occupied
        OCC_w0 = (not CLR_w0) or (not VALID)  # w0 counts as occupied
        OCC_w1 = (not CLR_w1) or (not VALID)  # w1 counts as occupied
        OCC_w2 = (not CLR_w2) or (not VALID)  # w2 counts as occupied
        OCC_w5 = (not CLR_w5) or (not VALID)  # w5 counts as occupied
        OCC_w6 = (not CLR_w6) or (not VALID)  # w6 counts as occupied
        FREE_g2 = (not K_g2) and (not L_g2_1) and (not V_S1_1)  # g2 is not locked by anybody
        FREE_g4 = (not K_g4) and (not L_g4_1) and (not V_N2_1)  # g4 is not locked by anybody
        FREE_g5 = (not K_g5) and (not L_g5_2) and (not V_F_1)  # g5 is not locked by anybody
        FREE_g6 = (not K_g6) and (not L_g6_2) and (not V_F_2)  # g6 is not locked by anybody
        FREE_g8 = (not K_g8) and (not L_g8_2) and (not V_S1_2)  # g8 is not locked by anybody
        FREE_sid = (not K_sid)  # sid is not locked by anybody
        FREE_w0 = (not K_w0) and (not L_w0_1)  # w0 is not locked by anybody
        FREE_w1 = (not K_w1) and (not L_w1_2) and (not L_w1_3) and (not V_S1_1) and (not V_S1_2)  # w1 is not locked by anybody
        FREE_w2 = (not K_w2) and (not L_w2_1) and (not L_w2_4) and (not V_N2_1)  # w2 is not locked by anybody
        FREE_w5 = (not K_w5) and (not L_w5_4) and (not L_w5_5) and (not V_S1_2)  # w5 is not locked by anybody
        FREE_w6 = (not K_w6) and (not L_w6_1) and (not L_w6_2) and (not V_F_1) and (not V_F_2)  # w6 is not locked by anybody
        QN_1 = VALID and DN_1 and (not DR_1)  # machine 1 lies N (R10)
        QR_1 = VALID and DR_1 and (not DN_1)  # machine 1 lies R (R10)
        QN_2 = VALID and DN_2 and (not DR_2)  # machine 2 lies N (R10)
        QR_2 = VALID and DR_2 and (not DN_2)  # machine 2 lies R (R10)
        QN_5 = VALID and DN_5 and (not DR_5)  # machine 5 lies N (R10)
        QR_5 = VALID and DR_5 and (not DN_5)  # machine 5 lies R (R10)
        QN_6 = VALID and DN_6 and (not DR_6)  # machine 6 lies N (R10)
        QR_6 = VALID and DR_6 and (not DN_6)  # machine 6 lies R (R10)
        QN_Gs1 = VALID and DN_Gs1 and (not DR_Gs1)  # machine Gs1 lies N (R10)
        QR_Gs1 = VALID and DR_Gs1 and (not DN_Gs1)  # machine Gs1 lies R (R10)
        QN_LC1 = VALID and DN_LC1 and (not DR_LC1)  # machine LC1 lies N (R10)
        QR_LC1 = VALID and DR_LC1 and (not DN_LC1)  # machine LC1 lies R (R10)
        MOV_1 = VALID and FREE_w1 and (not OCC_w1) and (not L_w5_4) and True  # machine 1 is free to move (R10)
        AVN_1 = CN_1 or MOV_1 or (QN_1 and (not CN_1) and (not CR_1))  # machine 1 can be demanded N
        AVR_1 = CR_1 or MOV_1 or (QR_1 and (not CN_1) and (not CR_1))  # machine 1 can be demanded R
        MOV_2 = VALID and FREE_w2 and (not OCC_w2) and True and True  # machine 2 is free to move (R10)
        AVN_2 = CN_2 or MOV_2 or (QN_2 and (not CN_2) and (not CR_2))  # machine 2 can be demanded N
        AVR_2 = CR_2 or MOV_2 or (QR_2 and (not CN_2) and (not CR_2))  # machine 2 can be demanded R
        MOV_5 = VALID and FREE_w5 and (not OCC_w5) and True and True  # machine 5 is free to move (R10)
        AVN_5 = CN_5 or MOV_5 or (QN_5 and (not CN_5) and (not CR_5))  # machine 5 can be demanded N
        AVR_5 = CR_5 or MOV_5 or (QR_5 and (not CN_5) and (not CR_5))  # machine 5 can be demanded R
        MOV_6 = VALID and FREE_w6 and (not OCC_w6) and True and True  # machine 6 is free to move (R10)
        AVN_6 = CN_6 or MOV_6 or (QN_6 and (not CN_6) and (not CR_6))  # machine 6 can be demanded N
        AVR_6 = CR_6 or MOV_6 or (QR_6 and (not CN_6) and (not CR_6))  # machine 6 can be demanded R
        MOV_Gs1 = VALID and FREE_w5 and (not OCC_w5) and (not (L_w5_5 or V_S1_2)) and True  # machine Gs1 is free to move (R10)
        AVN_Gs1 = CN_Gs1 or MOV_Gs1 or (QN_Gs1 and (not CN_Gs1) and (not CR_Gs1))  # machine Gs1 can be demanded N
        AVR_Gs1 = CR_Gs1 or MOV_Gs1 or (QR_Gs1 and (not CN_Gs1) and (not CR_Gs1))  # machine Gs1 can be demanded R
        MOV_LC1 = VALID and FREE_g4 and (not OCC_g4) and True and True  # machine LC1 is free to move (R10)
        AVN_LC1 = CN_LC1 or MOV_LC1 or (QN_LC1 and (not CN_LC1) and (not CR_LC1))  # machine LC1 can be demanded N
        AVR_LC1 = CR_LC1 or MOV_LC1 or (QR_LC1 and (not CN_LC1) and (not CR_LC1))  # machine LC1 can be demanded R
        WF_g2_1 = FREE_g2 and (not OCC_g2) and (not BLK_g2)  # g2 from g2|w1@1.normal to g2|w2@2.normal: free for a route (R6)
        WA_g4_1 = AVR_LC1  # g4 from g4|w2@2.toe to g4|w6@6.toe: could be locked
        WF_g4_1 = FREE_g4 and (not OCC_g4) and (not BLK_g4) and WA_g4_1  # g4 from g4|w2@2.toe to g4|w6@6.toe: free for a route (R6)
        WF_g5_2 = FREE_g5 and (not OCC_g5) and (not BLK_g5)  # g5 from g5|w6@6.normal to B: free for a route (R6)
        WF_g8_2 = FREE_g8 and (not OCC_g8) and (not BLK_g8)  # g8 from g8|w5@5.toe to g8|w2@2.reverse: free for a route (R6)
        WF_w0_1 = FREE_w0 and (not OCC_w0) and (not BLK_w0)  # w0 from A to w0|w1@1.toe: free for a route (R6)
        WA_w1_2 = AVN_1 and (not TR_1) and (not OCC_g4) and (not OCC_g5) and (not OCC_g6) and (not OCC_g8) and (not OCC_w2) and (not OCC_w5) and (not OCC_w6)  # w1 from w0|w1@1.toe to g2|w1@1.normal: could be locked
        WF_w1_2 = FREE_w1 and (not OCC_w1) and (not BLK_w1) and WA_w1_2  # w1 from w0|w1@1.toe to g2|w1@1.normal: free for a route (R6)
        WA_w1_3 = AVR_1 and (not TR_1) and (not OCC_g2) and (not OCC_g4) and (not OCC_g5) and (not OCC_g6) and (not OCC_w2) and (not OCC_w6)  # w1 from w0|w1@1.toe to w1|w5@1.reverse: could be locked
        WF_w1_3 = FREE_w1 and (not OCC_w1) and (not BLK_w1) and WA_w1_3  # w1 from w0|w1@1.toe to w1|w5@1.reverse: free for a route (R6)
        WA_w2_1 = AVN_2 and (not TR_2) and RL_N8  # w2 from g2|w2@2.normal to g4|w2@2.toe: could be locked
        WF_w2_1 = FREE_w2 and (not OCC_w2) and (not BLK_w2) and WA_w2_1  # w2 from g2|w2@2.normal to g4|w2@2.toe: free for a route (R6)
        WA_w2_4 = AVR_2 and (not TR_2) and RL_N2  # w2 from g8|w2@2.reverse to g4|w2@2.toe: could be locked
        WF_w2_4 = FREE_w2 and (not OCC_w2) and (not BLK_w2) and WA_w2_4  # w2 from g8|w2@2.reverse to g4|w2@2.toe: free for a route (R6)
        WA_w5_4 = AVR_Gs1 and AVR_5 and AVN_1 and (not TR_Gs1) and (not TR_5) and (not TR_1) and (not OCC_w1)  # w5 from sid|w5@Gs1.outer to g8|w5@5.toe: could be locked
        WF_w5_4 = FREE_w5 and (not OCC_w5) and (not BLK_w5) and WA_w5_4  # w5 from sid|w5@Gs1.outer to g8|w5@5.toe: free for a route (R6)
        WA_w5_5 = AVN_5 and AVN_Gs1 and (not TR_5) and (not TR_Gs1)  # w5 from w1|w5@1.reverse to g8|w5@5.toe: could be locked
        WF_w5_5 = FREE_w5 and (not OCC_w5) and (not BLK_w5) and WA_w5_5  # w5 from w1|w5@1.reverse to g8|w5@5.toe: free for a route (R6)
        WA_w6_1 = AVN_6 and (not TR_6) and (not OCC_g6)  # w6 from g4|w6@6.toe to g5|w6@6.normal: could be locked
        WF_w6_1 = FREE_w6 and (not OCC_w6) and (not BLK_w6) and WA_w6_1  # w6 from g4|w6@6.toe to g5|w6@6.normal: free for a route (R6)
        WA_w6_2 = AVR_6 and (not TR_6) and (not OCC_g5)  # w6 from g4|w6@6.toe to g6|w6@6.reverse: could be locked
        OF_F_1 = ((not K_w6) and (not V_F_1) and (not V_F_2) and ((not L_w6_1) or A_R1) and (not L_w6_2)) and (not OCC_w6) and (not BLK_w6) and WA_w6_1 and ((not K_g5) and (not V_F_1) and ((not L_g5_2) or A_R1)) and (not OCC_g5) and (not BLK_g5)  # overlap 1 of F may be held (R4)
        OF_F_2 = ((not K_w6) and (not V_F_1) and (not V_F_2) and (not L_w6_1) and (not L_w6_2)) and (not OCC_w6) and (not BLK_w6) and WA_w6_2 and ((not K_g6) and (not V_F_2) and (not L_g6_2)) and (not OCC_g6) and (not BLK_g6)  # overlap 2 of F may be held (R4)
        OF_N2_1 = ((not K_w2) and (not V_N2_1) and ((not L_w2_1) or A_R3 or A_R4) and (not L_w2_4)) and (not OCC_w2) and (not BLK_w2) and WA_w2_1 and ((not K_g4) and (not V_N2_1) and ((not L_g4_1) or A_R3 or A_R4)) and (not OCC_g4) and (not BLK_g4) and WA_g4_1  # overlap 1 of N2 may be held (R4)
        OF_S1_1 = ((not K_w1) and (not V_S1_1) and (not V_S1_2) and ((not L_w1_2) or A_R7) and (not L_w1_3)) and (not OCC_w1) and (not BLK_w1) and WA_w1_2 and ((not K_g2) and (not V_S1_1) and ((not L_g2_1) or A_R7)) and (not OCC_g2) and (not BLK_g2)  # overlap 1 of S1 may be held (R4)
        OF_S1_2 = ((not K_w1) and (not V_S1_1) and (not V_S1_2) and (not L_w1_2) and ((not L_w1_3) or A_R8)) and (not OCC_w1) and (not BLK_w1) and WA_w1_3 and ((not K_w5) and (not V_S1_2) and (not L_w5_4) and ((not L_w5_5) or A_R8)) and (not OCC_w5) and (not BLK_w5) and WA_w5_5 and ((not K_g8) and (not V_S1_2) and ((not L_g8_2) or A_R8)) and (not OCC_g8) and (not BLK_g8)  # overlap 2 of S1 may be held (R4)
        WL_g2_1 = (not OCC_g2)  # g2 from g2|w1@1.normal to g2|w2@2.normal: lies and is clear
        WP_g2_1 = WL_g2_1 and (not BLK_g2)  # g2 from g2|w1@1.normal to g2|w2@2.normal: proceed may be shown over it (R3)
        WD_g4_1 = QR_LC1  # g4 from g4|w2@2.toe to g4|w6@6.toe: its points lie, nothing is foul of it
        WL_g4_1 = (not OCC_g4) and WD_g4_1  # g4 from g4|w2@2.toe to g4|w6@6.toe: lies and is clear
        WP_g4_1 = WL_g4_1 and (not BLK_g4)  # g4 from g4|w2@2.toe to g4|w6@6.toe: proceed may be shown over it (R3)
        WL_g5_2 = (not OCC_g5)  # g5 from g5|w6@6.normal to B: lies and is clear
        WP_g5_2 = WL_g5_2 and (not BLK_g5)  # g5 from g5|w6@6.normal to B: proceed may be shown over it (R3)
        WL_g6_2 = (not OCC_g6)  # g6 from g6|w6@6.reverse to C: lies and is clear
        WL_g8_2 = (not OCC_g8)  # g8 from g8|w5@5.toe to g8|w2@2.reverse: lies and is clear
        WP_g8_2 = WL_g8_2 and (not BLK_g8)  # g8 from g8|w5@5.toe to g8|w2@2.reverse: proceed may be shown over it (R3)
        WL_w0_1 = (not OCC_w0)  # w0 from A to w0|w1@1.toe: lies and is clear
        WP_w0_1 = WL_w0_1 and (not BLK_w0)  # w0 from A to w0|w1@1.toe: proceed may be shown over it (R3)
        WD_w1_2 = QN_1 and (not TR_1) and (not OCC_g4) and (not OCC_g5) and (not OCC_g6) and (not OCC_g8) and (not OCC_w2) and (not OCC_w5) and (not OCC_w6)  # w1 from w0|w1@1.toe to g2|w1@1.normal: its points lie, nothing is foul of it
        WL_w1_2 = (not OCC_w1) and WD_w1_2  # w1 from w0|w1@1.toe to g2|w1@1.normal: lies and is clear
        WP_w1_2 = WL_w1_2 and (not BLK_w1)  # w1 from w0|w1@1.toe to g2|w1@1.normal: proceed may be shown over it (R3)
        WD_w1_3 = QR_1 and (not TR_1) and (not OCC_g2) and (not OCC_g4) and (not OCC_g5) and (not OCC_g6) and (not OCC_w2) and (not OCC_w6)  # w1 from w0|w1@1.toe to w1|w5@1.reverse: its points lie, nothing is foul of it
        WL_w1_3 = (not OCC_w1) and WD_w1_3  # w1 from w0|w1@1.toe to w1|w5@1.reverse: lies and is clear
        WP_w1_3 = WL_w1_3 and (not BLK_w1)  # w1 from w0|w1@1.toe to w1|w5@1.reverse: proceed may be shown over it (R3)
        WD_w2_1 = QN_2 and (not TR_2) and RL_N8  # w2 from g2|w2@2.normal to g4|w2@2.toe: its points lie, nothing is foul of it
        WL_w2_1 = (not OCC_w2) and WD_w2_1  # w2 from g2|w2@2.normal to g4|w2@2.toe: lies and is clear
        WP_w2_1 = WL_w2_1 and (not BLK_w2)  # w2 from g2|w2@2.normal to g4|w2@2.toe: proceed may be shown over it (R3)
        WD_w2_4 = QR_2 and (not TR_2) and RL_N2  # w2 from g8|w2@2.reverse to g4|w2@2.toe: its points lie, nothing is foul of it
        WL_w2_4 = (not OCC_w2) and WD_w2_4  # w2 from g8|w2@2.reverse to g4|w2@2.toe: lies and is clear
        WP_w2_4 = WL_w2_4 and (not BLK_w2)  # w2 from g8|w2@2.reverse to g4|w2@2.toe: proceed may be shown over it (R3)
        WD_w5_4 = QR_Gs1 and QR_5 and QN_1 and (not TR_Gs1) and (not TR_5) and (not TR_1) and (not OCC_w1)  # w5 from sid|w5@Gs1.outer to g8|w5@5.toe: its points lie, nothing is foul of it
        WL_w5_4 = (not OCC_w5) and WD_w5_4  # w5 from sid|w5@Gs1.outer to g8|w5@5.toe: lies and is clear
        WP_w5_4 = WL_w5_4 and (not BLK_w5)  # w5 from sid|w5@Gs1.outer to g8|w5@5.toe: proceed may be shown over it (R3)
        WD_w5_5 = QN_5 and QN_Gs1 and (not TR_5) and (not TR_Gs1)  # w5 from w1|w5@1.reverse to g8|w5@5.toe: its points lie, nothing is foul of it
        WL_w5_5 = (not OCC_w5) and WD_w5_5  # w5 from w1|w5@1.reverse to g8|w5@5.toe: lies and is clear
        WP_w5_5 = WL_w5_5 and (not BLK_w5)  # w5 from w1|w5@1.reverse to g8|w5@5.toe: proceed may be shown over it (R3)
        WD_w6_1 = QN_6 and (not TR_6) and (not OCC_g6)  # w6 from g4|w6@6.toe to g5|w6@6.normal: its points lie, nothing is foul of it
        WL_w6_1 = (not OCC_w6) and WD_w6_1  # w6 from g4|w6@6.toe to g5|w6@6.normal: lies and is clear
        WP_w6_1 = WL_w6_1 and (not BLK_w6)  # w6 from g4|w6@6.toe to g5|w6@6.normal: proceed may be shown over it (R3)
        WD_w6_2 = QR_6 and (not TR_6) and (not OCC_g5)  # w6 from g4|w6@6.toe to g6|w6@6.reverse: its points lie, nothing is foul of it
        WL_w6_2 = (not OCC_w6) and WD_w6_2  # w6 from g4|w6@6.toe to g6|w6@6.reverse: lies and is clear
        OL_F = (V_F_1 and WL_w6_1 and WL_g5_2) or (V_F_2 and WL_w6_2 and WL_g6_2)  # the overlap of F lies and is clear (R4)
        G_R1 = (REQ == 1) and VALID and ((not K_w6) and (not L_w6_1) and (not L_w6_2) and (not V_F_2)) and (not OCC_w6) and (not BLK_w6) and WA_w6_1 and ((not K_g5) and (not L_g5_2)) and (not OCC_g5) and (not BLK_g5)  # grant of route F-B (R6)
        G_R2 = (REQ == 2) and VALID and WF_w5_4 and WF_g8_2  # grant of route L5-N8 (R6)
        G_R3 = (REQ == 3) and VALID and ((not K_w2) and (not L_w2_1) and (not L_w2_4)) and (not OCC_w2) and (not BLK_w2) and WA_w2_1 and ((not K_g4) and (not L_g4_1)) and (not OCC_g4) and (not BLK_g4) and WA_g4_1 and OF_F_1  # grant of route N2-F (R6)
        G_R4 = (REQ == 4) and VALID and ((not K_w2) and (not L_w2_1) and (not L_w2_4)) and (not OCC_w2) and (not BLK_w2) and WA_w2_1 and ((not K_g4) and (not L_g4_1)) and (not OCC_g4) and (not BLK_g4) and WA_g4_1 and OF_F_2  # grant of route N2-F.o2 (R6)
        G_R5 = (REQ == 5) and VALID and WF_w2_4 and WF_g4_1 and OF_F_1  # grant of route N8-F (R6)
        G_R6 = (REQ == 6) and VALID and WF_w2_4 and WF_g4_1 and OF_F_2  # grant of route N8-F.o2 (R6)
        G_R7 = (REQ == 7) and VALID and ((not K_w1) and (not L_w1_2) and (not L_w1_3) and (not V_S1_2)) and (not OCC_w1) and (not BLK_w1) and WA_w1_2 and ((not K_g2) and (not L_g2_1)) and (not OCC_g2) and (not BLK_g2) and OF_N2_1  # grant of route S1-N2 (R6)
        G_R8 = (REQ == 8) and VALID and ((not K_w1) and (not L_w1_2) and (not L_w1_3) and (not V_S1_1)) and (not OCC_w1) and (not BLK_w1) and WA_w1_3 and ((not K_w5) and (not L_w5_4) and (not L_w5_5)) and (not OCC_w5) and (not BLK_w5) and WA_w5_5 and ((not K_g8) and (not L_g8_2)) and (not OCC_g8) and (not BLK_g8)  # grant of route S1-N8 (R6)
        G_R9 = (REQ == 9) and VALID and WF_w0_1 and OF_S1_1  # grant of route SA-S1 (R6)
        G_R10 = (REQ == 10) and VALID and WF_w0_1 and OF_S1_2  # grant of route SA-S1.o2 (R6)
        GW_g2_1 = G_R7  # g2 from g2|w1@1.normal to g2|w2@2.normal: granted
        GW_g4_1 = G_R3 or G_R4 or G_R5 or G_R6  # g4 from g4|w2@2.toe to g4|w6@6.toe: granted
        GW_g5_2 = G_R1  # g5 from g5|w6@6.normal to B: granted
        GW_g8_2 = G_R2 or G_R8  # g8 from g8|w5@5.toe to g8|w2@2.reverse: granted
        GW_w0_1 = G_R9 or G_R10  # w0 from A to w0|w1@1.toe: granted
        GW_w1_2 = G_R7  # w1 from w0|w1@1.toe to g2|w1@1.normal: granted
        GW_w1_3 = G_R8  # w1 from w0|w1@1.toe to w1|w5@1.reverse: granted
        GW_w2_1 = G_R3 or G_R4  # w2 from g2|w2@2.normal to g4|w2@2.toe: granted
        GW_w2_4 = G_R5 or G_R6  # w2 from g8|w2@2.reverse to g4|w2@2.toe: granted
        GW_w5_4 = G_R2  # w5 from sid|w5@Gs1.outer to g8|w5@5.toe: granted
        GW_w5_5 = G_R8  # w5 from w1|w5@1.reverse to g8|w5@5.toe: granted
        GW_w6_1 = G_R1  # w6 from g4|w6@6.toe to g5|w6@6.normal: granted
        GO_F_1 = G_R3 or G_R5  # overlap 1 of F: granted
        GO_F_2 = G_R4 or G_R6  # overlap 2 of F: granted
        GO_N2_1 = G_R7  # overlap 1 of N2: granted
        GO_S1_1 = G_R9  # overlap 1 of S1: granted
        GO_S1_2 = G_R10  # overlap 2 of S1: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_F) and (not CAN_F) and WL_w6_1 and WL_g5_2  # route F-B becomes locked (R3)
        CO_R1 = VALID and WP_w6_1 and WP_g5_2 and (not OCC_gb) and (not D_w6) and CL_F  # conditions of proceed for route F-B (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_L5) and (not CAN_L5) and WL_w5_4 and WL_g8_2  # route L5-N8 becomes locked (R3)
        CO_R2 = VALID and WP_w5_4 and WP_g8_2 and (not D_w5)  # conditions of proceed for route L5-N8 (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_N2) and (not CAN_N2) and WL_w2_1 and WL_g4_1 and OL_F  # route N2-F becomes locked (R3)
        CO_R3 = VALID and WP_w2_1 and WP_g4_1 and OL_F and (not D_w2) and CL_N2 and (V_F_1 or V_F_2)  # conditions of proceed for route N2-F (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_N2) and (not CAN_N2) and WL_w2_1 and WL_g4_1 and OL_F  # route N2-F.o2 becomes locked (R3)
        CO_R4 = VALID and WP_w2_1 and WP_g4_1 and OL_F and (not D_w2) and CL_N2 and (V_F_1 or V_F_2)  # conditions of proceed for route N2-F.o2 (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_N8) and (not CAN_N8) and WL_w2_4 and WL_g4_1 and OL_F  # route N8-F becomes locked (R3)
        CO_R5 = VALID and WP_w2_4 and WP_g4_1 and OL_F and (not D_w2) and CL_N8 and (V_F_1 or V_F_2)  # conditions of proceed for route N8-F (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_N8) and (not CAN_N8) and WL_w2_4 and WL_g4_1 and OL_F  # route N8-F.o2 becomes locked (R3)
        CO_R6 = VALID and WP_w2_4 and WP_g4_1 and OL_F and (not D_w2) and CL_N8 and (V_F_1 or V_F_2)  # conditions of proceed for route N8-F.o2 (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_S1) and (not CAN_S1) and WL_w1_2 and WL_g2_1 and WL_w2_1 and WL_g4_1  # route S1-N2 becomes locked (R3)
        CO_R7 = VALID and WP_w1_2 and WP_g2_1 and WL_w2_1 and WL_g4_1 and (not D_w1) and CL_S1 and V_N2_1  # conditions of proceed for route S1-N2 (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_S1) and (not CAN_S1) and WL_w1_3 and WL_w5_5 and WL_g8_2  # route S1-N8 becomes locked (R3)
        CO_R8 = VALID and WP_w1_3 and WP_w5_5 and WP_g8_2 and (not D_w1) and CL_S1  # conditions of proceed for route S1-N8 (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_SA) and (not CAN_SA) and WL_w0_1 and WL_w1_2 and WL_g2_1  # route SA-S1 becomes locked (R3)
        CO_R9 = VALID and WP_w0_1 and WL_w1_2 and WL_g2_1 and (not D_w0) and CL_SA and V_S1_1  # conditions of proceed for route SA-S1 (R3)
        LK_R10 = A_R10 and (not B_R10) and VALID and (not X_SA) and (not CAN_SA) and WL_w0_1 and WL_w1_3 and WL_w5_5 and WL_g8_2  # route SA-S1.o2 becomes locked (R3)
        CO_R10 = VALID and WP_w0_1 and WL_w1_3 and WL_w5_5 and WL_g8_2 and (not D_w0) and CL_SA and V_S1_2  # conditions of proceed for route SA-S1.o2 (R3)
        NU_g2_1 = VALID and F_g2 and (not D_g2) and (not U_g2) and L_g2_1 and OCC_g2 and OCC_w1 and (V_S1_1 or U_w1) and (V_S1_1 or L_w1_2)  # a train comes into g2 at g2|w1@1.normal (R9)
        NU_g4_1 = VALID and F_g4 and (not D_g4) and (not U_g4) and L_g4_1 and OCC_g4 and OCC_w2 and (V_N2_1 or U_w2) and (V_N2_1 or L_w2_1 or L_w2_4)  # a train comes into g4 at g4|w2@2.toe (R9)
        NU_g5_2 = VALID and F_g5 and (not D_g5) and (not U_g5) and L_g5_2 and OCC_g5 and OCC_w6 and (V_F_1 or U_w6) and (V_F_1 or L_w6_1)  # a train comes into g5 at g5|w6@6.normal (R9)
        NU_g6_2 = VALID and F_g6 and (not D_g6) and (not U_g6) and L_g6_2 and OCC_g6 and OCC_w6 and (V_F_2 or U_w6) and (V_F_2 or L_w6_2)  # a train comes into g6 at g6|w6@6.reverse (R9)
        NU_g8_2 = VALID and F_g8 and (not D_g8) and (not U_g8) and L_g8_2 and OCC_g8 and OCC_w5 and (V_S1_2 or U_w5) and (V_S1_2 or L_w5_4 or L_w5_5)  # a train comes into g8 at g8|w5@5.toe (R9)
        NU_w0_1 = VALID and F_w0 and (not D_w0) and (not U_w0) and L_w0_1 and OCC_w0 and OCC_ga  # a train comes into w0 at A (R9)
        NU_w1_2 = VALID and F_w1 and (not D_w1) and (not U_w1) and (L_w1_2 or L_w1_3) and OCC_w1 and OCC_w0  # a train comes into w1 at w0|w1@1.toe (R9)
        NU_w2_1 = VALID and F_w2 and (not D_w2) and (not U_w2) and L_w2_1 and OCC_w2 and OCC_g2  # a train comes into w2 at g2|w2@2.normal (R9)
        NU_w2_3 = VALID and F_w2 and (not D_w2) and (not U_w2) and L_w2_4 and OCC_w2 and OCC_g8  # a train comes into w2 at g8|w2@2.reverse (R9)
        NU_w5_3 = VALID and F_w5 and (not D_w5) and (not U_w5) and L_w5_4 and OCC_w5 and OCC_sid and ((not M_w5) or U_sid) and (not M_w5)  # a train comes into w5 at sid|w5@Gs1.outer (R9)
        NU_w5_4 = VALID and F_w5 and (not D_w5) and (not U_w5) and L_w5_5 and OCC_w5 and OCC_w1 and (V_S1_2 or U_w1) and (V_S1_2 or L_w1_3)  # a train comes into w5 at w1|w5@1.reverse (R9)
        NU_w6_1 = VALID and F_w6 and (not D_w6) and (not U_w6) and (L_w6_1 or L_w6_2) and OCC_w6 and OCC_g4  # a train comes into w6 at g4|w6@6.toe (R9)
        ATI_F = X_F or ((not A_R1) and (L_w6_1 or L_w6_2) and REL_w6)  # F at stop, waiting for a train that may still come (R8)
        ATI_L5 = X_L5 or ((not A_R2) and L_w5_4 and REL_w5)  # L5 at stop, waiting for a train that may still come (R8)
        ATI_N2 = X_N2 or ((not (A_R3 or A_R4)) and L_w2_1 and REL_w2)  # N2 at stop, waiting for a train that may still come (R8)
        ATI_N8 = X_N8 or ((not (A_R5 or A_R6)) and L_w2_4 and REL_w2)  # N8 at stop, waiting for a train that may still come (R8)
        ATI_S1 = X_S1 or ((not (A_R7 or A_R8)) and (L_w1_2 or L_w1_3) and REL_w1)  # S1 at stop, waiting for a train that may still come (R8)
        ATI_SA = X_SA or ((not (A_R9 or A_R10)) and L_w0_1 and REL_w0)  # SA at stop, waiting for a train that may still come (R8)
        AT_F = self._timer('AT_F', ATI_F, dt_ms)  # F: approach locking delay (R8)
        AT_L5 = self._timer('AT_L5', ATI_L5, dt_ms)  # L5: approach locking delay (R8)
        AT_N2 = self._timer('AT_N2', ATI_N2, dt_ms)  # N2: approach locking delay (R8)
        AT_N8 = self._timer('AT_N8', ATI_N8, dt_ms)  # N8: approach locking delay (R8)
        AT_S1 = self._timer('AT_S1', ATI_S1, dt_ms)  # S1: approach locking delay (R8)
        AT_SA = self._timer('AT_SA', ATI_SA, dt_ms)  # SA: approach locking delay (R8)
        CD_F = X_F and A_R1 and VALID and (not OCC_w6) and ((not OCC_g4) or AT_F or (not H_R1))  # the route from F is cancelled (R8)
        CD_L5 = X_L5 and A_R2 and VALID and (not OCC_w5) and ((not OCC_sid) or AT_L5 or (not H_R2))  # the route from L5 is cancelled (R8)
        CD_N2 = X_N2 and (A_R3 or A_R4) and VALID and (not OCC_w2) and ((not OCC_g2) or AT_N2 or (not (H_R3 or H_R4)))  # the route from N2 is cancelled (R8)
        CD_N8 = X_N8 and (A_R5 or A_R6) and VALID and (not OCC_w2) and ((not OCC_g8) or AT_N8 or (not (H_R5 or H_R6)))  # the route from N8 is cancelled (R8)
        CD_S1 = X_S1 and (A_R7 or A_R8) and VALID and (not OCC_w1) and ((not OCC_w0) or AT_S1 or (not (H_R7 or H_R8)))  # the route from S1 is cancelled (R8)
        CD_SA = X_SA and (A_R9 or A_R10) and VALID and (not OCC_w0) and ((not OCC_ga) or AT_SA or (not (H_R9 or H_R10)))  # the route from SA is cancelled (R8)
        EX_g2 = P_g2  # a train in g2 leaves over a boundary, or has passed on
        RTI_g2 = VALID and U_g2 and (not OCC_g2) and (not (L_g2_1 and L_w1_2)) and EX_g2  # g2 may be released behind the train (R9)
        EX_g4 = P_g4  # a train in g4 leaves over a boundary, or has passed on
        RTI_g4 = VALID and U_g4 and (not OCC_g4) and (not (L_g4_1 and (L_w2_1 or L_w2_4))) and EX_g4  # g4 may be released behind the train (R9)
        EX_g5 = P_g5 or L_g5_2  # a train in g5 leaves over a boundary, or has passed on
        RTI_g5 = VALID and U_g5 and (not OCC_g5) and (not (L_g5_2 and L_w6_1)) and EX_g5  # g5 may be released behind the train (R9)
        EX_g6 = P_g6  # a train in g6 leaves over a boundary, or has passed on
        RTI_g6 = VALID and U_g6 and (not OCC_g6) and (not (L_g6_2 and L_w6_2)) and EX_g6  # g6 may be released behind the train (R9)
        EX_g8 = P_g8  # a train in g8 leaves over a boundary, or has passed on
        RTI_g8 = VALID and U_g8 and (not OCC_g8) and (not (L_g8_2 and (L_w5_4 or L_w5_5))) and EX_g8  # g8 may be released behind the train (R9)
        EX_sid = P_sid  # a train in sid leaves over a boundary, or has passed on
        RTI_sid = VALID and U_sid and (not OCC_sid) and EX_sid  # sid may be released behind the train (R9)
        EX_w0 = P_w0  # a train in w0 leaves over a boundary, or has passed on
        RTI_w0 = VALID and U_w0 and (not OCC_w0) and EX_w0  # w0 may be released behind the train (R9)
        EX_w1 = P_w1  # a train in w1 leaves over a boundary, or has passed on
        RTI_w1 = VALID and U_w1 and (not OCC_w1) and EX_w1  # w1 may be released behind the train (R9)
        EX_w2 = P_w2  # a train in w2 leaves over a boundary, or has passed on
        RTI_w2 = VALID and U_w2 and (not OCC_w2) and EX_w2  # w2 may be released behind the train (R9)
        EX_w5 = P_w5  # a train in w5 leaves over a boundary, or has passed on
        RTI_w5 = VALID and U_w5 and (not OCC_w5) and (not (L_w5_5 and L_w1_3)) and EX_w5  # w5 may be released behind the train (R9)
        EX_w6 = P_w6  # a train in w6 leaves over a boundary, or has passed on
        RTI_w6 = VALID and U_w6 and (not OCC_w6) and EX_w6  # w6 may be released behind the train (R9)
        RT_g2 = self._timer('RT_g2', RTI_g2, dt_ms)  # g2: release delay (R9)
        RT_g4 = self._timer('RT_g4', RTI_g4, dt_ms)  # g4: release delay (R9)
        RT_g5 = self._timer('RT_g5', RTI_g5, dt_ms)  # g5: release delay (R9)
        RT_g6 = self._timer('RT_g6', RTI_g6, dt_ms)  # g6: release delay (R9)
        RT_g8 = self._timer('RT_g8', RTI_g8, dt_ms)  # g8: release delay (R9)
        RT_sid = self._timer('RT_sid', RTI_sid, dt_ms)  # sid: release delay (R9)
        RT_w0 = self._timer('RT_w0', RTI_w0, dt_ms)  # w0: release delay (R9)
        RT_w1 = self._timer('RT_w1', RTI_w1, dt_ms)  # w1: release delay (R9)
        RT_w2 = self._timer('RT_w2', RTI_w2, dt_ms)  # w2: release delay (R9)
        RT_w5 = self._timer('RT_w5', RTI_w5, dt_ms)  # w5: release delay (R9)
        RT_w6 = self._timer('RT_w6', RTI_w6, dt_ms)  # w6: release delay (R9)
        CA_g2 = VALID and (not OCC_g2) and (not U_g2) and L_g2_1 and (not (L_g2_1 and L_w1_2))  # the lock before g2 was withdrawn (R8)
        HR_g2 = VALID and (not OCC_g2) and (not (L_g2_1 and L_w1_2)) and REL_g2 and L_g2_1  # g2 released by hand (R8, section fault release)
        SR_g2 = VALID and (not OCC_g2) and K_g2 and (REL_g2 or RELALL)  # g2 released after a restart (R16)
        RLS_g2 = RT_g2 or CA_g2 or HR_g2 or SR_g2  # g2 is released
        CA_g4 = VALID and (not OCC_g4) and (not U_g4) and L_g4_1 and (not (L_g4_1 and (L_w2_1 or L_w2_4)))  # the lock before g4 was withdrawn (R8)
        HR_g4 = VALID and (not OCC_g4) and (not (L_g4_1 and (L_w2_1 or L_w2_4))) and REL_g4 and L_g4_1  # g4 released by hand (R8, section fault release)
        SR_g4 = VALID and (not OCC_g4) and K_g4 and (REL_g4 or RELALL)  # g4 released after a restart (R16)
        RLS_g4 = RT_g4 or CA_g4 or HR_g4 or SR_g4  # g4 is released
        CA_g5 = VALID and (not OCC_g5) and (not U_g5) and L_g5_2 and (not (L_g5_2 and L_w6_1))  # the lock before g5 was withdrawn (R8)
        HR_g5 = VALID and (not OCC_g5) and (not (L_g5_2 and L_w6_1)) and REL_g5 and L_g5_2  # g5 released by hand (R8, section fault release)
        SR_g5 = VALID and (not OCC_g5) and K_g5 and (REL_g5 or RELALL)  # g5 released after a restart (R16)
        RLS_g5 = RT_g5 or CA_g5 or HR_g5 or SR_g5  # g5 is released
        CA_g6 = VALID and (not OCC_g6) and (not U_g6) and L_g6_2 and (not (L_g6_2 and L_w6_2))  # the lock before g6 was withdrawn (R8)
        HR_g6 = VALID and (not OCC_g6) and (not (L_g6_2 and L_w6_2)) and REL_g6 and L_g6_2  # g6 released by hand (R8, section fault release)
        SR_g6 = VALID and (not OCC_g6) and K_g6 and (REL_g6 or RELALL)  # g6 released after a restart (R16)
        RLS_g6 = RT_g6 or CA_g6 or HR_g6 or SR_g6  # g6 is released
        CA_g8 = VALID and (not OCC_g8) and (not U_g8) and L_g8_2 and (not (L_g8_2 and (L_w5_4 or L_w5_5)))  # the lock before g8 was withdrawn (R8)
        HR_g8 = VALID and (not OCC_g8) and (not (L_g8_2 and (L_w5_4 or L_w5_5))) and REL_g8 and L_g8_2  # g8 released by hand (R8, section fault release)
        SR_g8 = VALID and (not OCC_g8) and K_g8 and (REL_g8 or RELALL)  # g8 released after a restart (R16)
        RLS_g8 = RT_g8 or CA_g8 or HR_g8 or SR_g8  # g8 is released
        CA_sid = VALID and (not OCC_sid) and (not U_sid) and False  # the lock before sid was withdrawn (R8)
        HR_sid = VALID and (not OCC_sid) and REL_sid and False  # sid released by hand (R8, section fault release)
        SR_sid = VALID and (not OCC_sid) and K_sid and (REL_sid or RELALL)  # sid released after a restart (R16)
        RLS_sid = RT_sid or CA_sid or HR_sid or SR_sid  # sid is released
        CA_w0 = VALID and (not OCC_w0) and (not U_w0) and False  # the lock before w0 was withdrawn (R8)
        HR_w0 = VALID and (not OCC_w0) and REL_w0 and L_w0_1 and ((not L_w0_1) or ((not (A_R9 or A_R10)) and ((not OCC_ga) or AT_SA)))  # w0 released by hand (R8, section fault release)
        SR_w0 = VALID and (not OCC_w0) and K_w0 and (REL_w0 or RELALL)  # w0 released after a restart (R16)
        RLS_w0 = RT_w0 or CA_w0 or CD_SA or HR_w0 or SR_w0  # w0 is released
        CA_w1 = VALID and (not OCC_w1) and (not U_w1) and False  # the lock before w1 was withdrawn (R8)
        HR_w1 = VALID and (not OCC_w1) and REL_w1 and (L_w1_2 or L_w1_3) and ((not (L_w1_2 or L_w1_3)) or ((not (A_R7 or A_R8)) and ((not OCC_w0) or AT_S1)))  # w1 released by hand (R8, section fault release)
        SR_w1 = VALID and (not OCC_w1) and K_w1 and (REL_w1 or RELALL)  # w1 released after a restart (R16)
        RLS_w1 = RT_w1 or CA_w1 or CD_S1 or HR_w1 or SR_w1  # w1 is released
        CA_w2 = VALID and (not OCC_w2) and (not U_w2) and False  # the lock before w2 was withdrawn (R8)
        HR_w2 = VALID and (not OCC_w2) and REL_w2 and (L_w2_1 or L_w2_4) and ((not L_w2_1) or ((not (A_R3 or A_R4)) and ((not OCC_g2) or AT_N2))) and ((not L_w2_4) or ((not (A_R5 or A_R6)) and ((not OCC_g8) or AT_N8)))  # w2 released by hand (R8, section fault release)
        SR_w2 = VALID and (not OCC_w2) and K_w2 and (REL_w2 or RELALL)  # w2 released after a restart (R16)
        RLS_w2 = RT_w2 or CA_w2 or CD_N2 or CD_N8 or HR_w2 or SR_w2  # w2 is released
        CA_w5 = VALID and (not OCC_w5) and (not U_w5) and ((L_w5_4 and M_w5) or L_w5_5) and (not (L_w5_5 and L_w1_3))  # the lock before w5 was withdrawn (R8)
        HR_w5 = VALID and (not OCC_w5) and (not (L_w5_5 and L_w1_3)) and REL_w5 and (L_w5_4 or L_w5_5) and ((not L_w5_4) or ((not A_R2) and ((not OCC_sid) or AT_L5)))  # w5 released by hand (R8, section fault release)
        SR_w5 = VALID and (not OCC_w5) and K_w5 and (REL_w5 or RELALL)  # w5 released after a restart (R16)
        RLS_w5 = RT_w5 or CA_w5 or CD_L5 or HR_w5 or SR_w5  # w5 is released
        CA_w6 = VALID and (not OCC_w6) and (not U_w6) and False  # the lock before w6 was withdrawn (R8)
        HR_w6 = VALID and (not OCC_w6) and REL_w6 and (L_w6_1 or L_w6_2) and ((not (L_w6_1 or L_w6_2)) or ((not A_R1) and ((not OCC_g4) or AT_F)))  # w6 released by hand (R8, section fault release)
        SR_w6 = VALID and (not OCC_w6) and K_w6 and (REL_w6 or RELALL)  # w6 released after a restart (R16)
        RLS_w6 = RT_w6 or CA_w6 or CD_F or HR_w6 or SR_w6  # w6 is released
        OTI_F = VALID and U_g4 and (not (L_g4_1 and (L_w2_1 or L_w2_4))) and L_g4_1 and OCC_g4  # the train before F is wholly in g4 (R4)
        OTI_N2 = VALID and U_g2 and (not (L_g2_1 and L_w1_2)) and L_g2_1 and OCC_g2  # the train before N2 is wholly in g2 (R4)
        OTI_S1 = VALID and U_w0 and (not (L_w0_1 and OCC_ga)) and L_w0_1 and OCC_w0  # the train before S1 is wholly in w0 (R4)
        OT_F = self._timer('OT_F', OTI_F, dt_ms)  # F: the train before it stands (R4)
        OT_N2 = self._timer('OT_N2', OTI_N2, dt_ms)  # N2: the train before it stands (R4)
        OT_S1 = self._timer('OT_S1', OTI_S1, dt_ms)  # S1: the train before it stands (R4)
        OR_F = (not L_g4_1) or OT_F  # the overlap of F is not needed any more (R4)
        OR_N2 = (not L_g2_1) or OT_N2  # the overlap of N2 is not needed any more (R4)
        OR_S1 = (not L_w0_1) or OT_S1  # the overlap of S1 is not needed any more (R4)
        SW1_1 = VALID and (REQ == 11) and V_F_2 and VF_F and (not OR_F) and (not OCC_g4) and (not OCC_w6) and (not OCC_g5) and (not OCC_g6) and (not (L_w6_1 or L_w6_2)) and (not L_g5_2) and (not L_g6_2) and (not K_w6) and (not BLK_w6) and (CN_6 or (VALID and (not K_w6) and (not L_w6_1) and (not L_w6_2) and (not OCC_w6)) or (QN_6 and (not CN_6) and (not CR_6))) and (not TR_6) and (not OCC_g6) and (not K_g5) and (not BLK_g5)  # the overlap of F swings to 1 (R4)
        SW1_2 = VALID and (REQ == 11) and V_F_1 and VF_F and (not OR_F) and (not OCC_g4) and (not SW1_1) and (not OCC_w6) and (not OCC_g5) and (not OCC_g6) and (not (L_w6_1 or L_w6_2)) and (not L_g5_2) and (not L_g6_2) and (not K_w6) and (not BLK_w6) and (CR_6 or (VALID and (not K_w6) and (not L_w6_1) and (not L_w6_2) and (not OCC_w6)) or (QR_6 and (not CN_6) and (not CR_6))) and (not TR_6) and (not OCC_g5) and (not K_g6) and (not BLK_g6)  # the overlap of F swings to 2 (R4)
        TG_1 = (GW_w1_2 or GO_S1_1 or GW_w1_3 or GO_S1_2 or GW_w5_4)  # a grant touches machine 1 in this scan
        GPN_1 = (GW_w1_2 or GO_S1_1 or GW_w5_4)  # a grant needs 1 N
        MAN_1 = MN_1 and (not MR_1) and MOV_1 and (not TG_1)  # machine 1 moved N by hand
        GPR_1 = (GW_w1_3 or GO_S1_2)  # a grant needs 1 R
        MAR_1 = MR_1 and (not MN_1) and MOV_1 and (not TG_1)  # machine 1 moved R by hand
        HDN_1 = CN_1 and (not GPR_1) and (not MAR_1)  # the command N stays
        HDR_1 = CR_1 and (not GPN_1) and (not MAN_1)  # the command R stays
        TG_2 = (GW_w2_1 or GO_N2_1 or GW_w2_4)  # a grant touches machine 2 in this scan
        GPN_2 = (GW_w2_1 or GO_N2_1)  # a grant needs 2 N
        MAN_2 = MN_2 and (not MR_2) and MOV_2 and (not TG_2)  # machine 2 moved N by hand
        GPR_2 = GW_w2_4  # a grant needs 2 R
        MAR_2 = MR_2 and (not MN_2) and MOV_2 and (not TG_2)  # machine 2 moved R by hand
        HDN_2 = CN_2 and (not GPR_2) and (not MAR_2)  # the command N stays
        HDR_2 = CR_2 and (not GPN_2) and (not MAN_2)  # the command R stays
        TG_5 = (GW_w5_4 or GW_w5_5 or GO_S1_2)  # a grant touches machine 5 in this scan
        GPN_5 = (GW_w5_5 or GO_S1_2)  # a grant needs 5 N
        MAN_5 = MN_5 and (not MR_5) and MOV_5 and (not TG_5)  # machine 5 moved N by hand
        GPR_5 = GW_w5_4  # a grant needs 5 R
        MAR_5 = MR_5 and (not MN_5) and MOV_5 and (not TG_5)  # machine 5 moved R by hand
        HDN_5 = CN_5 and (not GPR_5) and (not MAR_5)  # the command N stays
        HDR_5 = CR_5 and (not GPN_5) and (not MAN_5)  # the command R stays
        TG_6 = (GW_w6_1 or GO_F_1 or SW1_1 or GO_F_2 or SW1_2)  # a grant touches machine 6 in this scan
        GPN_6 = (GW_w6_1 or GO_F_1 or SW1_1)  # a grant needs 6 N
        MAN_6 = MN_6 and (not MR_6) and MOV_6 and (not TG_6)  # machine 6 moved N by hand
        GPR_6 = (GO_F_2 or SW1_2)  # a grant needs 6 R
        MAR_6 = MR_6 and (not MN_6) and MOV_6 and (not TG_6)  # machine 6 moved R by hand
        HDN_6 = CN_6 and (not GPR_6) and (not MAR_6)  # the command N stays
        HDR_6 = CR_6 and (not GPN_6) and (not MAN_6)  # the command R stays
        TG_Gs1 = (GW_w5_4 or GW_w5_5 or GO_S1_2)  # a grant touches machine Gs1 in this scan
        GPN_Gs1 = (GW_w5_5 or GO_S1_2)  # a grant needs Gs1 N
        MAN_Gs1 = MN_Gs1 and (not MR_Gs1) and MOV_Gs1 and (not TG_Gs1)  # machine Gs1 moved N by hand
        GPR_Gs1 = GW_w5_4  # a grant needs Gs1 R
        MAR_Gs1 = MR_Gs1 and (not MN_Gs1) and MOV_Gs1 and (not TG_Gs1)  # machine Gs1 moved R by hand
        HDN_Gs1 = CN_Gs1 and (not GPR_Gs1) and (not MAR_Gs1)  # the command N stays
        HDR_Gs1 = CR_Gs1 and (not GPN_Gs1) and (not MAN_Gs1)  # the command R stays
        TG_LC1 = (GW_g4_1 or GO_N2_1)  # a grant touches machine LC1 in this scan
        GPN_LC1 = False or (MOV_LC1 and (not TG_LC1) and (not MR_LC1))  # a grant needs LC1 N
        MAN_LC1 = MN_LC1 and (not MR_LC1) and MOV_LC1 and (not TG_LC1)  # machine LC1 moved N by hand
        GPR_LC1 = (GW_g4_1 or GO_N2_1)  # a grant needs LC1 R
        MAR_LC1 = MR_LC1 and (not MN_LC1) and MOV_LC1 and (not TG_LC1)  # machine LC1 moved R by hand
        HDN_LC1 = CN_LC1 and (not GPR_LC1) and (not MAR_LC1)  # the command N stays
        HDR_LC1 = CR_LC1 and (not GPN_LC1) and (not MAN_LC1)  # the command R stays
        STI_1 = (CN_1 and (not QN_1)) or (CR_1 and (not QR_1))  # machine 1 is not where it was commanded
        STI_2 = (CN_2 and (not QN_2)) or (CR_2 and (not QR_2))  # machine 2 is not where it was commanded
        STI_5 = (CN_5 and (not QN_5)) or (CR_5 and (not QR_5))  # machine 5 is not where it was commanded
        STI_6 = (CN_6 and (not QN_6)) or (CR_6 and (not QR_6))  # machine 6 is not where it was commanded
        STI_Gs1 = (CN_Gs1 and (not QN_Gs1)) or (CR_Gs1 and (not QR_Gs1))  # machine Gs1 is not where it was commanded
        STI_LC1 = (CN_LC1 and (not QN_LC1)) or (CR_LC1 and (not QR_LC1))  # machine LC1 is not where it was commanded
        ST_1 = self._timer('ST_1', STI_1, dt_ms)  # machine 1: time-out
        ST_2 = self._timer('ST_2', STI_2, dt_ms)  # machine 2: time-out
        ST_5 = self._timer('ST_5', STI_5, dt_ms)  # machine 5: time-out
        ST_6 = self._timer('ST_6', STI_6, dt_ms)  # machine 6: time-out
        ST_Gs1 = self._timer('ST_Gs1', STI_Gs1, dt_ms)  # machine Gs1: time-out
        ST_LC1 = self._timer('ST_LC1', STI_LC1, dt_ms)  # machine LC1: time-out
        KP_R1 = (not NU_w6_1) and (not CD_F)  # route F-B stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_F) and (not CAN_F) and (S_R1 or RL_F)  # proceed for route F-B (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route F-B: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_w5_3) and (not CD_L5)  # route L5-N8 stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_L5) and (not CAN_L5) and (S_R2 or RL_L5)  # proceed for route L5-N8 (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route L5-N8: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_w2_1) and (not CD_N2)  # route N2-F stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_N2) and (not CAN_N2) and (S_R3 or RL_N2)  # proceed for route N2-F (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route N2-F: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_w2_1) and (not CD_N2)  # route N2-F.o2 stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_N2) and (not CAN_N2) and (S_R4 or RL_N2)  # proceed for route N2-F.o2 (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route N2-F.o2: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_w2_3) and (not CD_N8)  # route N8-F stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_N8) and (not CAN_N8) and (S_R5 or RL_N8)  # proceed for route N8-F (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route N8-F: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_w2_3) and (not CD_N8)  # route N8-F.o2 stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_N8) and (not CAN_N8) and (S_R6 or RL_N8)  # proceed for route N8-F.o2 (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route N8-F.o2: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_w1_2) and (not CD_S1)  # route S1-N2 stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_S1) and (not CAN_S1) and (S_R7 or RL_S1)  # proceed for route S1-N2 (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route S1-N2: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_w1_2) and (not CD_S1)  # route S1-N8 stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_S1) and (not CAN_S1) and (S_R8 or RL_S1)  # proceed for route S1-N8 (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route S1-N8: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_w0_1) and (not CD_SA)  # route SA-S1 stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_SA) and (not CAN_SA) and (S_R9 or RL_SA)  # proceed for route SA-S1 (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route SA-S1: a condition was lost; no reopening by itself (R14)
        KP_R10 = (not NU_w0_1) and (not CD_SA)  # route SA-S1.o2 stays set
        PR_R10 = A_R10 and B_R10 and W_R10 and CO_R10 and KP_R10 and (not X_SA) and (not CAN_SA) and (S_R10 or RL_SA)  # proceed for route SA-S1.o2 (R3, R11)
        LS_R10 = S_R10 and (not CO_R10)  # route SA-S1.o2: a condition was lost; no reopening by itself (R14)
        N_CN_1 = GPN_1 or MAN_1 or HDN_1  # machine 1 commanded N
        N_CR_1 = GPR_1 or MAR_1 or HDR_1  # machine 1 commanded R
        N_CN_2 = GPN_2 or MAN_2 or HDN_2  # machine 2 commanded N
        N_CR_2 = GPR_2 or MAR_2 or HDR_2  # machine 2 commanded R
        N_CN_5 = GPN_5 or MAN_5 or HDN_5  # machine 5 commanded N
        N_CR_5 = GPR_5 or MAR_5 or HDR_5  # machine 5 commanded R
        N_CN_6 = GPN_6 or MAN_6 or HDN_6  # machine 6 commanded N
        N_CR_6 = GPR_6 or MAR_6 or HDR_6  # machine 6 commanded R
        N_CN_Gs1 = GPN_Gs1 or MAN_Gs1 or HDN_Gs1  # machine Gs1 commanded N
        N_CR_Gs1 = GPR_Gs1 or MAR_Gs1 or HDR_Gs1  # machine Gs1 commanded R
        N_CN_LC1 = GPN_LC1 or MAN_LC1 or HDN_LC1  # machine LC1 commanded N
        N_CR_LC1 = GPR_LC1 or MAR_LC1 or HDR_LC1  # machine LC1 commanded R
        N_AL_1 = ST_1  # alarm: machine 1 not detected
        N_AL_2 = ST_2  # alarm: machine 2 not detected
        N_AL_5 = ST_5  # alarm: machine 5 not detected
        N_AL_6 = ST_6  # alarm: machine 6 not detected
        N_AL_Gs1 = ST_Gs1  # alarm: machine Gs1 not detected
        N_AL_LC1 = ST_LC1  # alarm: machine LC1 not detected
        N_TH_1 = ((CN_1 and QN_1) or (CR_1 and QR_1)) and (not (GPN_1 or GPR_1 or MAN_1 or MAR_1))  # machine 1 was detected where it is commanded
        N_TR_1 = (TH_1 and VALID and ((CN_1 and (not QN_1) and (not GPR_1) and (not MAR_1)) or (CR_1 and (not QR_1) and (not GPN_1) and (not MAN_1)))) or (TR_1 and (not (TC_1 and VALID and (not OCC_w1))))  # machine 1 was trailed
        N_TH_2 = ((CN_2 and QN_2) or (CR_2 and QR_2)) and (not (GPN_2 or GPR_2 or MAN_2 or MAR_2))  # machine 2 was detected where it is commanded
        N_TR_2 = (TH_2 and VALID and ((CN_2 and (not QN_2) and (not GPR_2) and (not MAR_2)) or (CR_2 and (not QR_2) and (not GPN_2) and (not MAN_2)))) or (TR_2 and (not (TC_2 and VALID and (not OCC_w2))))  # machine 2 was trailed
        N_TH_5 = ((CN_5 and QN_5) or (CR_5 and QR_5)) and (not (GPN_5 or GPR_5 or MAN_5 or MAR_5))  # machine 5 was detected where it is commanded
        N_TR_5 = (TH_5 and VALID and ((CN_5 and (not QN_5) and (not GPR_5) and (not MAR_5)) or (CR_5 and (not QR_5) and (not GPN_5) and (not MAN_5)))) or (TR_5 and (not (TC_5 and VALID and (not OCC_w5))))  # machine 5 was trailed
        N_TH_6 = ((CN_6 and QN_6) or (CR_6 and QR_6)) and (not (GPN_6 or GPR_6 or MAN_6 or MAR_6))  # machine 6 was detected where it is commanded
        N_TR_6 = (TH_6 and VALID and ((CN_6 and (not QN_6) and (not GPR_6) and (not MAR_6)) or (CR_6 and (not QR_6) and (not GPN_6) and (not MAN_6)))) or (TR_6 and (not (TC_6 and VALID and (not OCC_w6))))  # machine 6 was trailed
        N_TH_Gs1 = ((CN_Gs1 and QN_Gs1) or (CR_Gs1 and QR_Gs1)) and (not (GPN_Gs1 or GPR_Gs1 or MAN_Gs1 or MAR_Gs1))  # machine Gs1 was detected where it is commanded
        N_TR_Gs1 = (TH_Gs1 and VALID and ((CN_Gs1 and (not QN_Gs1) and (not GPR_Gs1) and (not MAR_Gs1)) or (CR_Gs1 and (not QR_Gs1) and (not GPN_Gs1) and (not MAN_Gs1)))) or (TR_Gs1 and (not (TC_Gs1 and VALID and (not OCC_w5))))  # machine Gs1 was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route F-B active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route F-B locked
        N_W_R1 = (W_R1 or LK_R1 or ((REQ == 1) and B_R1)) and (not LS_R1) and KP_R1 and (not X_F) and (not CAN_F)  # route F-B: proceed wanted
        N_S_R1 = PR_R1  # route F-B: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route F-B: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route L5-N8 active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route L5-N8 locked
        N_W_R2 = (W_R2 or LK_R2 or ((REQ == 2) and B_R2)) and (not LS_R2) and KP_R2 and (not X_L5) and (not CAN_L5)  # route L5-N8: proceed wanted
        N_S_R2 = PR_R2  # route L5-N8: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route L5-N8: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route N2-F active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route N2-F locked
        N_W_R3 = (W_R3 or LK_R3 or ((REQ == 3) and B_R3)) and (not LS_R3) and KP_R3 and (not X_N2) and (not CAN_N2)  # route N2-F: proceed wanted
        N_S_R3 = PR_R3  # route N2-F: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route N2-F: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route N2-F.o2 active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route N2-F.o2 locked
        N_W_R4 = (W_R4 or LK_R4 or ((REQ == 4) and B_R4)) and (not LS_R4) and KP_R4 and (not X_N2) and (not CAN_N2)  # route N2-F.o2: proceed wanted
        N_S_R4 = PR_R4  # route N2-F.o2: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route N2-F.o2: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route N8-F active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route N8-F locked
        N_W_R5 = (W_R5 or LK_R5 or ((REQ == 5) and B_R5)) and (not LS_R5) and KP_R5 and (not X_N8) and (not CAN_N8)  # route N8-F: proceed wanted
        N_S_R5 = PR_R5  # route N8-F: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route N8-F: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route N8-F.o2 active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route N8-F.o2 locked
        N_W_R6 = (W_R6 or LK_R6 or ((REQ == 6) and B_R6)) and (not LS_R6) and KP_R6 and (not X_N8) and (not CAN_N8)  # route N8-F.o2: proceed wanted
        N_S_R6 = PR_R6  # route N8-F.o2: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route N8-F.o2: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route S1-N2 active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route S1-N2 locked
        N_W_R7 = (W_R7 or LK_R7 or ((REQ == 7) and B_R7)) and (not LS_R7) and KP_R7 and (not X_S1) and (not CAN_S1)  # route S1-N2: proceed wanted
        N_S_R7 = PR_R7  # route S1-N2: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route S1-N2: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route S1-N8 active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route S1-N8 locked
        N_W_R8 = (W_R8 or LK_R8 or ((REQ == 8) and B_R8)) and (not LS_R8) and KP_R8 and (not X_S1) and (not CAN_S1)  # route S1-N8: proceed wanted
        N_S_R8 = PR_R8  # route S1-N8: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route S1-N8: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route SA-S1 active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route SA-S1 locked
        N_W_R9 = (W_R9 or LK_R9 or ((REQ == 9) and B_R9)) and (not LS_R9) and KP_R9 and (not X_SA) and (not CAN_SA)  # route SA-S1: proceed wanted
        N_S_R9 = PR_R9  # route SA-S1: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route SA-S1: signal has been open
        N_A_R10 = (A_R10 or G_R10) and KP_R10  # route SA-S1.o2 active
        N_B_R10 = (B_R10 or LK_R10) and KP_R10  # route SA-S1.o2 locked
        N_W_R10 = (W_R10 or LK_R10 or ((REQ == 10) and B_R10)) and (not LS_R10) and KP_R10 and (not X_SA) and (not CAN_SA)  # route SA-S1.o2: proceed wanted
        N_S_R10 = PR_R10  # route SA-S1.o2: proceed
        N_H_R10 = (H_R10 or PR_R10) and KP_R10  # route SA-S1.o2: signal has been open
        N_X_F = (X_F or CAN_F) and A_R1 and (not CD_F)  # F: cancelling
        N_X_L5 = (X_L5 or CAN_L5) and A_R2 and (not CD_L5)  # L5: cancelling
        N_X_N2 = (X_N2 or CAN_N2) and (A_R3 or A_R4) and (not CD_N2)  # N2: cancelling
        N_X_N8 = (X_N8 or CAN_N8) and (A_R5 or A_R6) and (not CD_N8)  # N8: cancelling
        N_X_S1 = (X_S1 or CAN_S1) and (A_R7 or A_R8) and (not CD_S1)  # S1: cancelling
        N_X_SA = (X_SA or CAN_SA) and (A_R9 or A_R10) and (not CD_SA)  # SA: cancelling
        N_K_g2 = K_g2 and (not RLS_g2)  # g2: restart lock (R16)
        N_L_g2_1 = (L_g2_1 or GW_g2_1) and (not RLS_g2)  # g2 locked from g2|w1@1.normal to g2|w2@2.normal
        N_M_g2 = (M_g2 or G_R7) and (not RLS_g2)  # g2 locked for a train movement
        N_F_g2 = (F_g2 or LK_R7) and (not RLS_g2)  # g2 firmly locked
        N_U_g2 = (U_g2 or NU_g2_1) and (not RLS_g2)  # g2 used by a train (R9)
        N_P_g2 = (P_g2 or (U_g2 and OCC_g2 and NU_w2_1)) and (not RLS_g2)  # g2: the train went on (R9)
        N_D_g2 = (D_g2 or ((not VALID) and L_g2_1)) and (not RLS_g2)  # g2: detection is not relied on, inputs were lost or a train is called on
        N_K_g4 = K_g4 and (not RLS_g4)  # g4: restart lock (R16)
        N_L_g4_1 = (L_g4_1 or GW_g4_1) and (not RLS_g4)  # g4 locked from g4|w2@2.toe to g4|w6@6.toe
        N_M_g4 = (M_g4 or G_R3 or G_R4 or G_R5 or G_R6) and (not RLS_g4)  # g4 locked for a train movement
        N_F_g4 = (F_g4 or LK_R3 or LK_R4 or LK_R5 or LK_R6) and (not RLS_g4)  # g4 firmly locked
        N_U_g4 = (U_g4 or NU_g4_1) and (not RLS_g4)  # g4 used by a train (R9)
        N_P_g4 = (P_g4 or (U_g4 and OCC_g4 and NU_w6_1)) and (not RLS_g4)  # g4: the train went on (R9)
        N_D_g4 = (D_g4 or ((not VALID) and L_g4_1)) and (not RLS_g4)  # g4: detection is not relied on, inputs were lost or a train is called on
        N_K_g5 = K_g5 and (not RLS_g5)  # g5: restart lock (R16)
        N_L_g5_2 = (L_g5_2 or GW_g5_2) and (not RLS_g5)  # g5 locked from g5|w6@6.normal to B
        N_M_g5 = (M_g5 or G_R1) and (not RLS_g5)  # g5 locked for a train movement
        N_F_g5 = (F_g5 or LK_R1) and (not RLS_g5)  # g5 firmly locked
        N_U_g5 = (U_g5 or NU_g5_2) and (not RLS_g5)  # g5 used by a train (R9)
        N_P_g5 = P_g5 and (not RLS_g5)  # g5: the train went on (R9)
        N_D_g5 = (D_g5 or ((not VALID) and L_g5_2)) and (not RLS_g5)  # g5: detection is not relied on, inputs were lost or a train is called on
        N_K_g6 = K_g6 and (not RLS_g6)  # g6: restart lock (R16)
        N_L_g6_2 = L_g6_2 and (not RLS_g6)  # g6 locked from g6|w6@6.reverse to C
        N_M_g6 = M_g6 and (not RLS_g6)  # g6 locked for a train movement
        N_F_g6 = F_g6 and (not RLS_g6)  # g6 firmly locked
        N_U_g6 = (U_g6 or NU_g6_2) and (not RLS_g6)  # g6 used by a train (R9)
        N_P_g6 = P_g6 and (not RLS_g6)  # g6: the train went on (R9)
        N_D_g6 = (D_g6 or ((not VALID) and L_g6_2)) and (not RLS_g6)  # g6: detection is not relied on, inputs were lost or a train is called on
        N_K_g8 = K_g8 and (not RLS_g8)  # g8: restart lock (R16)
        N_L_g8_2 = (L_g8_2 or GW_g8_2) and (not RLS_g8)  # g8 locked from g8|w5@5.toe to g8|w2@2.reverse
        N_M_g8 = (M_g8 or G_R8) and (not RLS_g8)  # g8 locked for a train movement
        N_F_g8 = (F_g8 or LK_R2 or LK_R8) and (not RLS_g8)  # g8 firmly locked
        N_U_g8 = (U_g8 or NU_g8_2) and (not RLS_g8)  # g8 used by a train (R9)
        N_P_g8 = (P_g8 or (U_g8 and OCC_g8 and NU_w2_3)) and (not RLS_g8)  # g8: the train went on (R9)
        N_D_g8 = (D_g8 or ((not VALID) and L_g8_2)) and (not RLS_g8)  # g8: detection is not relied on, inputs were lost or a train is called on
        N_K_sid = K_sid and (not RLS_sid)  # sid: restart lock (R16)
        N_M_sid = M_sid and (not RLS_sid)  # sid locked for a train movement
        N_F_sid = F_sid and (not RLS_sid)  # sid firmly locked
        N_U_sid = U_sid and (not RLS_sid)  # sid used by a train (R9)
        N_P_sid = (P_sid or (U_sid and OCC_sid and NU_w5_3)) and (not RLS_sid)  # sid: the train went on (R9)
        N_D_sid = D_sid and (not RLS_sid)  # sid: detection is not relied on, inputs were lost or a train is called on
        N_K_w0 = K_w0 and (not RLS_w0)  # w0: restart lock (R16)
        N_L_w0_1 = (L_w0_1 or GW_w0_1) and (not RLS_w0)  # w0 locked from A to w0|w1@1.toe
        N_M_w0 = (M_w0 or G_R9 or G_R10) and (not RLS_w0)  # w0 locked for a train movement
        N_F_w0 = (F_w0 or LK_R9 or LK_R10) and (not RLS_w0)  # w0 firmly locked
        N_U_w0 = (U_w0 or NU_w0_1) and (not RLS_w0)  # w0 used by a train (R9)
        N_P_w0 = (P_w0 or (U_w0 and OCC_w0 and NU_w1_2)) and (not RLS_w0)  # w0: the train went on (R9)
        N_D_w0 = (D_w0 or ((not VALID) and L_w0_1)) and (not RLS_w0)  # w0: detection is not relied on, inputs were lost or a train is called on
        N_K_w1 = K_w1 and (not RLS_w1)  # w1: restart lock (R16)
        N_L_w1_2 = (L_w1_2 or GW_w1_2) and (not RLS_w1)  # w1 locked from w0|w1@1.toe to g2|w1@1.normal
        N_L_w1_3 = (L_w1_3 or GW_w1_3) and (not RLS_w1)  # w1 locked from w0|w1@1.toe to w1|w5@1.reverse
        N_M_w1 = (M_w1 or G_R7 or G_R8) and (not RLS_w1)  # w1 locked for a train movement
        N_F_w1 = (F_w1 or LK_R7 or LK_R8) and (not RLS_w1)  # w1 firmly locked
        N_U_w1 = (U_w1 or NU_w1_2) and (not RLS_w1)  # w1 used by a train (R9)
        N_P_w1 = (P_w1 or (U_w1 and OCC_w1 and (NU_g2_1 or NU_w5_4))) and (not RLS_w1)  # w1: the train went on (R9)
        N_D_w1 = (D_w1 or ((not VALID) and (L_w1_2 or L_w1_3))) and (not RLS_w1)  # w1: detection is not relied on, inputs were lost or a train is called on
        N_K_w2 = K_w2 and (not RLS_w2)  # w2: restart lock (R16)
        N_L_w2_1 = (L_w2_1 or GW_w2_1) and (not RLS_w2)  # w2 locked from g2|w2@2.normal to g4|w2@2.toe
        N_L_w2_4 = (L_w2_4 or GW_w2_4) and (not RLS_w2)  # w2 locked from g8|w2@2.reverse to g4|w2@2.toe
        N_M_w2 = (M_w2 or G_R3 or G_R4 or G_R5 or G_R6) and (not RLS_w2)  # w2 locked for a train movement
        N_F_w2 = (F_w2 or LK_R3 or LK_R4 or LK_R5 or LK_R6) and (not RLS_w2)  # w2 firmly locked
        N_U_w2 = (U_w2 or NU_w2_1 or NU_w2_3) and (not RLS_w2)  # w2 used by a train (R9)
        N_P_w2 = (P_w2 or (U_w2 and OCC_w2 and NU_g4_1)) and (not RLS_w2)  # w2: the train went on (R9)
        N_D_w2 = (D_w2 or ((not VALID) and (L_w2_1 or L_w2_4))) and (not RLS_w2)  # w2: detection is not relied on, inputs were lost or a train is called on
        N_K_w5 = K_w5 and (not RLS_w5)  # w5: restart lock (R16)
        N_L_w5_4 = (L_w5_4 or GW_w5_4) and (not RLS_w5)  # w5 locked from sid|w5@Gs1.outer to g8|w5@5.toe
        N_L_w5_5 = (L_w5_5 or GW_w5_5) and (not RLS_w5)  # w5 locked from w1|w5@1.reverse to g8|w5@5.toe
        N_M_w5 = (M_w5 or G_R8) and (not RLS_w5)  # w5 locked for a train movement
        N_F_w5 = (F_w5 or LK_R2 or LK_R8) and (not RLS_w5)  # w5 firmly locked
        N_U_w5 = (U_w5 or NU_w5_3 or NU_w5_4) and (not RLS_w5)  # w5 used by a train (R9)
        N_P_w5 = (P_w5 or (U_w5 and OCC_w5 and NU_g8_2)) and (not RLS_w5)  # w5: the train went on (R9)
        N_D_w5 = (D_w5 or ((not VALID) and (L_w5_4 or L_w5_5))) and (not RLS_w5)  # w5: detection is not relied on, inputs were lost or a train is called on
        N_K_w6 = K_w6 and (not RLS_w6)  # w6: restart lock (R16)
        N_L_w6_1 = (L_w6_1 or GW_w6_1) and (not RLS_w6)  # w6 locked from g4|w6@6.toe to g5|w6@6.normal
        N_L_w6_2 = L_w6_2 and (not RLS_w6)  # w6 locked from g4|w6@6.toe to g6|w6@6.reverse
        N_M_w6 = (M_w6 or G_R1) and (not RLS_w6)  # w6 locked for a train movement
        N_F_w6 = (F_w6 or LK_R1) and (not RLS_w6)  # w6 firmly locked
        N_U_w6 = (U_w6 or NU_w6_1) and (not RLS_w6)  # w6 used by a train (R9)
        N_P_w6 = (P_w6 or (U_w6 and OCC_w6 and (NU_g5_2 or NU_g6_2))) and (not RLS_w6)  # w6: the train went on (R9)
        N_D_w6 = (D_w6 or ((not VALID) and (L_w6_1 or L_w6_2))) and (not RLS_w6)  # w6: detection is not relied on, inputs were lost or a train is called on
        N_V_F_1 = (GO_F_1 or SW1_1) or (V_F_1 and (not (OR_F and (not OCC_w6) and (not OCC_g5))) and (not SW1_2))  # overlap 1 of F held
        N_V_F_2 = (GO_F_2 or SW1_2) or (V_F_2 and (not (OR_F and (not OCC_w6) and (not OCC_g6))) and (not SW1_1))  # overlap 2 of F held
        N_V_N2_1 = GO_N2_1 or (V_N2_1 and (not (OR_N2 and (not OCC_w2) and (not OCC_g4))))  # overlap 1 of N2 held
        N_V_S1_1 = GO_S1_1 or (V_S1_1 and (not (OR_S1 and (not OCC_w1) and (not OCC_g2))))  # overlap 1 of S1 held
        N_V_S1_2 = GO_S1_2 or (V_S1_2 and (not (OR_S1 and (not OCC_w1) and (not OCC_w5) and (not OCC_g8))))  # overlap 2 of S1 held
        N_VF_F = (VF_F or (VS_F and OL_F) or LK_R3 or LK_R4 or LK_R5 or LK_R6) and (V_F_1 or V_F_2) and (not SW1_1) and (not SW1_2)  # overlap of F firmly held
        N_VS_F = ((VS_F and (not OL_F)) or SW1_1 or SW1_2) and (V_F_1 or V_F_2)  # the overlap of F swings
        N_VF_N2 = (VF_N2 or LK_R7) and V_N2_1  # overlap of N2 firmly held
        N_VF_S1 = (VF_S1 or LK_R9 or LK_R10) and (V_S1_1 or V_S1_2)  # overlap of S1 firmly held
        N_C_F = PR_R1 and PR_R1 and GL_F  # F shows clear
        N_C_N2 = (PR_R3 or PR_R4) and ((PR_R3 and PR_R1) or (PR_R4 and PR_R1)) and GL_N2  # N2 shows clear
        N_C_N8 = (PR_R5 or PR_R6) and False and GL_N8  # N8 shows clear
        N_C_S1 = (PR_R7 or PR_R8) and (PR_R7 and (PR_R3 or PR_R4)) and GL_S1  # S1 shows clear
        N_C_SA = (PR_R9 or PR_R10) and ((PR_R9 and (PR_R7 or PR_R8)) or (PR_R10 and (PR_R7 or PR_R8))) and GL_SA  # SA shows clear
        self.state = {
            'CN_1': bool(N_CN_1),
            'CR_1': bool(N_CR_1),
            'CN_2': bool(N_CN_2),
            'CR_2': bool(N_CR_2),
            'CN_5': bool(N_CN_5),
            'CR_5': bool(N_CR_5),
            'CN_6': bool(N_CN_6),
            'CR_6': bool(N_CR_6),
            'CN_Gs1': bool(N_CN_Gs1),
            'CR_Gs1': bool(N_CR_Gs1),
            'CN_LC1': bool(N_CN_LC1),
            'CR_LC1': bool(N_CR_LC1),
            'AL_1': bool(N_AL_1),
            'AL_2': bool(N_AL_2),
            'AL_5': bool(N_AL_5),
            'AL_6': bool(N_AL_6),
            'AL_Gs1': bool(N_AL_Gs1),
            'AL_LC1': bool(N_AL_LC1),
            'TH_1': bool(N_TH_1),
            'TR_1': bool(N_TR_1),
            'TH_2': bool(N_TH_2),
            'TR_2': bool(N_TR_2),
            'TH_5': bool(N_TH_5),
            'TR_5': bool(N_TR_5),
            'TH_6': bool(N_TH_6),
            'TR_6': bool(N_TR_6),
            'TH_Gs1': bool(N_TH_Gs1),
            'TR_Gs1': bool(N_TR_Gs1),
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
            'X_F': bool(N_X_F),
            'X_L5': bool(N_X_L5),
            'X_N2': bool(N_X_N2),
            'X_N8': bool(N_X_N8),
            'X_S1': bool(N_X_S1),
            'X_SA': bool(N_X_SA),
            'K_g2': bool(N_K_g2),
            'L_g2_1': bool(N_L_g2_1),
            'M_g2': bool(N_M_g2),
            'F_g2': bool(N_F_g2),
            'U_g2': bool(N_U_g2),
            'P_g2': bool(N_P_g2),
            'D_g2': bool(N_D_g2),
            'K_g4': bool(N_K_g4),
            'L_g4_1': bool(N_L_g4_1),
            'M_g4': bool(N_M_g4),
            'F_g4': bool(N_F_g4),
            'U_g4': bool(N_U_g4),
            'P_g4': bool(N_P_g4),
            'D_g4': bool(N_D_g4),
            'K_g5': bool(N_K_g5),
            'L_g5_2': bool(N_L_g5_2),
            'M_g5': bool(N_M_g5),
            'F_g5': bool(N_F_g5),
            'U_g5': bool(N_U_g5),
            'P_g5': bool(N_P_g5),
            'D_g5': bool(N_D_g5),
            'K_g6': bool(N_K_g6),
            'L_g6_2': bool(N_L_g6_2),
            'M_g6': bool(N_M_g6),
            'F_g6': bool(N_F_g6),
            'U_g6': bool(N_U_g6),
            'P_g6': bool(N_P_g6),
            'D_g6': bool(N_D_g6),
            'K_g8': bool(N_K_g8),
            'L_g8_2': bool(N_L_g8_2),
            'M_g8': bool(N_M_g8),
            'F_g8': bool(N_F_g8),
            'U_g8': bool(N_U_g8),
            'P_g8': bool(N_P_g8),
            'D_g8': bool(N_D_g8),
            'K_sid': bool(N_K_sid),
            'M_sid': bool(N_M_sid),
            'F_sid': bool(N_F_sid),
            'U_sid': bool(N_U_sid),
            'P_sid': bool(N_P_sid),
            'D_sid': bool(N_D_sid),
            'K_w0': bool(N_K_w0),
            'L_w0_1': bool(N_L_w0_1),
            'M_w0': bool(N_M_w0),
            'F_w0': bool(N_F_w0),
            'U_w0': bool(N_U_w0),
            'P_w0': bool(N_P_w0),
            'D_w0': bool(N_D_w0),
            'K_w1': bool(N_K_w1),
            'L_w1_2': bool(N_L_w1_2),
            'L_w1_3': bool(N_L_w1_3),
            'M_w1': bool(N_M_w1),
            'F_w1': bool(N_F_w1),
            'U_w1': bool(N_U_w1),
            'P_w1': bool(N_P_w1),
            'D_w1': bool(N_D_w1),
            'K_w2': bool(N_K_w2),
            'L_w2_1': bool(N_L_w2_1),
            'L_w2_4': bool(N_L_w2_4),
            'M_w2': bool(N_M_w2),
            'F_w2': bool(N_F_w2),
            'U_w2': bool(N_U_w2),
            'P_w2': bool(N_P_w2),
            'D_w2': bool(N_D_w2),
            'K_w5': bool(N_K_w5),
            'L_w5_4': bool(N_L_w5_4),
            'L_w5_5': bool(N_L_w5_5),
            'M_w5': bool(N_M_w5),
            'F_w5': bool(N_F_w5),
            'U_w5': bool(N_U_w5),
            'P_w5': bool(N_P_w5),
            'D_w5': bool(N_D_w5),
            'K_w6': bool(N_K_w6),
            'L_w6_1': bool(N_L_w6_1),
            'L_w6_2': bool(N_L_w6_2),
            'M_w6': bool(N_M_w6),
            'F_w6': bool(N_F_w6),
            'U_w6': bool(N_U_w6),
            'P_w6': bool(N_P_w6),
            'D_w6': bool(N_D_w6),
            'V_F_1': bool(N_V_F_1),
            'V_F_2': bool(N_V_F_2),
            'V_N2_1': bool(N_V_N2_1),
            'V_S1_1': bool(N_V_S1_1),
            'V_S1_2': bool(N_V_S1_2),
            'VF_F': bool(N_VF_F),
            'VS_F': bool(N_VS_F),
            'VF_N2': bool(N_VF_N2),
            'VF_S1': bool(N_VF_S1),
            'C_F': bool(N_C_F),
            'C_N2': bool(N_C_N2),
            'C_N8': bool(N_C_N8),
            'C_S1': bool(N_C_S1),
            'C_SA': bool(N_C_SA),
        }
        CN_1 = self.state['CN_1']
        CR_1 = self.state['CR_1']
        CN_2 = self.state['CN_2']
        CR_2 = self.state['CR_2']
        CN_5 = self.state['CN_5']
        CR_5 = self.state['CR_5']
        CN_6 = self.state['CN_6']
        CR_6 = self.state['CR_6']
        CN_Gs1 = self.state['CN_Gs1']
        CR_Gs1 = self.state['CR_Gs1']
        CN_LC1 = self.state['CN_LC1']
        CR_LC1 = self.state['CR_LC1']
        AL_1 = self.state['AL_1']
        AL_2 = self.state['AL_2']
        AL_5 = self.state['AL_5']
        AL_6 = self.state['AL_6']
        AL_Gs1 = self.state['AL_Gs1']
        AL_LC1 = self.state['AL_LC1']
        TH_1 = self.state['TH_1']
        TR_1 = self.state['TR_1']
        TH_2 = self.state['TH_2']
        TR_2 = self.state['TR_2']
        TH_5 = self.state['TH_5']
        TR_5 = self.state['TR_5']
        TH_6 = self.state['TH_6']
        TR_6 = self.state['TR_6']
        TH_Gs1 = self.state['TH_Gs1']
        TR_Gs1 = self.state['TR_Gs1']
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
        X_F = self.state['X_F']
        X_L5 = self.state['X_L5']
        X_N2 = self.state['X_N2']
        X_N8 = self.state['X_N8']
        X_S1 = self.state['X_S1']
        X_SA = self.state['X_SA']
        K_g2 = self.state['K_g2']
        L_g2_1 = self.state['L_g2_1']
        M_g2 = self.state['M_g2']
        F_g2 = self.state['F_g2']
        U_g2 = self.state['U_g2']
        P_g2 = self.state['P_g2']
        D_g2 = self.state['D_g2']
        K_g4 = self.state['K_g4']
        L_g4_1 = self.state['L_g4_1']
        M_g4 = self.state['M_g4']
        F_g4 = self.state['F_g4']
        U_g4 = self.state['U_g4']
        P_g4 = self.state['P_g4']
        D_g4 = self.state['D_g4']
        K_g5 = self.state['K_g5']
        L_g5_2 = self.state['L_g5_2']
        M_g5 = self.state['M_g5']
        F_g5 = self.state['F_g5']
        U_g5 = self.state['U_g5']
        P_g5 = self.state['P_g5']
        D_g5 = self.state['D_g5']
        K_g6 = self.state['K_g6']
        L_g6_2 = self.state['L_g6_2']
        M_g6 = self.state['M_g6']
        F_g6 = self.state['F_g6']
        U_g6 = self.state['U_g6']
        P_g6 = self.state['P_g6']
        D_g6 = self.state['D_g6']
        K_g8 = self.state['K_g8']
        L_g8_2 = self.state['L_g8_2']
        M_g8 = self.state['M_g8']
        F_g8 = self.state['F_g8']
        U_g8 = self.state['U_g8']
        P_g8 = self.state['P_g8']
        D_g8 = self.state['D_g8']
        K_sid = self.state['K_sid']
        M_sid = self.state['M_sid']
        F_sid = self.state['F_sid']
        U_sid = self.state['U_sid']
        P_sid = self.state['P_sid']
        D_sid = self.state['D_sid']
        K_w0 = self.state['K_w0']
        L_w0_1 = self.state['L_w0_1']
        M_w0 = self.state['M_w0']
        F_w0 = self.state['F_w0']
        U_w0 = self.state['U_w0']
        P_w0 = self.state['P_w0']
        D_w0 = self.state['D_w0']
        K_w1 = self.state['K_w1']
        L_w1_2 = self.state['L_w1_2']
        L_w1_3 = self.state['L_w1_3']
        M_w1 = self.state['M_w1']
        F_w1 = self.state['F_w1']
        U_w1 = self.state['U_w1']
        P_w1 = self.state['P_w1']
        D_w1 = self.state['D_w1']
        K_w2 = self.state['K_w2']
        L_w2_1 = self.state['L_w2_1']
        L_w2_4 = self.state['L_w2_4']
        M_w2 = self.state['M_w2']
        F_w2 = self.state['F_w2']
        U_w2 = self.state['U_w2']
        P_w2 = self.state['P_w2']
        D_w2 = self.state['D_w2']
        K_w5 = self.state['K_w5']
        L_w5_4 = self.state['L_w5_4']
        L_w5_5 = self.state['L_w5_5']
        M_w5 = self.state['M_w5']
        F_w5 = self.state['F_w5']
        U_w5 = self.state['U_w5']
        P_w5 = self.state['P_w5']
        D_w5 = self.state['D_w5']
        K_w6 = self.state['K_w6']
        L_w6_1 = self.state['L_w6_1']
        L_w6_2 = self.state['L_w6_2']
        M_w6 = self.state['M_w6']
        F_w6 = self.state['F_w6']
        U_w6 = self.state['U_w6']
        P_w6 = self.state['P_w6']
        D_w6 = self.state['D_w6']
        V_F_1 = self.state['V_F_1']
        V_F_2 = self.state['V_F_2']
        V_N2_1 = self.state['V_N2_1']
        V_S1_1 = self.state['V_S1_1']
        V_S1_2 = self.state['V_S1_2']
        VF_F = self.state['VF_F']
        VS_F = self.state['VS_F']
        VF_N2 = self.state['VF_N2']
        VF_S1 = self.state['VF_S1']
        C_F = self.state['C_F']
        C_N2 = self.state['C_N2']
        C_N8 = self.state['C_N8']
        C_S1 = self.state['C_S1']
        C_SA = self.state['C_SA']
        return {
            'YN_1': bool(CN_1),
            'YR_1': bool(CR_1),
            'YN_2': bool(CN_2),
            'YR_2': bool(CR_2),
            'YN_5': bool(CN_5),
            'YR_5': bool(CR_5),
            'YN_6': bool(CN_6),
            'YR_6': bool(CR_6),
            'YN_Gs1': bool(CN_Gs1),
            'YR_Gs1': bool(CR_Gs1),
            'YN_LC1': bool(CN_LC1),
            'YR_LC1': bool(CR_LC1),
            'YA_1': bool(AL_1),
            'YA_2': bool(AL_2),
            'YA_5': bool(AL_5),
            'YA_6': bool(AL_6),
            'YA_Gs1': bool(AL_Gs1),
            'YA_LC1': bool(AL_LC1),
            'YT_1': bool(TR_1),
            'YT_2': bool(TR_2),
            'YT_5': bool(TR_5),
            'YT_6': bool(TR_6),
            'YT_Gs1': bool(TR_Gs1),
            'YL_g2': bool(K_g2 or L_g2_1 or V_S1_1),
            'YL_g4': bool(K_g4 or L_g4_1 or V_N2_1),
            'YL_g5': bool(K_g5 or L_g5_2 or V_F_1),
            'YL_g6': bool(K_g6 or L_g6_2 or V_F_2),
            'YL_g8': bool(K_g8 or L_g8_2 or V_S1_2),
            'YL_sid': bool(K_sid),
            'YL_w0': bool(K_w0 or L_w0_1),
            'YL_w1': bool(K_w1 or L_w1_2 or L_w1_3 or V_S1_1 or V_S1_2),
            'YL_w2': bool(K_w2 or L_w2_1 or L_w2_4 or V_N2_1),
            'YL_w5': bool(K_w5 or L_w5_4 or L_w5_5 or V_S1_2),
            'YL_w6': bool(K_w6 or L_w6_1 or L_w6_2 or V_F_1 or V_F_2),
            'YP_F': bool(C_F),
            'YY_F': bool(S_R1 and (not C_F)),
            'YS_F': bool((not S_R1)),
            'YW_L5': bool(S_R2),
            'YS_L5': bool((not S_R2)),
            'YP_N2': bool(C_N2),
            'YY_N2': bool((S_R3 or S_R4) and (not C_N2)),
            'YV80_N2': bool(S_R3 or S_R4),
            'YS_N2': bool((not (S_R3 or S_R4))),
            'YP_N8': bool(C_N8),
            'YY_N8': bool((S_R5 or S_R6) and (not C_N8)),
            'YV40_N8': bool(S_R5 or S_R6),
            'YS_N8': bool((not (S_R5 or S_R6))),
            'YP_S1': bool(C_S1),
            'YY_S1': bool((S_R7 or S_R8) and (not C_S1)),
            'YV40_S1': bool(S_R8),
            'YV80_S1': bool(S_R7),
            'YS_S1': bool((not (S_R7 or S_R8))),
            'YP_SA': bool(C_SA),
            'YY_SA': bool((S_R9 or S_R10) and (not C_SA)),
            'YS_SA': bool((not (S_R9 or S_R10))),
        }
