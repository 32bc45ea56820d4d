# Interlocking pit_bottom, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout 1b129065d8033943d393835f3f512a4303a8dafa214883bb628d605b48985f27
# claims 8db25ba55a65210d63d1b7e4b4facae3008dc28f9d5c7fbdf0dca3f774de4454
"""Interlocking pit_bottom: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_S0': (0, 2),  # operator: cancel the route from S0
    'CAN_S1': (0, 2),  # operator: cancel the route from S1
    'CAN_S10': (0, 2),  # operator: cancel the route from S10
    'CAN_S11': (0, 2),  # operator: cancel the route from S11
    'CAN_S2': (0, 2),  # operator: cancel the route from S2
    'CAN_S3': (0, 2),  # operator: cancel the route from S3
    'CAN_S4': (0, 2),  # operator: cancel the route from S4
    'CAN_S5': (0, 2),  # operator: cancel the route from S5
    'CAN_S6': (0, 2),  # operator: cancel the route from S6
    'CAN_S7': (0, 2),  # operator: cancel the route from S7
    'CAN_S8': (0, 2),  # operator: cancel the route from S8
    'CAN_S9': (0, 2),  # operator: cancel the route from S9
    'E_PUSHER_HOME': (0, 2),  # external condition PUSHER_HOME: pusher home
    'E_TIP_HOME': (0, 2),  # external condition TIP_HOME: tippler home and clamp released
    'REQ': (0, 17),  # operator: set route number, 0 = none
    'LREQ': (0, 17),  # operator on the spot: set route number, 0 = none
    'CLR_ap_E': (0, 2),  # section ap_E reported clear
    'CLR_ap_W': (0, 2),  # section ap_W reported clear
    'CLR_q1': (0, 2),  # section q1 reported clear
    'CLR_q10_bypass2': (0, 2),  # section q10_bypass2 reported clear
    'CLR_q11_material': (0, 2),  # section q11_material reported clear
    'CLR_q12': (0, 2),  # section q12 reported clear
    'CLR_q13_man': (0, 2),  # section q13_man reported clear
    'CLR_q2': (0, 2),  # section q2 reported clear
    'CLR_q3_heavy': (0, 2),  # section q3_heavy reported clear
    'CLR_q4_tippler': (0, 2),  # section q4_tippler reported clear
    'CLR_q5_bypass1': (0, 2),  # section q5_bypass1 reported clear
    'CLR_q6_empty': (0, 2),  # section q6_empty reported clear
    'CLR_q7': (0, 2),  # section q7 reported clear
    'CLR_q8_dep': (0, 2),  # section q8_dep reported clear
    'CLR_q9': (0, 2),  # section q9 reported clear
    'SH_ap_E': (0, 2),  # detector of ap_E healthy
    'SH_ap_W': (0, 2),  # detector of ap_W healthy
    'SH_q1': (0, 2),  # detector of q1 healthy
    'SH_q10_bypass2': (0, 2),  # detector of q10_bypass2 healthy
    'SH_q11_material': (0, 2),  # detector of q11_material healthy
    'SH_q12': (0, 2),  # detector of q12 healthy
    'SH_q13_man': (0, 2),  # detector of q13_man healthy
    'SH_q2': (0, 2),  # detector of q2 healthy
    'SH_q3_heavy': (0, 2),  # detector of q3_heavy healthy
    'SH_q4_tippler': (0, 2),  # detector of q4_tippler healthy
    'SH_q5_bypass1': (0, 2),  # detector of q5_bypass1 healthy
    'SH_q6_empty': (0, 2),  # detector of q6_empty healthy
    'SH_q7': (0, 2),  # detector of q7 healthy
    'SH_q8_dep': (0, 2),  # detector of q8_dep healthy
    'SH_q9': (0, 2),  # detector of q9 healthy
    'REL_q1': (0, 2),  # operator: release section q1 (hold until released)
    'REL_q10_bypass2': (0, 2),  # operator: release section q10_bypass2 (hold until released)
    'REL_q11_material': (0, 2),  # operator: release section q11_material (hold until released)
    'REL_q12': (0, 2),  # operator: release section q12 (hold until released)
    'REL_q13_man': (0, 2),  # operator: release section q13_man (hold until released)
    'REL_q2': (0, 2),  # operator: release section q2 (hold until released)
    'REL_q3_heavy': (0, 2),  # operator: release section q3_heavy (hold until released)
    'REL_q4_tippler': (0, 2),  # operator: release section q4_tippler (hold until released)
    'REL_q5_bypass1': (0, 2),  # operator: release section q5_bypass1 (hold until released)
    'REL_q6_empty': (0, 2),  # operator: release section q6_empty (hold until released)
    'REL_q7': (0, 2),  # operator: release section q7 (hold until released)
    'REL_q8_dep': (0, 2),  # operator: release section q8_dep (hold until released)
    'REL_q9': (0, 2),  # operator: release section q9 (hold until released)
    'BLK_q1': (1, 2),  # operator: section q1 is blocked
    'BLK_q10_bypass2': (1, 2),  # operator: section q10_bypass2 is blocked
    'BLK_q11_material': (1, 2),  # operator: section q11_material is blocked
    'BLK_q12': (1, 2),  # operator: section q12 is blocked
    'BLK_q13_man': (1, 2),  # operator: section q13_man is blocked
    'BLK_q2': (1, 2),  # operator: section q2 is blocked
    'BLK_q3_heavy': (1, 2),  # operator: section q3_heavy is blocked
    'BLK_q4_tippler': (1, 2),  # operator: section q4_tippler is blocked
    'BLK_q5_bypass1': (1, 2),  # operator: section q5_bypass1 is blocked
    'BLK_q6_empty': (1, 2),  # operator: section q6_empty is blocked
    'BLK_q7': (1, 2),  # operator: section q7 is blocked
    'BLK_q8_dep': (1, 2),  # operator: section q8_dep is blocked
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
    'DN_P3': (0, 2),  # machine P3 detected normal
    'DR_P3': (0, 2),  # machine P3 detected reverse
    'MN_P3': (0, 2),  # operator: move machine P3 normal
    'MR_P3': (0, 2),  # operator: move machine P3 reverse
    'TC_P3': (0, 2),  # operator: machine P3 has been looked at after it was trailed
    'DN_P4': (0, 2),  # machine P4 detected normal
    'DR_P4': (0, 2),  # machine P4 detected reverse
    'MN_P4': (0, 2),  # operator: move machine P4 normal
    'MR_P4': (0, 2),  # operator: move machine P4 reverse
    'TC_P4': (0, 2),  # operator: machine P4 has been looked at after it was trailed
}
# name: value at a restart, meaning
STATE = {
    'CN_P1': False,  # machine P1 commanded N
    'CR_P1': False,  # machine P1 commanded R
    'CN_P2': False,  # machine P2 commanded N
    'CR_P2': False,  # machine P2 commanded R
    'CN_P3': False,  # machine P3 commanded N
    'CR_P3': False,  # machine P3 commanded R
    'CN_P4': False,  # machine P4 commanded N
    'CR_P4': False,  # machine P4 commanded R
    'AL_P1': False,  # alarm: machine P1 not detected
    'AL_P2': False,  # alarm: machine P2 not detected
    'AL_P3': False,  # alarm: machine P3 not detected
    'AL_P4': False,  # alarm: machine P4 not detected
    'TH_P1': False,  # machine P1 was detected where it is commanded
    'TR_P1': False,  # machine P1 was trailed
    'TH_P2': False,  # machine P2 was detected where it is commanded
    'TR_P2': False,  # machine P2 was trailed
    'TH_P3': False,  # machine P3 was detected where it is commanded
    'TR_P3': False,  # machine P3 was trailed
    'TH_P4': False,  # machine P4 was detected where it is commanded
    'TR_P4': False,  # machine P4 was trailed
    'A_R1': False,  # route S0-S1 active
    'B_R1': False,  # route S0-S1 locked
    'W_R1': False,  # route S0-S1: proceed wanted
    'S_R1': False,  # route S0-S1: proceed
    'H_R1': False,  # route S0-S1: signal has been open
    'A_R2': False,  # route S1-S2 active
    'B_R2': False,  # route S1-S2 locked
    'W_R2': False,  # route S1-S2: proceed wanted
    'PA_R2': False,  # route S1-S2: open for the movement that passes S1
    'S_R2': False,  # route S1-S2: proceed
    'H_R2': False,  # route S1-S2: signal has been open
    'A_R3': False,  # route S1-S4 active
    'B_R3': False,  # route S1-S4 locked
    'W_R3': False,  # route S1-S4: proceed wanted
    'PA_R3': False,  # route S1-S4: open for the movement that passes S1
    'S_R3': False,  # route S1-S4: proceed
    'H_R3': False,  # route S1-S4: signal has been open
    'A_R4': False,  # route S10-S11 active
    'B_R4': False,  # route S10-S11 locked
    'W_R4': False,  # route S10-S11: proceed wanted
    'PA_R4': False,  # route S10-S11: open for the movement that passes S10
    'S_R4': False,  # route S10-S11: proceed
    'H_R4': False,  # route S10-S11: signal has been open
    'A_R5': False,  # route S11-W active
    'B_R5': False,  # route S11-W locked
    'W_R5': False,  # route S11-W: proceed wanted
    'PA_R5': False,  # route S11-W: open for the movement that passes S11
    'S_R5': False,  # route S11-W: proceed
    'H_R5': False,  # route S11-W: signal has been open
    'A_R6': False,  # route S2-S3 active
    'B_R6': False,  # route S2-S3 locked
    'W_R6': False,  # route S2-S3: proceed wanted
    'PA_R6': False,  # route S2-S3: open for the movement that passes S2
    'S_R6': False,  # route S2-S3: proceed
    'H_R6': False,  # route S2-S3: signal has been open
    'A_R7': False,  # route S3-E active
    'B_R7': False,  # route S3-E locked
    'W_R7': False,  # route S3-E: proceed wanted
    'PA_R7': False,  # route S3-E: open for the movement that passes S3
    'S_R7': False,  # route S3-E: proceed
    'H_R7': False,  # route S3-E: signal has been open
    'A_R8': False,  # route S3-MAN active
    'B_R8': False,  # route S3-MAN locked
    'W_R8': False,  # route S3-MAN: proceed wanted
    'PA_R8': False,  # route S3-MAN: open for the movement that passes S3
    'S_R8': False,  # route S3-MAN: proceed
    'H_R8': False,  # route S3-MAN: signal has been open
    'A_R9': False,  # route S4-MAT active
    'B_R9': False,  # route S4-MAT locked
    'W_R9': False,  # route S4-MAT: proceed wanted
    'PA_R9': False,  # route S4-MAT: open for the movement that passes S4
    'S_R9': False,  # route S4-MAT: proceed
    'H_R9': False,  # route S4-MAT: signal has been open
    'A_R10': False,  # route S4-S5 active
    'B_R10': False,  # route S4-S5 locked
    'W_R10': False,  # route S4-S5: proceed wanted
    'PA_R10': False,  # route S4-S5: open for the movement that passes S4
    'S_R10': False,  # route S4-S5: proceed
    'H_R10': False,  # route S4-S5: signal has been open
    'A_R11': False,  # route S5-E active
    'B_R11': False,  # route S5-E locked
    'W_R11': False,  # route S5-E: proceed wanted
    'PA_R11': False,  # route S5-E: open for the movement that passes S5
    'S_R11': False,  # route S5-E: proceed
    'H_R11': False,  # route S5-E: signal has been open
    'A_R12': False,  # route S5-MAN active
    'B_R12': False,  # route S5-MAN locked
    'W_R12': False,  # route S5-MAN: proceed wanted
    'PA_R12': False,  # route S5-MAN: open for the movement that passes S5
    'S_R12': False,  # route S5-MAN: proceed
    'H_R12': False,  # route S5-MAN: signal has been open
    'A_R13': False,  # route S6-S11 active
    'B_R13': False,  # route S6-S11 locked
    'W_R13': False,  # route S6-S11: proceed wanted
    'PA_R13': False,  # route S6-S11: open for the movement that passes S6
    'S_R13': False,  # route S6-S11: proceed
    'H_R13': False,  # route S6-S11: signal has been open
    'A_R14': False,  # route S7-S10 active
    'B_R14': False,  # route S7-S10 locked
    'W_R14': False,  # route S7-S10: proceed wanted
    'PA_R14': False,  # route S7-S10: open for the movement that passes S7
    'S_R14': False,  # route S7-S10: proceed
    'H_R14': False,  # route S7-S10: signal has been open
    'A_R15': False,  # route S8-S9 active
    'B_R15': False,  # route S8-S9 locked
    'W_R15': False,  # route S8-S9: proceed wanted
    'S_R15': False,  # route S8-S9: proceed
    'H_R15': False,  # route S8-S9: signal has been open
    'A_R16': False,  # route S9-S10 active
    'B_R16': False,  # route S9-S10 locked
    'W_R16': False,  # route S9-S10: proceed wanted
    'PA_R16': False,  # route S9-S10: open for the movement that passes S9
    'S_R16': False,  # route S9-S10: proceed
    'H_R16': False,  # route S9-S10: signal has been open
    'X_S0': False,  # S0: cancelling
    'X_S1': False,  # S1: cancelling
    'X_S10': False,  # S10: cancelling
    'X_S11': False,  # S11: cancelling
    'X_S2': False,  # S2: cancelling
    'X_S3': False,  # S3: cancelling
    'X_S4': False,  # S4: cancelling
    'X_S5': False,  # S5: cancelling
    'X_S6': False,  # S6: cancelling
    'X_S7': False,  # S7: cancelling
    'X_S8': False,  # S8: cancelling
    'X_S9': False,  # S9: cancelling
    'K_q1': True,  # q1: restart lock (R16)
    'L_q1_1': False,  # q1 locked from W to q1|q2@P1.toe
    'L_q1_2': False,  # q1 locked from q1|q2@P1.toe to W
    'F_q1': False,  # q1 firmly locked
    'U_q1': True,  # q1 used by a train (R9)
    'P_q1': False,  # q1: the train went on (R9)
    'D_q1': False,  # q1: detection is not relied on, inputs were lost or a train is called on
    'K_q10_bypass2': True,  # q10_bypass2: restart lock (R16)
    'L_q10_bypass2_1': False,  # q10_bypass2 locked from q10_bypass2|q7@P2.reverse to q10_bypass2|q9@P3.normal
    'L_q10_bypass2_2': False,  # q10_bypass2 locked from q10_bypass2|q9@P3.normal to q10_bypass2|q7@P2.reverse
    'F_q10_bypass2': False,  # q10_bypass2 firmly locked
    'U_q10_bypass2': True,  # q10_bypass2 used by a train (R9)
    'P_q10_bypass2': False,  # q10_bypass2: the train went on (R9)
    'D_q10_bypass2': False,  # q10_bypass2: detection is not relied on, inputs were lost or a train is called on
    'K_q11_material': True,  # q11_material: restart lock (R16)
    'L_q11_material_2': False,  # q11_material locked from q11_material|q9@P3.reverse to MAT
    'F_q11_material': False,  # q11_material firmly locked
    'U_q11_material': True,  # q11_material used by a train (R9)
    'P_q11_material': False,  # q11_material: the train went on (R9)
    'D_q11_material': False,  # q11_material: detection is not relied on, inputs were lost or a train is called on
    'K_q12': True,  # q12: restart lock (R16)
    'L_q12_1': False,  # q12 locked from q12|q13_man@P4.reverse to q12|q7@P2.toe
    'L_q12_2': False,  # q12 locked from q12|q7@P2.toe to q12|q13_man@P4.reverse
    'L_q12_3': False,  # q12 locked from q12|q7@P2.toe to q12|q8_dep@P4.normal
    'L_q12_4': False,  # q12 locked from q12|q8_dep@P4.normal to q12|q7@P2.toe
    'F_q12': False,  # q12 firmly locked
    'U_q12': True,  # q12 used by a train (R9)
    'P_q12': False,  # q12: the train went on (R9)
    'D_q12': False,  # q12: detection is not relied on, inputs were lost or a train is called on
    'K_q13_man': True,  # q13_man: restart lock (R16)
    'L_q13_man_2': False,  # q13_man locked from q12|q13_man@P4.reverse to MAN
    'F_q13_man': False,  # q13_man firmly locked
    'U_q13_man': True,  # q13_man used by a train (R9)
    'P_q13_man': False,  # q13_man: the train went on (R9)
    'D_q13_man': False,  # q13_man: detection is not relied on, inputs were lost or a train is called on
    'K_q2': True,  # q2: restart lock (R16)
    'L_q2_1': False,  # q2 locked from q1|q2@P1.toe to q2|q3_heavy@P1.normal
    'L_q2_2': False,  # q2 locked from q1|q2@P1.toe to q2|q5_bypass1@P1.reverse
    'L_q2_4': False,  # q2 locked from q2|q5_bypass1@P1.reverse to q1|q2@P1.toe
    'F_q2': False,  # q2 firmly locked
    'U_q2': True,  # q2 used by a train (R9)
    'P_q2': False,  # q2: the train went on (R9)
    'D_q2': False,  # q2: detection is not relied on, inputs were lost or a train is called on
    'K_q3_heavy': True,  # q3_heavy: restart lock (R16)
    'L_q3_heavy_1': False,  # q3_heavy locked from q2|q3_heavy@P1.normal to q3_heavy|q4_tippler@heavy.0
    'F_q3_heavy': False,  # q3_heavy firmly locked
    'U_q3_heavy': True,  # q3_heavy used by a train (R9)
    'P_q3_heavy': False,  # q3_heavy: the train went on (R9)
    'D_q3_heavy': False,  # q3_heavy: detection is not relied on, inputs were lost or a train is called on
    'K_q4_tippler': True,  # q4_tippler: restart lock (R16)
    'L_q4_tippler_1': False,  # q4_tippler locked from q3_heavy|q4_tippler@heavy.0 to q4_tippler|q6_empty@heavy.1
    'F_q4_tippler': False,  # q4_tippler firmly locked
    'U_q4_tippler': True,  # q4_tippler used by a train (R9)
    'P_q4_tippler': False,  # q4_tippler: the train went on (R9)
    'D_q4_tippler': False,  # q4_tippler: detection is not relied on, inputs were lost or a train is called on
    'K_q5_bypass1': True,  # q5_bypass1: restart lock (R16)
    'L_q5_bypass1_1': False,  # q5_bypass1 locked from q2|q5_bypass1@P1.reverse to q5_bypass1|q9@P3.toe
    'L_q5_bypass1_2': False,  # q5_bypass1 locked from q5_bypass1|q9@P3.toe to q2|q5_bypass1@P1.reverse
    'F_q5_bypass1': False,  # q5_bypass1 firmly locked
    'U_q5_bypass1': True,  # q5_bypass1 used by a train (R9)
    'P_q5_bypass1': False,  # q5_bypass1: the train went on (R9)
    'D_q5_bypass1': False,  # q5_bypass1: detection is not relied on, inputs were lost or a train is called on
    'K_q6_empty': True,  # q6_empty: restart lock (R16)
    'L_q6_empty_1': False,  # q6_empty locked from q4_tippler|q6_empty@heavy.1 to q6_empty|q7@P2.normal
    'F_q6_empty': False,  # q6_empty firmly locked
    'U_q6_empty': True,  # q6_empty used by a train (R9)
    'P_q6_empty': False,  # q6_empty: the train went on (R9)
    'D_q6_empty': False,  # q6_empty: detection is not relied on, inputs were lost or a train is called on
    'K_q7': True,  # q7: restart lock (R16)
    'L_q7_1': False,  # q7 locked from q10_bypass2|q7@P2.reverse to q12|q7@P2.toe
    'L_q7_2': False,  # q7 locked from q12|q7@P2.toe to q10_bypass2|q7@P2.reverse
    'L_q7_4': False,  # q7 locked from q6_empty|q7@P2.normal to q12|q7@P2.toe
    'F_q7': False,  # q7 firmly locked
    'U_q7': True,  # q7 used by a train (R9)
    'P_q7': False,  # q7: the train went on (R9)
    'D_q7': False,  # q7: detection is not relied on, inputs were lost or a train is called on
    'K_q8_dep': True,  # q8_dep: restart lock (R16)
    'L_q8_dep_1': False,  # q8_dep locked from E to q12|q8_dep@P4.normal
    'L_q8_dep_2': False,  # q8_dep locked from q12|q8_dep@P4.normal to E
    'F_q8_dep': False,  # q8_dep firmly locked
    'U_q8_dep': True,  # q8_dep used by a train (R9)
    'P_q8_dep': False,  # q8_dep: the train went on (R9)
    'D_q8_dep': False,  # q8_dep: detection is not relied on, inputs were lost or a train is called on
    'K_q9': True,  # q9: restart lock (R16)
    'L_q9_1': False,  # q9 locked from q10_bypass2|q9@P3.normal to q5_bypass1|q9@P3.toe
    'L_q9_2': False,  # q9 locked from q11_material|q9@P3.reverse to q5_bypass1|q9@P3.toe
    'L_q9_3': False,  # q9 locked from q5_bypass1|q9@P3.toe to q10_bypass2|q9@P3.normal
    'L_q9_4': False,  # q9 locked from q5_bypass1|q9@P3.toe to q11_material|q9@P3.reverse
    'F_q9': False,  # q9 firmly locked
    'U_q9': True,  # q9 used by a train (R9)
    'P_q9': False,  # q9: the train went on (R9)
    'D_q9': False,  # q9: detection is not relied on, inputs were lost or a train is called on
    'FA_ap_E': False,  # alarm: detector of ap_E faulty
    'FA_ap_W': False,  # alarm: detector of ap_W faulty
    'FA_q1': False,  # alarm: detector of q1 faulty
    'FA_q10_bypass2': False,  # alarm: detector of q10_bypass2 faulty
    'FA_q11_material': False,  # alarm: detector of q11_material faulty
    'FA_q12': False,  # alarm: detector of q12 faulty
    'FA_q13_man': False,  # alarm: detector of q13_man faulty
    'FA_q2': False,  # alarm: detector of q2 faulty
    'FA_q3_heavy': False,  # alarm: detector of q3_heavy faulty
    'FA_q4_tippler': False,  # alarm: detector of q4_tippler faulty
    'FA_q5_bypass1': False,  # alarm: detector of q5_bypass1 faulty
    'FA_q6_empty': False,  # alarm: detector of q6_empty faulty
    'FA_q7': False,  # alarm: detector of q7 faulty
    'FA_q8_dep': False,  # alarm: detector of q8_dep faulty
    'FA_q9': False,  # alarm: detector of q9 faulty
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_S0': 60000,  # S0: approach locking delay (R8)
    'AT_S1': 60000,  # S1: approach locking delay (R8)
    'AT_S10': 60000,  # S10: approach locking delay (R8)
    'AT_S11': 60000,  # S11: approach locking delay (R8)
    'AT_S2': 60000,  # S2: approach locking delay (R8)
    'AT_S3': 60000,  # S3: approach locking delay (R8)
    'AT_S4': 60000,  # S4: approach locking delay (R8)
    'AT_S5': 60000,  # S5: approach locking delay (R8)
    'AT_S6': 60000,  # S6: approach locking delay (R8)
    'AT_S7': 60000,  # S7: approach locking delay (R8)
    'AT_S8': 60000,  # S8: approach locking delay (R8)
    'AT_S9': 60000,  # S9: approach locking delay (R8)
    'RT_q1': 3000,  # q1: release delay (R9)
    'RT_q10_bypass2': 3000,  # q10_bypass2: release delay (R9)
    'RT_q11_material': 3000,  # q11_material: release delay (R9)
    'RT_q12': 3000,  # q12: release delay (R9)
    'RT_q13_man': 3000,  # q13_man: release delay (R9)
    'RT_q2': 3000,  # q2: release delay (R9)
    'RT_q3_heavy': 3000,  # q3_heavy: release delay (R9)
    'RT_q4_tippler': 3000,  # q4_tippler: release delay (R9)
    'RT_q5_bypass1': 3000,  # q5_bypass1: release delay (R9)
    'RT_q6_empty': 3000,  # q6_empty: release delay (R9)
    'RT_q7': 3000,  # q7: release delay (R9)
    'RT_q8_dep': 3000,  # q8_dep: release delay (R9)
    'RT_q9': 3000,  # q9: release delay (R9)
    'ST_P1': 13000,  # machine P1: time-out
    'ST_P2': 13000,  # machine P2: time-out
    'ST_P3': 13000,  # machine P3: time-out
    'ST_P4': 13000,  # machine P4: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_P1': False,  # machine P1: normal
    'YR_P1': False,  # machine P1: reverse
    'YN_P2': False,  # machine P2: normal
    'YR_P2': False,  # machine P2: reverse
    'YN_P3': False,  # machine P3: normal
    'YR_P3': False,  # machine P3: reverse
    'YN_P4': False,  # machine P4: normal
    'YR_P4': False,  # machine P4: reverse
    'YA_P1': False,  # alarm: machine P1 not detected in time
    'YA_P2': False,  # alarm: machine P2 not detected in time
    'YA_P3': False,  # alarm: machine P3 not detected in time
    'YA_P4': False,  # alarm: machine P4 not detected in time
    'YT_P1': False,  # alarm: machine P1 was trailed
    'YT_P2': False,  # alarm: machine P2 was trailed
    'YT_P3': False,  # alarm: machine P3 was trailed
    'YT_P4': False,  # alarm: machine P4 was trailed
    'YL_q1': True,  # indication: q1 is locked
    'YL_q10_bypass2': True,  # indication: q10_bypass2 is locked
    'YL_q11_material': True,  # indication: q11_material is locked
    'YL_q12': True,  # indication: q12 is locked
    'YL_q13_man': True,  # indication: q13_man is locked
    'YL_q2': True,  # indication: q2 is locked
    'YL_q3_heavy': True,  # indication: q3_heavy is locked
    'YL_q4_tippler': True,  # indication: q4_tippler is locked
    'YL_q5_bypass1': True,  # indication: q5_bypass1 is locked
    'YL_q6_empty': True,  # indication: q6_empty is locked
    'YL_q7': True,  # indication: q7 is locked
    'YL_q8_dep': True,  # indication: q8_dep is locked
    'YL_q9': True,  # indication: q9 is locked
    'YF_ap_E': False,  # alarm: detector of ap_E faulty
    'YF_ap_W': False,  # alarm: detector of ap_W faulty
    'YF_q1': False,  # alarm: detector of q1 faulty
    'YF_q10_bypass2': False,  # alarm: detector of q10_bypass2 faulty
    'YF_q11_material': False,  # alarm: detector of q11_material faulty
    'YF_q12': False,  # alarm: detector of q12 faulty
    'YF_q13_man': False,  # alarm: detector of q13_man faulty
    'YF_q2': False,  # alarm: detector of q2 faulty
    'YF_q3_heavy': False,  # alarm: detector of q3_heavy faulty
    'YF_q4_tippler': False,  # alarm: detector of q4_tippler faulty
    'YF_q5_bypass1': False,  # alarm: detector of q5_bypass1 faulty
    'YF_q6_empty': False,  # alarm: detector of q6_empty faulty
    'YF_q7': False,  # alarm: detector of q7 faulty
    'YF_q8_dep': False,  # alarm: detector of q8_dep faulty
    'YF_q9': False,  # alarm: detector of q9 faulty
    'YP_S0': False,  # signal S0: clear (green)
    'YS_S0': True,  # signal S0: stop
    'YP_S1': False,  # signal S1: clear (green)
    'YS_S1': True,  # signal S1: stop
    'YP_S10': False,  # signal S10: clear (green)
    'YS_S10': True,  # signal S10: stop
    'YP_S11': False,  # signal S11: clear (green)
    'YS_S11': True,  # signal S11: stop
    'YP_S2': False,  # signal S2: clear (green)
    'YS_S2': True,  # signal S2: stop
    'YP_S3': False,  # signal S3: clear (green)
    'YS_S3': True,  # signal S3: stop
    'YP_S4': False,  # signal S4: clear (green)
    'YS_S4': True,  # signal S4: stop
    'YP_S5': False,  # signal S5: clear (green)
    'YS_S5': True,  # signal S5: stop
    'YP_S6': False,  # signal S6: clear (green)
    'YS_S6': True,  # signal S6: stop
    'YP_S7': False,  # signal S7: clear (green)
    'YS_S7': True,  # signal S7: stop
    'YP_S8': False,  # signal S8: clear (green)
    'YS_S8': True,  # signal S8: stop
    'YP_S9': False,  # signal S9: clear (green)
    'YS_S9': True,  # signal S9: stop
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
        CAN_S0 = read['CAN_S0']
        CAN_S1 = read['CAN_S1']
        CAN_S10 = read['CAN_S10']
        CAN_S11 = read['CAN_S11']
        CAN_S2 = read['CAN_S2']
        CAN_S3 = read['CAN_S3']
        CAN_S4 = read['CAN_S4']
        CAN_S5 = read['CAN_S5']
        CAN_S6 = read['CAN_S6']
        CAN_S7 = read['CAN_S7']
        CAN_S8 = read['CAN_S8']
        CAN_S9 = read['CAN_S9']
        E_PUSHER_HOME = read['E_PUSHER_HOME']
        E_TIP_HOME = read['E_TIP_HOME']
        REQ = read['REQ']
        LREQ = read['LREQ']
        CLR_ap_E = read['CLR_ap_E']
        CLR_ap_W = read['CLR_ap_W']
        CLR_q1 = read['CLR_q1']
        CLR_q10_bypass2 = read['CLR_q10_bypass2']
        CLR_q11_material = read['CLR_q11_material']
        CLR_q12 = read['CLR_q12']
        CLR_q13_man = read['CLR_q13_man']
        CLR_q2 = read['CLR_q2']
        CLR_q3_heavy = read['CLR_q3_heavy']
        CLR_q4_tippler = read['CLR_q4_tippler']
        CLR_q5_bypass1 = read['CLR_q5_bypass1']
        CLR_q6_empty = read['CLR_q6_empty']
        CLR_q7 = read['CLR_q7']
        CLR_q8_dep = read['CLR_q8_dep']
        CLR_q9 = read['CLR_q9']
        SH_ap_E = read['SH_ap_E']
        SH_ap_W = read['SH_ap_W']
        SH_q1 = read['SH_q1']
        SH_q10_bypass2 = read['SH_q10_bypass2']
        SH_q11_material = read['SH_q11_material']
        SH_q12 = read['SH_q12']
        SH_q13_man = read['SH_q13_man']
        SH_q2 = read['SH_q2']
        SH_q3_heavy = read['SH_q3_heavy']
        SH_q4_tippler = read['SH_q4_tippler']
        SH_q5_bypass1 = read['SH_q5_bypass1']
        SH_q6_empty = read['SH_q6_empty']
        SH_q7 = read['SH_q7']
        SH_q8_dep = read['SH_q8_dep']
        SH_q9 = read['SH_q9']
        REL_q1 = read['REL_q1']
        REL_q10_bypass2 = read['REL_q10_bypass2']
        REL_q11_material = read['REL_q11_material']
        REL_q12 = read['REL_q12']
        REL_q13_man = read['REL_q13_man']
        REL_q2 = read['REL_q2']
        REL_q3_heavy = read['REL_q3_heavy']
        REL_q4_tippler = read['REL_q4_tippler']
        REL_q5_bypass1 = read['REL_q5_bypass1']
        REL_q6_empty = read['REL_q6_empty']
        REL_q7 = read['REL_q7']
        REL_q8_dep = read['REL_q8_dep']
        REL_q9 = read['REL_q9']
        BLK_q1 = read['BLK_q1']
        BLK_q10_bypass2 = read['BLK_q10_bypass2']
        BLK_q11_material = read['BLK_q11_material']
        BLK_q12 = read['BLK_q12']
        BLK_q13_man = read['BLK_q13_man']
        BLK_q2 = read['BLK_q2']
        BLK_q3_heavy = read['BLK_q3_heavy']
        BLK_q4_tippler = read['BLK_q4_tippler']
        BLK_q5_bypass1 = read['BLK_q5_bypass1']
        BLK_q6_empty = read['BLK_q6_empty']
        BLK_q7 = read['BLK_q7']
        BLK_q8_dep = read['BLK_q8_dep']
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
        DN_P3 = read['DN_P3']
        DR_P3 = read['DR_P3']
        MN_P3 = read['MN_P3']
        MR_P3 = read['MR_P3']
        TC_P3 = read['TC_P3']
        DN_P4 = read['DN_P4']
        DR_P4 = read['DR_P4']
        MN_P4 = read['MN_P4']
        MR_P4 = read['MR_P4']
        TC_P4 = read['TC_P4']
        CN_P1 = old['CN_P1']
        CR_P1 = old['CR_P1']
        CN_P2 = old['CN_P2']
        CR_P2 = old['CR_P2']
        CN_P3 = old['CN_P3']
        CR_P3 = old['CR_P3']
        CN_P4 = old['CN_P4']
        CR_P4 = old['CR_P4']
        AL_P1 = old['AL_P1']
        AL_P2 = old['AL_P2']
        AL_P3 = old['AL_P3']
        AL_P4 = old['AL_P4']
        TH_P1 = old['TH_P1']
        TR_P1 = old['TR_P1']
        TH_P2 = old['TH_P2']
        TR_P2 = old['TR_P2']
        TH_P3 = old['TH_P3']
        TR_P3 = old['TR_P3']
        TH_P4 = old['TH_P4']
        TR_P4 = old['TR_P4']
        A_R1 = old['A_R1']
        B_R1 = old['B_R1']
        W_R1 = old['W_R1']
        S_R1 = old['S_R1']
        H_R1 = old['H_R1']
        A_R2 = old['A_R2']
        B_R2 = old['B_R2']
        W_R2 = old['W_R2']
        PA_R2 = old['PA_R2']
        S_R2 = old['S_R2']
        H_R2 = old['H_R2']
        A_R3 = old['A_R3']
        B_R3 = old['B_R3']
        W_R3 = old['W_R3']
        PA_R3 = old['PA_R3']
        S_R3 = old['S_R3']
        H_R3 = old['H_R3']
        A_R4 = old['A_R4']
        B_R4 = old['B_R4']
        W_R4 = old['W_R4']
        PA_R4 = old['PA_R4']
        S_R4 = old['S_R4']
        H_R4 = old['H_R4']
        A_R5 = old['A_R5']
        B_R5 = old['B_R5']
        W_R5 = old['W_R5']
        PA_R5 = old['PA_R5']
        S_R5 = old['S_R5']
        H_R5 = old['H_R5']
        A_R6 = old['A_R6']
        B_R6 = old['B_R6']
        W_R6 = old['W_R6']
        PA_R6 = old['PA_R6']
        S_R6 = old['S_R6']
        H_R6 = old['H_R6']
        A_R7 = old['A_R7']
        B_R7 = old['B_R7']
        W_R7 = old['W_R7']
        PA_R7 = old['PA_R7']
        S_R7 = old['S_R7']
        H_R7 = old['H_R7']
        A_R8 = old['A_R8']
        B_R8 = old['B_R8']
        W_R8 = old['W_R8']
        PA_R8 = old['PA_R8']
        S_R8 = old['S_R8']
        H_R8 = old['H_R8']
        A_R9 = old['A_R9']
        B_R9 = old['B_R9']
        W_R9 = old['W_R9']
        PA_R9 = old['PA_R9']
        S_R9 = old['S_R9']
        H_R9 = old['H_R9']
        A_R10 = old['A_R10']
        B_R10 = old['B_R10']
        W_R10 = old['W_R10']
        PA_R10 = old['PA_R10']
        S_R10 = old['S_R10']
        H_R10 = old['H_R10']
        A_R11 = old['A_R11']
        B_R11 = old['B_R11']
        W_R11 = old['W_R11']
        PA_R11 = old['PA_R11']
        S_R11 = old['S_R11']
        H_R11 = old['H_R11']
        A_R12 = old['A_R12']
        B_R12 = old['B_R12']
        W_R12 = old['W_R12']
        PA_R12 = old['PA_R12']
        S_R12 = old['S_R12']
        H_R12 = old['H_R12']
        A_R13 = old['A_R13']
        B_R13 = old['B_R13']
        W_R13 = old['W_R13']
        PA_R13 = old['PA_R13']
        S_R13 = old['S_R13']
        H_R13 = old['H_R13']
        A_R14 = old['A_R14']
        B_R14 = old['B_R14']
        W_R14 = old['W_R14']
        PA_R14 = old['PA_R14']
        S_R14 = old['S_R14']
        H_R14 = old['H_R14']
        A_R15 = old['A_R15']
        B_R15 = old['B_R15']
        W_R15 = old['W_R15']
        S_R15 = old['S_R15']
        H_R15 = old['H_R15']
        A_R16 = old['A_R16']
        B_R16 = old['B_R16']
        W_R16 = old['W_R16']
        PA_R16 = old['PA_R16']
        S_R16 = old['S_R16']
        H_R16 = old['H_R16']
        X_S0 = old['X_S0']
        X_S1 = old['X_S1']
        X_S10 = old['X_S10']
        X_S11 = old['X_S11']
        X_S2 = old['X_S2']
        X_S3 = old['X_S3']
        X_S4 = old['X_S4']
        X_S5 = old['X_S5']
        X_S6 = old['X_S6']
        X_S7 = old['X_S7']
        X_S8 = old['X_S8']
        X_S9 = old['X_S9']
        K_q1 = old['K_q1']
        L_q1_1 = old['L_q1_1']
        L_q1_2 = old['L_q1_2']
        F_q1 = old['F_q1']
        U_q1 = old['U_q1']
        P_q1 = old['P_q1']
        D_q1 = old['D_q1']
        K_q10_bypass2 = old['K_q10_bypass2']
        L_q10_bypass2_1 = old['L_q10_bypass2_1']
        L_q10_bypass2_2 = old['L_q10_bypass2_2']
        F_q10_bypass2 = old['F_q10_bypass2']
        U_q10_bypass2 = old['U_q10_bypass2']
        P_q10_bypass2 = old['P_q10_bypass2']
        D_q10_bypass2 = old['D_q10_bypass2']
        K_q11_material = old['K_q11_material']
        L_q11_material_2 = old['L_q11_material_2']
        F_q11_material = old['F_q11_material']
        U_q11_material = old['U_q11_material']
        P_q11_material = old['P_q11_material']
        D_q11_material = old['D_q11_material']
        K_q12 = old['K_q12']
        L_q12_1 = old['L_q12_1']
        L_q12_2 = old['L_q12_2']
        L_q12_3 = old['L_q12_3']
        L_q12_4 = old['L_q12_4']
        F_q12 = old['F_q12']
        U_q12 = old['U_q12']
        P_q12 = old['P_q12']
        D_q12 = old['D_q12']
        K_q13_man = old['K_q13_man']
        L_q13_man_2 = old['L_q13_man_2']
        F_q13_man = old['F_q13_man']
        U_q13_man = old['U_q13_man']
        P_q13_man = old['P_q13_man']
        D_q13_man = old['D_q13_man']
        K_q2 = old['K_q2']
        L_q2_1 = old['L_q2_1']
        L_q2_2 = old['L_q2_2']
        L_q2_4 = old['L_q2_4']
        F_q2 = old['F_q2']
        U_q2 = old['U_q2']
        P_q2 = old['P_q2']
        D_q2 = old['D_q2']
        K_q3_heavy = old['K_q3_heavy']
        L_q3_heavy_1 = old['L_q3_heavy_1']
        F_q3_heavy = old['F_q3_heavy']
        U_q3_heavy = old['U_q3_heavy']
        P_q3_heavy = old['P_q3_heavy']
        D_q3_heavy = old['D_q3_heavy']
        K_q4_tippler = old['K_q4_tippler']
        L_q4_tippler_1 = old['L_q4_tippler_1']
        F_q4_tippler = old['F_q4_tippler']
        U_q4_tippler = old['U_q4_tippler']
        P_q4_tippler = old['P_q4_tippler']
        D_q4_tippler = old['D_q4_tippler']
        K_q5_bypass1 = old['K_q5_bypass1']
        L_q5_bypass1_1 = old['L_q5_bypass1_1']
        L_q5_bypass1_2 = old['L_q5_bypass1_2']
        F_q5_bypass1 = old['F_q5_bypass1']
        U_q5_bypass1 = old['U_q5_bypass1']
        P_q5_bypass1 = old['P_q5_bypass1']
        D_q5_bypass1 = old['D_q5_bypass1']
        K_q6_empty = old['K_q6_empty']
        L_q6_empty_1 = old['L_q6_empty_1']
        F_q6_empty = old['F_q6_empty']
        U_q6_empty = old['U_q6_empty']
        P_q6_empty = old['P_q6_empty']
        D_q6_empty = old['D_q6_empty']
        K_q7 = old['K_q7']
        L_q7_1 = old['L_q7_1']
        L_q7_2 = old['L_q7_2']
        L_q7_4 = old['L_q7_4']
        F_q7 = old['F_q7']
        U_q7 = old['U_q7']
        P_q7 = old['P_q7']
        D_q7 = old['D_q7']
        K_q8_dep = old['K_q8_dep']
        L_q8_dep_1 = old['L_q8_dep_1']
        L_q8_dep_2 = old['L_q8_dep_2']
        F_q8_dep = old['F_q8_dep']
        U_q8_dep = old['U_q8_dep']
        P_q8_dep = old['P_q8_dep']
        D_q8_dep = old['D_q8_dep']
        K_q9 = old['K_q9']
        L_q9_1 = old['L_q9_1']
        L_q9_2 = old['L_q9_2']
        L_q9_3 = old['L_q9_3']
        L_q9_4 = old['L_q9_4']
        F_q9 = old['F_q9']
        U_q9 = old['U_q9']
        P_q9 = old['P_q9']
        D_q9 = old['D_q9']
        FA_ap_E = old['FA_ap_E']
        FA_ap_W = old['FA_ap_W']
        FA_q1 = old['FA_q1']
        FA_q10_bypass2 = old['FA_q10_bypass2']
        FA_q11_material = old['FA_q11_material']
        FA_q12 = old['FA_q12']
        FA_q13_man = old['FA_q13_man']
        FA_q2 = old['FA_q2']
        FA_q3_heavy = old['FA_q3_heavy']
        FA_q4_tippler = old['FA_q4_tippler']
        FA_q5_bypass1 = old['FA_q5_bypass1']
        FA_q6_empty = old['FA_q6_empty']
        FA_q7 = old['FA_q7']
        FA_q8_dep = old['FA_q8_dep']
        FA_q9 = old['FA_q9']
        OCC_ap_E = (not CLR_ap_E) or (not SH_ap_E) or (not VALID)  # ap_E counts as occupied
        OCC_ap_W = (not CLR_ap_W) or (not SH_ap_W) or (not VALID)  # ap_W counts as occupied
        OCC_q1 = (not CLR_q1) or (not SH_q1) or (not VALID)  # q1 counts as occupied
        OCC_q10_bypass2 = (not CLR_q10_bypass2) or (not SH_q10_bypass2) or (not VALID)  # q10_bypass2 counts as occupied
        OCC_q11_material = (not CLR_q11_material) or (not SH_q11_material) or (not VALID)  # q11_material counts as occupied
        OCC_q12 = (not CLR_q12) or (not SH_q12) or (not VALID)  # q12 counts as occupied
        OCC_q13_man = (not CLR_q13_man) or (not SH_q13_man) or (not VALID)  # q13_man counts as occupied
        OCC_q2 = (not CLR_q2) or (not SH_q2) or (not VALID)  # q2 counts as occupied
        OCC_q3_heavy = (not CLR_q3_heavy) or (not SH_q3_heavy) or (not VALID)  # q3_heavy counts as occupied
        OCC_q4_tippler = (not CLR_q4_tippler) or (not SH_q4_tippler) or (not VALID)  # q4_tippler counts as occupied
        OCC_q5_bypass1 = (not CLR_q5_bypass1) or (not SH_q5_bypass1) or (not VALID)  # q5_bypass1 counts as occupied
        OCC_q6_empty = (not CLR_q6_empty) or (not SH_q6_empty) or (not VALID)  # q6_empty counts as occupied
        OCC_q7 = (not CLR_q7) or (not SH_q7) or (not VALID)  # q7 counts as occupied
        OCC_q8_dep = (not CLR_q8_dep) or (not SH_q8_dep) or (not VALID)  # q8_dep counts as occupied
        OCC_q9 = (not CLR_q9) or (not SH_q9) or (not VALID)  # q9 counts as occupied
        FREE_q1 = (not K_q1) and (not L_q1_1) and (not L_q1_2)  # q1 is not locked by anybody
        FREE_q10_bypass2 = (not K_q10_bypass2) and (not L_q10_bypass2_1) and (not L_q10_bypass2_2)  # q10_bypass2 is not locked by anybody
        FREE_q11_material = (not K_q11_material) and (not L_q11_material_2)  # q11_material is not locked by anybody
        FREE_q12 = (not K_q12) and (not L_q12_1) and (not L_q12_2) and (not L_q12_3) and (not L_q12_4)  # q12 is not locked by anybody
        FREE_q13_man = (not K_q13_man) and (not L_q13_man_2)  # q13_man is not locked by anybody
        FREE_q2 = (not K_q2) and (not L_q2_1) and (not L_q2_2) and (not L_q2_4)  # q2 is not locked by anybody
        FREE_q3_heavy = (not K_q3_heavy) and (not L_q3_heavy_1)  # q3_heavy is not locked by anybody
        FREE_q4_tippler = (not K_q4_tippler) and (not L_q4_tippler_1)  # q4_tippler is not locked by anybody
        FREE_q5_bypass1 = (not K_q5_bypass1) and (not L_q5_bypass1_1) and (not L_q5_bypass1_2)  # q5_bypass1 is not locked by anybody
        FREE_q6_empty = (not K_q6_empty) and (not L_q6_empty_1)  # q6_empty is not locked by anybody
        FREE_q7 = (not K_q7) and (not L_q7_1) and (not L_q7_2) and (not L_q7_4)  # q7 is not locked by anybody
        FREE_q8_dep = (not K_q8_dep) and (not L_q8_dep_1) and (not L_q8_dep_2)  # q8_dep is not locked by anybody
        FREE_q9 = (not K_q9) and (not L_q9_1) and (not L_q9_2) and (not L_q9_3) and (not L_q9_4)  # q9 is not locked by anybody
        QN_P1 = VALID and DN_P1 and (not DR_P1)  # machine P1 lies N (R10)
        QR_P1 = VALID and DR_P1 and (not DN_P1)  # machine P1 lies R (R10)
        QN_P2 = VALID and DN_P2 and (not DR_P2)  # machine P2 lies N (R10)
        QR_P2 = VALID and DR_P2 and (not DN_P2)  # machine P2 lies R (R10)
        QN_P3 = VALID and DN_P3 and (not DR_P3)  # machine P3 lies N (R10)
        QR_P3 = VALID and DR_P3 and (not DN_P3)  # machine P3 lies R (R10)
        QN_P4 = VALID and DN_P4 and (not DR_P4)  # machine P4 lies N (R10)
        QR_P4 = VALID and DR_P4 and (not DN_P4)  # machine P4 lies R (R10)
        MOV_P1 = VALID and FREE_q2 and (not OCC_q2) and True and True  # machine P1 is free to move (R10)
        AVN_P1 = CN_P1 or MOV_P1 or (QN_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded N
        AVR_P1 = CR_P1 or MOV_P1 or (QR_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded R
        MOV_P2 = VALID and FREE_q7 and (not OCC_q7) and True and True  # machine P2 is free to move (R10)
        AVN_P2 = CN_P2 or MOV_P2 or (QN_P2 and (not CN_P2) and (not CR_P2))  # machine P2 can be demanded N
        AVR_P2 = CR_P2 or MOV_P2 or (QR_P2 and (not CN_P2) and (not CR_P2))  # machine P2 can be demanded R
        MOV_P3 = VALID and FREE_q9 and (not OCC_q9) and True and True  # machine P3 is free to move (R10)
        AVN_P3 = CN_P3 or MOV_P3 or (QN_P3 and (not CN_P3) and (not CR_P3))  # machine P3 can be demanded N
        AVR_P3 = CR_P3 or MOV_P3 or (QR_P3 and (not CN_P3) and (not CR_P3))  # machine P3 can be demanded R
        MOV_P4 = VALID and FREE_q12 and (not OCC_q12) and True and True  # machine P4 is free to move (R10)
        AVN_P4 = CN_P4 or MOV_P4 or (QN_P4 and (not CN_P4) and (not CR_P4))  # machine P4 can be demanded N
        AVR_P4 = CR_P4 or MOV_P4 or (QR_P4 and (not CN_P4) and (not CR_P4))  # machine P4 can be demanded R
        WF_q1_1 = FREE_q1 and (not OCC_q1) and (not BLK_q1)  # q1 from W to q1|q2@P1.toe: free for a route (R6)
        WF_q1_2 = FREE_q1 and (not OCC_q1) and (not BLK_q1)  # q1 from q1|q2@P1.toe to W: free for a route (R6)
        WF_q10_bypass2_1 = FREE_q10_bypass2 and (not OCC_q10_bypass2) and (not BLK_q10_bypass2)  # q10_bypass2 from q10_bypass2|q7@P2.reverse to q10_bypass2|q9@P3.normal: free for a route (R6)
        WF_q10_bypass2_2 = FREE_q10_bypass2 and (not OCC_q10_bypass2) and (not BLK_q10_bypass2)  # q10_bypass2 from q10_bypass2|q9@P3.normal to q10_bypass2|q7@P2.reverse: free for a route (R6)
        WF_q11_material_2 = FREE_q11_material and (not OCC_q11_material) and (not BLK_q11_material)  # q11_material from q11_material|q9@P3.reverse to MAT: free for a route (R6)
        WA_q12_1 = AVR_P4 and (not TR_P4)  # q12 from q12|q13_man@P4.reverse to q12|q7@P2.toe: could be locked
        WF_q12_1 = FREE_q12 and (not OCC_q12) and (not BLK_q12) and WA_q12_1  # q12 from q12|q13_man@P4.reverse to q12|q7@P2.toe: free for a route (R6)
        WA_q12_2 = AVR_P4 and (not TR_P4)  # q12 from q12|q7@P2.toe to q12|q13_man@P4.reverse: could be locked
        WF_q12_2 = FREE_q12 and (not OCC_q12) and (not BLK_q12) and WA_q12_2  # q12 from q12|q7@P2.toe to q12|q13_man@P4.reverse: free for a route (R6)
        WA_q12_3 = AVN_P4 and (not TR_P4)  # q12 from q12|q7@P2.toe to q12|q8_dep@P4.normal: could be locked
        WF_q12_3 = FREE_q12 and (not OCC_q12) and (not BLK_q12) and WA_q12_3  # q12 from q12|q7@P2.toe to q12|q8_dep@P4.normal: free for a route (R6)
        WA_q12_4 = AVN_P4 and (not TR_P4)  # q12 from q12|q8_dep@P4.normal to q12|q7@P2.toe: could be locked
        WF_q12_4 = FREE_q12 and (not OCC_q12) and (not BLK_q12) and WA_q12_4  # q12 from q12|q8_dep@P4.normal to q12|q7@P2.toe: free for a route (R6)
        WF_q13_man_2 = FREE_q13_man and (not OCC_q13_man) and (not BLK_q13_man)  # q13_man from q12|q13_man@P4.reverse to MAN: free for a route (R6)
        WA_q2_1 = AVN_P1 and (not TR_P1)  # q2 from q1|q2@P1.toe to q2|q3_heavy@P1.normal: could be locked
        WF_q2_1 = FREE_q2 and (not OCC_q2) and (not BLK_q2) and WA_q2_1  # q2 from q1|q2@P1.toe to q2|q3_heavy@P1.normal: free for a route (R6)
        WA_q2_2 = AVR_P1 and (not TR_P1)  # q2 from q1|q2@P1.toe to q2|q5_bypass1@P1.reverse: could be locked
        WF_q2_2 = FREE_q2 and (not OCC_q2) and (not BLK_q2) and WA_q2_2  # q2 from q1|q2@P1.toe to q2|q5_bypass1@P1.reverse: free for a route (R6)
        WA_q2_4 = AVR_P1 and (not TR_P1)  # q2 from q2|q5_bypass1@P1.reverse to q1|q2@P1.toe: could be locked
        WF_q2_4 = FREE_q2 and (not OCC_q2) and (not BLK_q2) and WA_q2_4  # q2 from q2|q5_bypass1@P1.reverse to q1|q2@P1.toe: free for a route (R6)
        WF_q3_heavy_1 = FREE_q3_heavy and (not OCC_q3_heavy) and (not BLK_q3_heavy)  # q3_heavy from q2|q3_heavy@P1.normal to q3_heavy|q4_tippler@heavy.0: free for a route (R6)
        WF_q4_tippler_1 = FREE_q4_tippler and (not OCC_q4_tippler) and (not BLK_q4_tippler)  # q4_tippler from q3_heavy|q4_tippler@heavy.0 to q4_tippler|q6_empty@heavy.1: free for a route (R6)
        WF_q5_bypass1_1 = FREE_q5_bypass1 and (not OCC_q5_bypass1) and (not BLK_q5_bypass1)  # q5_bypass1 from q2|q5_bypass1@P1.reverse to q5_bypass1|q9@P3.toe: free for a route (R6)
        WF_q5_bypass1_2 = FREE_q5_bypass1 and (not OCC_q5_bypass1) and (not BLK_q5_bypass1)  # q5_bypass1 from q5_bypass1|q9@P3.toe to q2|q5_bypass1@P1.reverse: free for a route (R6)
        WF_q6_empty_1 = FREE_q6_empty and (not OCC_q6_empty) and (not BLK_q6_empty)  # q6_empty from q4_tippler|q6_empty@heavy.1 to q6_empty|q7@P2.normal: free for a route (R6)
        WA_q7_1 = AVR_P2 and (not TR_P2)  # q7 from q10_bypass2|q7@P2.reverse to q12|q7@P2.toe: could be locked
        WF_q7_1 = FREE_q7 and (not OCC_q7) and (not BLK_q7) and WA_q7_1  # q7 from q10_bypass2|q7@P2.reverse to q12|q7@P2.toe: free for a route (R6)
        WA_q7_2 = AVR_P2 and (not TR_P2)  # q7 from q12|q7@P2.toe to q10_bypass2|q7@P2.reverse: could be locked
        WF_q7_2 = FREE_q7 and (not OCC_q7) and (not BLK_q7) and WA_q7_2  # q7 from q12|q7@P2.toe to q10_bypass2|q7@P2.reverse: free for a route (R6)
        WA_q7_4 = AVN_P2 and (not TR_P2)  # q7 from q6_empty|q7@P2.normal to q12|q7@P2.toe: could be locked
        WF_q7_4 = FREE_q7 and (not OCC_q7) and (not BLK_q7) and WA_q7_4  # q7 from q6_empty|q7@P2.normal to q12|q7@P2.toe: free for a route (R6)
        WF_q8_dep_1 = FREE_q8_dep and (not OCC_q8_dep) and (not BLK_q8_dep)  # q8_dep from E to q12|q8_dep@P4.normal: free for a route (R6)
        WF_q8_dep_2 = FREE_q8_dep and (not OCC_q8_dep) and (not BLK_q8_dep)  # q8_dep from q12|q8_dep@P4.normal to E: free for a route (R6)
        WA_q9_1 = AVN_P3 and (not TR_P3)  # q9 from q10_bypass2|q9@P3.normal to q5_bypass1|q9@P3.toe: could be locked
        WF_q9_1 = FREE_q9 and (not OCC_q9) and (not BLK_q9) and WA_q9_1  # q9 from q10_bypass2|q9@P3.normal to q5_bypass1|q9@P3.toe: free for a route (R6)
        WA_q9_2 = AVR_P3 and (not TR_P3)  # q9 from q11_material|q9@P3.reverse to q5_bypass1|q9@P3.toe: could be locked
        WF_q9_2 = FREE_q9 and (not OCC_q9) and (not BLK_q9) and WA_q9_2  # q9 from q11_material|q9@P3.reverse to q5_bypass1|q9@P3.toe: free for a route (R6)
        WA_q9_3 = AVN_P3 and (not TR_P3)  # q9 from q5_bypass1|q9@P3.toe to q10_bypass2|q9@P3.normal: could be locked
        WF_q9_3 = FREE_q9 and (not OCC_q9) and (not BLK_q9) and WA_q9_3  # q9 from q5_bypass1|q9@P3.toe to q10_bypass2|q9@P3.normal: free for a route (R6)
        WA_q9_4 = AVR_P3 and (not TR_P3)  # q9 from q5_bypass1|q9@P3.toe to q11_material|q9@P3.reverse: could be locked
        WF_q9_4 = FREE_q9 and (not OCC_q9) and (not BLK_q9) and WA_q9_4  # q9 from q5_bypass1|q9@P3.toe to q11_material|q9@P3.reverse: free for a route (R6)
        WL_q1_1 = (not OCC_q1)  # q1 from W to q1|q2@P1.toe: lies and is clear
        WP_q1_1 = WL_q1_1 and (not BLK_q1)  # q1 from W to q1|q2@P1.toe: proceed may be shown over it (R3)
        WL_q1_2 = (not OCC_q1)  # q1 from q1|q2@P1.toe to W: lies and is clear
        WP_q1_2 = WL_q1_2 and (not BLK_q1)  # q1 from q1|q2@P1.toe to W: proceed may be shown over it (R3)
        WL_q10_bypass2_1 = (not OCC_q10_bypass2)  # q10_bypass2 from q10_bypass2|q7@P2.reverse to q10_bypass2|q9@P3.normal: lies and is clear
        WP_q10_bypass2_1 = WL_q10_bypass2_1 and (not BLK_q10_bypass2)  # q10_bypass2 from q10_bypass2|q7@P2.reverse to q10_bypass2|q9@P3.normal: proceed may be shown over it (R3)
        WL_q10_bypass2_2 = (not OCC_q10_bypass2)  # q10_bypass2 from q10_bypass2|q9@P3.normal to q10_bypass2|q7@P2.reverse: lies and is clear
        WP_q10_bypass2_2 = WL_q10_bypass2_2 and (not BLK_q10_bypass2)  # q10_bypass2 from q10_bypass2|q9@P3.normal to q10_bypass2|q7@P2.reverse: proceed may be shown over it (R3)
        WL_q11_material_2 = (not OCC_q11_material)  # q11_material from q11_material|q9@P3.reverse to MAT: lies and is clear
        WP_q11_material_2 = WL_q11_material_2 and (not BLK_q11_material)  # q11_material from q11_material|q9@P3.reverse to MAT: proceed may be shown over it (R3)
        WD_q12_1 = QR_P4 and (not TR_P4)  # q12 from q12|q13_man@P4.reverse to q12|q7@P2.toe: its points lie, nothing is foul of it
        WL_q12_1 = (not OCC_q12) and WD_q12_1  # q12 from q12|q13_man@P4.reverse to q12|q7@P2.toe: lies and is clear
        WP_q12_1 = WL_q12_1 and (not BLK_q12)  # q12 from q12|q13_man@P4.reverse to q12|q7@P2.toe: proceed may be shown over it (R3)
        WD_q12_2 = QR_P4 and (not TR_P4)  # q12 from q12|q7@P2.toe to q12|q13_man@P4.reverse: its points lie, nothing is foul of it
        WL_q12_2 = (not OCC_q12) and WD_q12_2  # q12 from q12|q7@P2.toe to q12|q13_man@P4.reverse: lies and is clear
        WP_q12_2 = WL_q12_2 and (not BLK_q12)  # q12 from q12|q7@P2.toe to q12|q13_man@P4.reverse: proceed may be shown over it (R3)
        WD_q12_3 = QN_P4 and (not TR_P4)  # q12 from q12|q7@P2.toe to q12|q8_dep@P4.normal: its points lie, nothing is foul of it
        WL_q12_3 = (not OCC_q12) and WD_q12_3  # q12 from q12|q7@P2.toe to q12|q8_dep@P4.normal: lies and is clear
        WP_q12_3 = WL_q12_3 and (not BLK_q12)  # q12 from q12|q7@P2.toe to q12|q8_dep@P4.normal: proceed may be shown over it (R3)
        WD_q12_4 = QN_P4 and (not TR_P4)  # q12 from q12|q8_dep@P4.normal to q12|q7@P2.toe: its points lie, nothing is foul of it
        WL_q12_4 = (not OCC_q12) and WD_q12_4  # q12 from q12|q8_dep@P4.normal to q12|q7@P2.toe: lies and is clear
        WP_q12_4 = WL_q12_4 and (not BLK_q12)  # q12 from q12|q8_dep@P4.normal to q12|q7@P2.toe: proceed may be shown over it (R3)
        WL_q13_man_2 = (not OCC_q13_man)  # q13_man from q12|q13_man@P4.reverse to MAN: lies and is clear
        WP_q13_man_2 = WL_q13_man_2 and (not BLK_q13_man)  # q13_man from q12|q13_man@P4.reverse to MAN: proceed may be shown over it (R3)
        WD_q2_1 = QN_P1 and (not TR_P1)  # q2 from q1|q2@P1.toe to q2|q3_heavy@P1.normal: its points lie, nothing is foul of it
        WL_q2_1 = (not OCC_q2) and WD_q2_1  # q2 from q1|q2@P1.toe to q2|q3_heavy@P1.normal: lies and is clear
        WP_q2_1 = WL_q2_1 and (not BLK_q2)  # q2 from q1|q2@P1.toe to q2|q3_heavy@P1.normal: proceed may be shown over it (R3)
        WD_q2_2 = QR_P1 and (not TR_P1)  # q2 from q1|q2@P1.toe to q2|q5_bypass1@P1.reverse: its points lie, nothing is foul of it
        WL_q2_2 = (not OCC_q2) and WD_q2_2  # q2 from q1|q2@P1.toe to q2|q5_bypass1@P1.reverse: lies and is clear
        WP_q2_2 = WL_q2_2 and (not BLK_q2)  # q2 from q1|q2@P1.toe to q2|q5_bypass1@P1.reverse: proceed may be shown over it (R3)
        WD_q2_4 = QR_P1 and (not TR_P1)  # q2 from q2|q5_bypass1@P1.reverse to q1|q2@P1.toe: its points lie, nothing is foul of it
        WL_q2_4 = (not OCC_q2) and WD_q2_4  # q2 from q2|q5_bypass1@P1.reverse to q1|q2@P1.toe: lies and is clear
        WP_q2_4 = WL_q2_4 and (not BLK_q2)  # q2 from q2|q5_bypass1@P1.reverse to q1|q2@P1.toe: proceed may be shown over it (R3)
        WL_q3_heavy_1 = (not OCC_q3_heavy)  # q3_heavy from q2|q3_heavy@P1.normal to q3_heavy|q4_tippler@heavy.0: lies and is clear
        WP_q3_heavy_1 = WL_q3_heavy_1 and (not BLK_q3_heavy)  # q3_heavy from q2|q3_heavy@P1.normal to q3_heavy|q4_tippler@heavy.0: proceed may be shown over it (R3)
        WL_q4_tippler_1 = (not OCC_q4_tippler)  # q4_tippler from q3_heavy|q4_tippler@heavy.0 to q4_tippler|q6_empty@heavy.1: lies and is clear
        WP_q4_tippler_1 = WL_q4_tippler_1 and (not BLK_q4_tippler)  # q4_tippler from q3_heavy|q4_tippler@heavy.0 to q4_tippler|q6_empty@heavy.1: proceed may be shown over it (R3)
        WL_q5_bypass1_1 = (not OCC_q5_bypass1)  # q5_bypass1 from q2|q5_bypass1@P1.reverse to q5_bypass1|q9@P3.toe: lies and is clear
        WP_q5_bypass1_1 = WL_q5_bypass1_1 and (not BLK_q5_bypass1)  # q5_bypass1 from q2|q5_bypass1@P1.reverse to q5_bypass1|q9@P3.toe: proceed may be shown over it (R3)
        WL_q5_bypass1_2 = (not OCC_q5_bypass1)  # q5_bypass1 from q5_bypass1|q9@P3.toe to q2|q5_bypass1@P1.reverse: lies and is clear
        WP_q5_bypass1_2 = WL_q5_bypass1_2 and (not BLK_q5_bypass1)  # q5_bypass1 from q5_bypass1|q9@P3.toe to q2|q5_bypass1@P1.reverse: proceed may be shown over it (R3)
        WL_q6_empty_1 = (not OCC_q6_empty)  # q6_empty from q4_tippler|q6_empty@heavy.1 to q6_empty|q7@P2.normal: lies and is clear
        WP_q6_empty_1 = WL_q6_empty_1 and (not BLK_q6_empty)  # q6_empty from q4_tippler|q6_empty@heavy.1 to q6_empty|q7@P2.normal: proceed may be shown over it (R3)
        WD_q7_1 = QR_P2 and (not TR_P2)  # q7 from q10_bypass2|q7@P2.reverse to q12|q7@P2.toe: its points lie, nothing is foul of it
        WL_q7_1 = (not OCC_q7) and WD_q7_1  # q7 from q10_bypass2|q7@P2.reverse to q12|q7@P2.toe: lies and is clear
        WP_q7_1 = WL_q7_1 and (not BLK_q7)  # q7 from q10_bypass2|q7@P2.reverse to q12|q7@P2.toe: proceed may be shown over it (R3)
        WD_q7_2 = QR_P2 and (not TR_P2)  # q7 from q12|q7@P2.toe to q10_bypass2|q7@P2.reverse: its points lie, nothing is foul of it
        WL_q7_2 = (not OCC_q7) and WD_q7_2  # q7 from q12|q7@P2.toe to q10_bypass2|q7@P2.reverse: lies and is clear
        WP_q7_2 = WL_q7_2 and (not BLK_q7)  # q7 from q12|q7@P2.toe to q10_bypass2|q7@P2.reverse: proceed may be shown over it (R3)
        WD_q7_4 = QN_P2 and (not TR_P2)  # q7 from q6_empty|q7@P2.normal to q12|q7@P2.toe: its points lie, nothing is foul of it
        WL_q7_4 = (not OCC_q7) and WD_q7_4  # q7 from q6_empty|q7@P2.normal to q12|q7@P2.toe: lies and is clear
        WP_q7_4 = WL_q7_4 and (not BLK_q7)  # q7 from q6_empty|q7@P2.normal to q12|q7@P2.toe: proceed may be shown over it (R3)
        WL_q8_dep_1 = (not OCC_q8_dep)  # q8_dep from E to q12|q8_dep@P4.normal: lies and is clear
        WP_q8_dep_1 = WL_q8_dep_1 and (not BLK_q8_dep)  # q8_dep from E to q12|q8_dep@P4.normal: proceed may be shown over it (R3)
        WL_q8_dep_2 = (not OCC_q8_dep)  # q8_dep from q12|q8_dep@P4.normal to E: lies and is clear
        WP_q8_dep_2 = WL_q8_dep_2 and (not BLK_q8_dep)  # q8_dep from q12|q8_dep@P4.normal to E: proceed may be shown over it (R3)
        WD_q9_1 = QN_P3 and (not TR_P3)  # q9 from q10_bypass2|q9@P3.normal to q5_bypass1|q9@P3.toe: its points lie, nothing is foul of it
        WL_q9_1 = (not OCC_q9) and WD_q9_1  # q9 from q10_bypass2|q9@P3.normal to q5_bypass1|q9@P3.toe: lies and is clear
        WP_q9_1 = WL_q9_1 and (not BLK_q9)  # q9 from q10_bypass2|q9@P3.normal to q5_bypass1|q9@P3.toe: proceed may be shown over it (R3)
        WD_q9_2 = QR_P3 and (not TR_P3)  # q9 from q11_material|q9@P3.reverse to q5_bypass1|q9@P3.toe: its points lie, nothing is foul of it
        WL_q9_2 = (not OCC_q9) and WD_q9_2  # q9 from q11_material|q9@P3.reverse to q5_bypass1|q9@P3.toe: lies and is clear
        WP_q9_2 = WL_q9_2 and (not BLK_q9)  # q9 from q11_material|q9@P3.reverse to q5_bypass1|q9@P3.toe: proceed may be shown over it (R3)
        WD_q9_3 = QN_P3 and (not TR_P3)  # q9 from q5_bypass1|q9@P3.toe to q10_bypass2|q9@P3.normal: its points lie, nothing is foul of it
        WL_q9_3 = (not OCC_q9) and WD_q9_3  # q9 from q5_bypass1|q9@P3.toe to q10_bypass2|q9@P3.normal: lies and is clear
        WP_q9_3 = WL_q9_3 and (not BLK_q9)  # q9 from q5_bypass1|q9@P3.toe to q10_bypass2|q9@P3.normal: proceed may be shown over it (R3)
        WD_q9_4 = QR_P3 and (not TR_P3)  # q9 from q5_bypass1|q9@P3.toe to q11_material|q9@P3.reverse: its points lie, nothing is foul of it
        WL_q9_4 = (not OCC_q9) and WD_q9_4  # q9 from q5_bypass1|q9@P3.toe to q11_material|q9@P3.reverse: lies and is clear
        WP_q9_4 = WL_q9_4 and (not BLK_q9)  # q9 from q5_bypass1|q9@P3.toe to q11_material|q9@P3.reverse: proceed may be shown over it (R3)
        G_R1 = ((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and VALID and WF_q1_1  # grant of route S0-S1 (R6)
        G_R2 = ((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) and VALID and WF_q2_1 and WF_q3_heavy_1  # grant of route S1-S2 (R6)
        G_R3 = ((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and VALID and WF_q2_2 and WF_q5_bypass1_1  # grant of route S1-S4 (R6)
        G_R4 = ((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and VALID and WF_q9_1 and WF_q5_bypass1_2  # grant of route S10-S11 (R6)
        G_R5 = ((LREQ == 5) or ((LREQ == 0) and (REQ == 5))) and VALID and WF_q2_4 and WF_q1_2  # grant of route S11-W (R6)
        G_R6 = ((LREQ == 6) or ((LREQ == 0) and (REQ == 6))) and VALID and WF_q4_tippler_1 and WF_q6_empty_1  # grant of route S2-S3 (R6)
        G_R7 = ((LREQ == 7) or ((LREQ == 0) and (REQ == 7))) and VALID and WF_q7_4 and WF_q12_3 and WF_q8_dep_2  # grant of route S3-E (R6)
        G_R8 = ((LREQ == 8) or ((LREQ == 0) and (REQ == 8))) and VALID and WF_q7_4 and WF_q12_2 and WF_q13_man_2  # grant of route S3-MAN (R6)
        G_R9 = ((LREQ == 9) or ((LREQ == 0) and (REQ == 9))) and VALID and WF_q9_4 and WF_q11_material_2  # grant of route S4-MAT (R6)
        G_R10 = ((LREQ == 10) or ((LREQ == 0) and (REQ == 10))) and VALID and WF_q9_3 and WF_q10_bypass2_2  # grant of route S4-S5 (R6)
        G_R11 = ((LREQ == 11) or ((LREQ == 0) and (REQ == 11))) and VALID and WF_q7_1 and WF_q12_3 and WF_q8_dep_2  # grant of route S5-E (R6)
        G_R12 = ((LREQ == 12) or ((LREQ == 0) and (REQ == 12))) and VALID and WF_q7_1 and WF_q12_2 and WF_q13_man_2  # grant of route S5-MAN (R6)
        G_R13 = ((LREQ == 13) or ((LREQ == 0) and (REQ == 13))) and VALID and WF_q9_2 and WF_q5_bypass1_2  # grant of route S6-S11 (R6)
        G_R14 = ((LREQ == 14) or ((LREQ == 0) and (REQ == 14))) and VALID and WF_q12_1 and WF_q7_2 and WF_q10_bypass2_1  # grant of route S7-S10 (R6)
        G_R15 = ((LREQ == 15) or ((LREQ == 0) and (REQ == 15))) and VALID and WF_q8_dep_1  # grant of route S8-S9 (R6)
        G_R16 = ((LREQ == 16) or ((LREQ == 0) and (REQ == 16))) and VALID and WF_q12_4 and WF_q7_2 and WF_q10_bypass2_1  # grant of route S9-S10 (R6)
        GW_q1_1 = G_R1  # q1 from W to q1|q2@P1.toe: granted
        GW_q1_2 = G_R5  # q1 from q1|q2@P1.toe to W: granted
        GW_q10_bypass2_1 = G_R14 or G_R16  # q10_bypass2 from q10_bypass2|q7@P2.reverse to q10_bypass2|q9@P3.normal: granted
        GW_q10_bypass2_2 = G_R10  # q10_bypass2 from q10_bypass2|q9@P3.normal to q10_bypass2|q7@P2.reverse: granted
        GW_q11_material_2 = G_R9  # q11_material from q11_material|q9@P3.reverse to MAT: granted
        GW_q12_1 = G_R14  # q12 from q12|q13_man@P4.reverse to q12|q7@P2.toe: granted
        GW_q12_2 = G_R8 or G_R12  # q12 from q12|q7@P2.toe to q12|q13_man@P4.reverse: granted
        GW_q12_3 = G_R7 or G_R11  # q12 from q12|q7@P2.toe to q12|q8_dep@P4.normal: granted
        GW_q12_4 = G_R16  # q12 from q12|q8_dep@P4.normal to q12|q7@P2.toe: granted
        GW_q13_man_2 = G_R8 or G_R12  # q13_man from q12|q13_man@P4.reverse to MAN: granted
        GW_q2_1 = G_R2  # q2 from q1|q2@P1.toe to q2|q3_heavy@P1.normal: granted
        GW_q2_2 = G_R3  # q2 from q1|q2@P1.toe to q2|q5_bypass1@P1.reverse: granted
        GW_q2_4 = G_R5  # q2 from q2|q5_bypass1@P1.reverse to q1|q2@P1.toe: granted
        GW_q3_heavy_1 = G_R2  # q3_heavy from q2|q3_heavy@P1.normal to q3_heavy|q4_tippler@heavy.0: granted
        GW_q4_tippler_1 = G_R6  # q4_tippler from q3_heavy|q4_tippler@heavy.0 to q4_tippler|q6_empty@heavy.1: granted
        GW_q5_bypass1_1 = G_R3  # q5_bypass1 from q2|q5_bypass1@P1.reverse to q5_bypass1|q9@P3.toe: granted
        GW_q5_bypass1_2 = G_R4 or G_R13  # q5_bypass1 from q5_bypass1|q9@P3.toe to q2|q5_bypass1@P1.reverse: granted
        GW_q6_empty_1 = G_R6  # q6_empty from q4_tippler|q6_empty@heavy.1 to q6_empty|q7@P2.normal: granted
        GW_q7_1 = G_R11 or G_R12  # q7 from q10_bypass2|q7@P2.reverse to q12|q7@P2.toe: granted
        GW_q7_2 = G_R14 or G_R16  # q7 from q12|q7@P2.toe to q10_bypass2|q7@P2.reverse: granted
        GW_q7_4 = G_R7 or G_R8  # q7 from q6_empty|q7@P2.normal to q12|q7@P2.toe: granted
        GW_q8_dep_1 = G_R15  # q8_dep from E to q12|q8_dep@P4.normal: granted
        GW_q8_dep_2 = G_R7 or G_R11  # q8_dep from q12|q8_dep@P4.normal to E: granted
        GW_q9_1 = G_R4  # q9 from q10_bypass2|q9@P3.normal to q5_bypass1|q9@P3.toe: granted
        GW_q9_2 = G_R13  # q9 from q11_material|q9@P3.reverse to q5_bypass1|q9@P3.toe: granted
        GW_q9_3 = G_R10  # q9 from q5_bypass1|q9@P3.toe to q10_bypass2|q9@P3.normal: granted
        GW_q9_4 = G_R9  # q9 from q5_bypass1|q9@P3.toe to q11_material|q9@P3.reverse: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_S0) and (not CAN_S0) and WL_q1_1  # route S0-S1 becomes locked (R3)
        CO_R1 = VALID and WP_q1_1 and (not D_q1)  # conditions of proceed for route S0-S1 (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_S1) and (not CAN_S1) and WL_q2_1 and WL_q3_heavy_1  # route S1-S2 becomes locked (R3)
        CO_R2 = VALID and WP_q2_1 and WP_q3_heavy_1 and (not D_q2)  # conditions of proceed for route S1-S2 (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_S1) and (not CAN_S1) and WL_q2_2 and WL_q5_bypass1_1  # route S1-S4 becomes locked (R3)
        CO_R3 = VALID and WP_q2_2 and WP_q5_bypass1_1 and (not D_q2)  # conditions of proceed for route S1-S4 (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_S10) and (not CAN_S10) and WL_q9_1 and WL_q5_bypass1_2  # route S10-S11 becomes locked (R3)
        CO_R4 = VALID and WP_q9_1 and WP_q5_bypass1_2 and (not D_q9)  # conditions of proceed for route S10-S11 (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_S11) and (not CAN_S11) and WL_q2_4 and WL_q1_2  # route S11-W becomes locked (R3)
        CO_R5 = VALID and WP_q2_4 and WP_q1_2 and (not OCC_ap_W) and (not D_q2)  # conditions of proceed for route S11-W (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_S2) and (not CAN_S2) and WL_q4_tippler_1 and WL_q6_empty_1  # route S2-S3 becomes locked (R3)
        CO_R6 = VALID and WP_q4_tippler_1 and WP_q6_empty_1 and E_PUSHER_HOME and E_TIP_HOME and (not D_q4_tippler)  # conditions of proceed for route S2-S3 (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_S3) and (not CAN_S3) and WL_q7_4 and WL_q12_3 and WL_q8_dep_2  # route S3-E becomes locked (R3)
        CO_R7 = VALID and WP_q7_4 and WP_q12_3 and WP_q8_dep_2 and (not OCC_ap_E) and (not D_q7)  # conditions of proceed for route S3-E (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_S3) and (not CAN_S3) and WL_q7_4 and WL_q12_2 and WL_q13_man_2  # route S3-MAN becomes locked (R3)
        CO_R8 = VALID and WP_q7_4 and WP_q12_2 and WP_q13_man_2 and (not D_q7)  # conditions of proceed for route S3-MAN (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_S4) and (not CAN_S4) and WL_q9_4 and WL_q11_material_2  # route S4-MAT becomes locked (R3)
        CO_R9 = VALID and WP_q9_4 and WP_q11_material_2 and (not D_q9)  # conditions of proceed for route S4-MAT (R3)
        LK_R10 = A_R10 and (not B_R10) and VALID and (not X_S4) and (not CAN_S4) and WL_q9_3 and WL_q10_bypass2_2  # route S4-S5 becomes locked (R3)
        CO_R10 = VALID and WP_q9_3 and WP_q10_bypass2_2 and (not D_q9)  # conditions of proceed for route S4-S5 (R3)
        LK_R11 = A_R11 and (not B_R11) and VALID and (not X_S5) and (not CAN_S5) and WL_q7_1 and WL_q12_3 and WL_q8_dep_2  # route S5-E becomes locked (R3)
        CO_R11 = VALID and WP_q7_1 and WP_q12_3 and WP_q8_dep_2 and (not OCC_ap_E) and (not D_q7)  # conditions of proceed for route S5-E (R3)
        LK_R12 = A_R12 and (not B_R12) and VALID and (not X_S5) and (not CAN_S5) and WL_q7_1 and WL_q12_2 and WL_q13_man_2  # route S5-MAN becomes locked (R3)
        CO_R12 = VALID and WP_q7_1 and WP_q12_2 and WP_q13_man_2 and (not D_q7)  # conditions of proceed for route S5-MAN (R3)
        LK_R13 = A_R13 and (not B_R13) and VALID and (not X_S6) and (not CAN_S6) and WL_q9_2 and WL_q5_bypass1_2  # route S6-S11 becomes locked (R3)
        CO_R13 = VALID and WP_q9_2 and WP_q5_bypass1_2 and (not D_q9)  # conditions of proceed for route S6-S11 (R3)
        LK_R14 = A_R14 and (not B_R14) and VALID and (not X_S7) and (not CAN_S7) and WL_q12_1 and WL_q7_2 and WL_q10_bypass2_1  # route S7-S10 becomes locked (R3)
        CO_R14 = VALID and WP_q12_1 and WP_q7_2 and WP_q10_bypass2_1 and (not D_q12)  # conditions of proceed for route S7-S10 (R3)
        LK_R15 = A_R15 and (not B_R15) and VALID and (not X_S8) and (not CAN_S8) and WL_q8_dep_1  # route S8-S9 becomes locked (R3)
        CO_R15 = VALID and WP_q8_dep_1 and (not D_q8_dep)  # conditions of proceed for route S8-S9 (R3)
        LK_R16 = A_R16 and (not B_R16) and VALID and (not X_S9) and (not CAN_S9) and WL_q12_4 and WL_q7_2 and WL_q10_bypass2_1  # route S9-S10 becomes locked (R3)
        CO_R16 = VALID and WP_q12_4 and WP_q7_2 and WP_q10_bypass2_1 and (not D_q12)  # conditions of proceed for route S9-S10 (R3)
        NU_q1_1 = VALID and F_q1 and (not D_q1) and (not U_q1) and L_q1_1 and OCC_q1 and OCC_ap_W  # a train comes into q1 at W (R9)
        NU_q1_2 = VALID and F_q1 and (not D_q1) and (not U_q1) and L_q1_2 and OCC_q1 and OCC_q2 and U_q2 and L_q2_4  # a train comes into q1 at q1|q2@P1.toe (R9)
        NU_q10_bypass2_1 = VALID and F_q10_bypass2 and (not D_q10_bypass2) and (not U_q10_bypass2) and L_q10_bypass2_1 and OCC_q10_bypass2 and OCC_q7 and U_q7 and L_q7_2  # a train comes into q10_bypass2 at q10_bypass2|q7@P2.reverse (R9)
        NU_q10_bypass2_2 = VALID and F_q10_bypass2 and (not D_q10_bypass2) and (not U_q10_bypass2) and L_q10_bypass2_2 and OCC_q10_bypass2 and OCC_q9 and U_q9 and L_q9_3  # a train comes into q10_bypass2 at q10_bypass2|q9@P3.normal (R9)
        NU_q11_material_2 = VALID and F_q11_material and (not D_q11_material) and (not U_q11_material) and L_q11_material_2 and OCC_q11_material and OCC_q9 and U_q9 and L_q9_4  # a train comes into q11_material at q11_material|q9@P3.reverse (R9)
        NU_q12_1 = VALID and F_q12 and (not D_q12) and (not U_q12) and L_q12_1 and OCC_q12 and OCC_q13_man  # a train comes into q12 at q12|q13_man@P4.reverse (R9)
        NU_q12_2 = VALID and F_q12 and (not D_q12) and (not U_q12) and (L_q12_2 or L_q12_3) and OCC_q12 and OCC_q7 and U_q7 and (L_q7_1 or L_q7_4)  # a train comes into q12 at q12|q7@P2.toe (R9)
        NU_q12_3 = VALID and F_q12 and (not D_q12) and (not U_q12) and L_q12_4 and OCC_q12 and OCC_q8_dep  # a train comes into q12 at q12|q8_dep@P4.normal (R9)
        NU_q13_man_2 = VALID and F_q13_man and (not D_q13_man) and (not U_q13_man) and L_q13_man_2 and OCC_q13_man and OCC_q12 and U_q12 and L_q12_2  # a train comes into q13_man at q12|q13_man@P4.reverse (R9)
        NU_q2_1 = VALID and F_q2 and (not D_q2) and (not U_q2) and (L_q2_1 or L_q2_2) and OCC_q2 and OCC_q1  # a train comes into q2 at q1|q2@P1.toe (R9)
        NU_q2_3 = VALID and F_q2 and (not D_q2) and (not U_q2) and L_q2_4 and OCC_q2 and OCC_q5_bypass1  # a train comes into q2 at q2|q5_bypass1@P1.reverse (R9)
        NU_q3_heavy_1 = VALID and F_q3_heavy and (not D_q3_heavy) and (not U_q3_heavy) and L_q3_heavy_1 and OCC_q3_heavy and OCC_q2 and U_q2 and L_q2_1  # a train comes into q3_heavy at q2|q3_heavy@P1.normal (R9)
        NU_q4_tippler_1 = VALID and F_q4_tippler and (not D_q4_tippler) and (not U_q4_tippler) and L_q4_tippler_1 and OCC_q4_tippler and OCC_q3_heavy  # a train comes into q4_tippler at q3_heavy|q4_tippler@heavy.0 (R9)
        NU_q5_bypass1_1 = VALID and F_q5_bypass1 and (not D_q5_bypass1) and (not U_q5_bypass1) and L_q5_bypass1_1 and OCC_q5_bypass1 and OCC_q2 and U_q2 and L_q2_2  # a train comes into q5_bypass1 at q2|q5_bypass1@P1.reverse (R9)
        NU_q5_bypass1_2 = VALID and F_q5_bypass1 and (not D_q5_bypass1) and (not U_q5_bypass1) and L_q5_bypass1_2 and OCC_q5_bypass1 and OCC_q9 and U_q9 and (L_q9_1 or L_q9_2)  # a train comes into q5_bypass1 at q5_bypass1|q9@P3.toe (R9)
        NU_q6_empty_1 = VALID and F_q6_empty and (not D_q6_empty) and (not U_q6_empty) and L_q6_empty_1 and OCC_q6_empty and OCC_q4_tippler and U_q4_tippler and L_q4_tippler_1  # a train comes into q6_empty at q4_tippler|q6_empty@heavy.1 (R9)
        NU_q7_1 = VALID and F_q7 and (not D_q7) and (not U_q7) and L_q7_1 and OCC_q7 and OCC_q10_bypass2  # a train comes into q7 at q10_bypass2|q7@P2.reverse (R9)
        NU_q7_2 = VALID and F_q7 and (not D_q7) and (not U_q7) and L_q7_2 and OCC_q7 and OCC_q12 and U_q12 and (L_q12_1 or L_q12_4)  # a train comes into q7 at q12|q7@P2.toe (R9)
        NU_q7_3 = VALID and F_q7 and (not D_q7) and (not U_q7) and L_q7_4 and OCC_q7 and OCC_q6_empty  # a train comes into q7 at q6_empty|q7@P2.normal (R9)
        NU_q8_dep_1 = VALID and F_q8_dep and (not D_q8_dep) and (not U_q8_dep) and L_q8_dep_1 and OCC_q8_dep and OCC_ap_E  # a train comes into q8_dep at E (R9)
        NU_q8_dep_2 = VALID and F_q8_dep and (not D_q8_dep) and (not U_q8_dep) and L_q8_dep_2 and OCC_q8_dep and OCC_q12 and U_q12 and L_q12_3  # a train comes into q8_dep at q12|q8_dep@P4.normal (R9)
        NU_q9_1 = VALID and F_q9 and (not D_q9) and (not U_q9) and L_q9_1 and OCC_q9 and OCC_q10_bypass2  # a train comes into q9 at q10_bypass2|q9@P3.normal (R9)
        NU_q9_2 = VALID and F_q9 and (not D_q9) and (not U_q9) and L_q9_2 and OCC_q9 and OCC_q11_material  # a train comes into q9 at q11_material|q9@P3.reverse (R9)
        NU_q9_3 = VALID and F_q9 and (not D_q9) and (not U_q9) and (L_q9_3 or L_q9_4) and OCC_q9 and OCC_q5_bypass1  # a train comes into q9 at q5_bypass1|q9@P3.toe (R9)
        ATI_S0 = X_S0 or ((not A_R1) and L_q1_1 and REL_q1)  # S0 at stop, waiting for a train that may still come (R8)
        ATI_S1 = X_S1 or ((not (A_R2 or A_R3)) and (not (PA_R2 or PA_R3)) and (L_q2_1 or L_q2_2) and REL_q2)  # S1 at stop, waiting for a train that may still come (R8)
        ATI_S10 = X_S10 or ((not A_R4) and (not PA_R4) and L_q9_1 and REL_q9)  # S10 at stop, waiting for a train that may still come (R8)
        ATI_S11 = X_S11 or ((not A_R5) and (not PA_R5) and L_q2_4 and REL_q2)  # S11 at stop, waiting for a train that may still come (R8)
        ATI_S2 = X_S2 or ((not A_R6) and (not PA_R6) and L_q4_tippler_1 and REL_q4_tippler)  # S2 at stop, waiting for a train that may still come (R8)
        ATI_S3 = X_S3 or ((not (A_R7 or A_R8)) and (not (PA_R7 or PA_R8)) and L_q7_4 and REL_q7)  # S3 at stop, waiting for a train that may still come (R8)
        ATI_S4 = X_S4 or ((not (A_R9 or A_R10)) and (not (PA_R9 or PA_R10)) and (L_q9_3 or L_q9_4) and REL_q9)  # S4 at stop, waiting for a train that may still come (R8)
        ATI_S5 = X_S5 or ((not (A_R11 or A_R12)) and (not (PA_R11 or PA_R12)) and L_q7_1 and REL_q7)  # S5 at stop, waiting for a train that may still come (R8)
        ATI_S6 = X_S6 or ((not A_R13) and (not PA_R13) and L_q9_2 and REL_q9)  # S6 at stop, waiting for a train that may still come (R8)
        ATI_S7 = X_S7 or ((not A_R14) and (not PA_R14) and L_q12_1 and REL_q12)  # S7 at stop, waiting for a train that may still come (R8)
        ATI_S8 = X_S8 or ((not A_R15) and L_q8_dep_1 and REL_q8_dep)  # S8 at stop, waiting for a train that may still come (R8)
        ATI_S9 = X_S9 or ((not A_R16) and (not PA_R16) and L_q12_4 and REL_q12)  # S9 at stop, waiting for a train that may still come (R8)
        AT_S0 = self._timer('AT_S0', ATI_S0, dt_ms)  # S0: approach locking delay (R8)
        AT_S1 = self._timer('AT_S1', ATI_S1, dt_ms)  # S1: approach locking delay (R8)
        AT_S10 = self._timer('AT_S10', ATI_S10, dt_ms)  # S10: approach locking delay (R8)
        AT_S11 = self._timer('AT_S11', ATI_S11, dt_ms)  # S11: approach locking delay (R8)
        AT_S2 = self._timer('AT_S2', ATI_S2, dt_ms)  # S2: approach locking delay (R8)
        AT_S3 = self._timer('AT_S3', ATI_S3, dt_ms)  # S3: approach locking delay (R8)
        AT_S4 = self._timer('AT_S4', ATI_S4, dt_ms)  # S4: approach locking delay (R8)
        AT_S5 = self._timer('AT_S5', ATI_S5, dt_ms)  # S5: approach locking delay (R8)
        AT_S6 = self._timer('AT_S6', ATI_S6, dt_ms)  # S6: approach locking delay (R8)
        AT_S7 = self._timer('AT_S7', ATI_S7, dt_ms)  # S7: approach locking delay (R8)
        AT_S8 = self._timer('AT_S8', ATI_S8, dt_ms)  # S8: approach locking delay (R8)
        AT_S9 = self._timer('AT_S9', ATI_S9, dt_ms)  # S9: approach locking delay (R8)
        CD_S0 = X_S0 and A_R1 and VALID and (not OCC_q1) and ((not OCC_ap_W) or AT_S0 or (not H_R1))  # the route from S0 is cancelled (R8)
        CD_S1 = X_S1 and (A_R2 or A_R3) and VALID and (not OCC_q2) and ((not OCC_q1) or AT_S1 or (not (H_R2 or H_R3)))  # the route from S1 is cancelled (R8)
        CD_S10 = X_S10 and A_R4 and VALID and (not OCC_q9) and ((not OCC_q10_bypass2) or AT_S10 or (not H_R4))  # the route from S10 is cancelled (R8)
        CD_S11 = X_S11 and A_R5 and VALID and (not OCC_q2) and ((not OCC_q5_bypass1) or AT_S11 or (not H_R5))  # the route from S11 is cancelled (R8)
        CD_S2 = X_S2 and A_R6 and VALID and (not OCC_q4_tippler) and ((not OCC_q3_heavy) or AT_S2 or (not H_R6))  # the route from S2 is cancelled (R8)
        CD_S3 = X_S3 and (A_R7 or A_R8) and VALID and (not OCC_q7) and ((not OCC_q6_empty) or AT_S3 or (not (H_R7 or H_R8)))  # the route from S3 is cancelled (R8)
        CD_S4 = X_S4 and (A_R9 or A_R10) and VALID and (not OCC_q9) and ((not OCC_q5_bypass1) or AT_S4 or (not (H_R9 or H_R10)))  # the route from S4 is cancelled (R8)
        CD_S5 = X_S5 and (A_R11 or A_R12) and VALID and (not OCC_q7) and ((not OCC_q10_bypass2) or AT_S5 or (not (H_R11 or H_R12)))  # the route from S5 is cancelled (R8)
        CD_S6 = X_S6 and A_R13 and VALID and (not OCC_q9) and ((not OCC_q11_material) or AT_S6 or (not H_R13))  # the route from S6 is cancelled (R8)
        CD_S7 = X_S7 and A_R14 and VALID and (not OCC_q12) and ((not OCC_q13_man) or AT_S7 or (not H_R14))  # the route from S7 is cancelled (R8)
        CD_S8 = X_S8 and A_R15 and VALID and (not OCC_q8_dep) and ((not OCC_ap_E) or AT_S8 or (not H_R15))  # the route from S8 is cancelled (R8)
        CD_S9 = X_S9 and A_R16 and VALID and (not OCC_q12) and ((not OCC_q8_dep) or AT_S9 or (not H_R16))  # the route from S9 is cancelled (R8)
        EX_q1 = P_q1 or L_q1_2  # a train in q1 leaves over a boundary, or has passed on
        RTI_q1 = VALID and U_q1 and (not OCC_q1) and (not (L_q1_2 and L_q2_4)) and EX_q1  # q1 may be released behind the train (R9)
        EX_q10_bypass2 = P_q10_bypass2  # a train in q10_bypass2 leaves over a boundary, or has passed on
        RTI_q10_bypass2 = VALID and U_q10_bypass2 and (not OCC_q10_bypass2) and (not (L_q10_bypass2_1 and L_q7_2)) and (not (L_q10_bypass2_2 and L_q9_3)) and EX_q10_bypass2  # q10_bypass2 may be released behind the train (R9)
        EX_q11_material = P_q11_material  # a train in q11_material leaves over a boundary, or has passed on
        RTI_q11_material = VALID and U_q11_material and (not OCC_q11_material) and (not (L_q11_material_2 and L_q9_4)) and EX_q11_material  # q11_material may be released behind the train (R9)
        EX_q12 = P_q12  # a train in q12 leaves over a boundary, or has passed on
        RTI_q12 = VALID and U_q12 and (not OCC_q12) and (not (PA_R14 or PA_R16)) and (not ((L_q12_2 or L_q12_3) and (L_q7_1 or L_q7_4))) and EX_q12  # q12 may be released behind the train (R9)
        EX_q13_man = P_q13_man  # a train in q13_man leaves over a boundary, or has passed on
        RTI_q13_man = VALID and U_q13_man and (not OCC_q13_man) and (not (L_q13_man_2 and L_q12_2)) and EX_q13_man  # q13_man may be released behind the train (R9)
        EX_q2 = P_q2  # a train in q2 leaves over a boundary, or has passed on
        RTI_q2 = VALID and U_q2 and (not OCC_q2) and (not (PA_R2 or PA_R3 or PA_R5)) and EX_q2  # q2 may be released behind the train (R9)
        EX_q3_heavy = P_q3_heavy  # a train in q3_heavy leaves over a boundary, or has passed on
        RTI_q3_heavy = VALID and U_q3_heavy and (not OCC_q3_heavy) and (not (L_q3_heavy_1 and L_q2_1)) and EX_q3_heavy  # q3_heavy may be released behind the train (R9)
        EX_q4_tippler = P_q4_tippler  # a train in q4_tippler leaves over a boundary, or has passed on
        RTI_q4_tippler = VALID and U_q4_tippler and (not OCC_q4_tippler) and (not PA_R6) and EX_q4_tippler  # q4_tippler may be released behind the train (R9)
        EX_q5_bypass1 = P_q5_bypass1  # a train in q5_bypass1 leaves over a boundary, or has passed on
        RTI_q5_bypass1 = VALID and U_q5_bypass1 and (not OCC_q5_bypass1) and (not (L_q5_bypass1_1 and L_q2_2)) and (not (L_q5_bypass1_2 and (L_q9_1 or L_q9_2))) and EX_q5_bypass1  # q5_bypass1 may be released behind the train (R9)
        EX_q6_empty = P_q6_empty  # a train in q6_empty leaves over a boundary, or has passed on
        RTI_q6_empty = VALID and U_q6_empty and (not OCC_q6_empty) and (not (L_q6_empty_1 and L_q4_tippler_1)) and EX_q6_empty  # q6_empty may be released behind the train (R9)
        EX_q7 = P_q7  # a train in q7 leaves over a boundary, or has passed on
        RTI_q7 = VALID and U_q7 and (not OCC_q7) and (not (PA_R11 or PA_R12 or PA_R7 or PA_R8)) and (not (L_q7_2 and (L_q12_1 or L_q12_4))) and EX_q7  # q7 may be released behind the train (R9)
        EX_q8_dep = P_q8_dep or L_q8_dep_2  # a train in q8_dep leaves over a boundary, or has passed on
        RTI_q8_dep = VALID and U_q8_dep and (not OCC_q8_dep) and (not (L_q8_dep_2 and L_q12_3)) and EX_q8_dep  # q8_dep may be released behind the train (R9)
        EX_q9 = P_q9  # a train in q9 leaves over a boundary, or has passed on
        RTI_q9 = VALID and U_q9 and (not OCC_q9) and (not (PA_R4 or PA_R13 or PA_R9 or PA_R10)) and EX_q9  # q9 may be released behind the train (R9)
        RT_q1 = self._timer('RT_q1', RTI_q1, dt_ms)  # q1: release delay (R9)
        RT_q10_bypass2 = self._timer('RT_q10_bypass2', RTI_q10_bypass2, dt_ms)  # q10_bypass2: release delay (R9)
        RT_q11_material = self._timer('RT_q11_material', RTI_q11_material, dt_ms)  # q11_material: release delay (R9)
        RT_q12 = self._timer('RT_q12', RTI_q12, dt_ms)  # q12: release delay (R9)
        RT_q13_man = self._timer('RT_q13_man', RTI_q13_man, dt_ms)  # q13_man: release delay (R9)
        RT_q2 = self._timer('RT_q2', RTI_q2, dt_ms)  # q2: release delay (R9)
        RT_q3_heavy = self._timer('RT_q3_heavy', RTI_q3_heavy, dt_ms)  # q3_heavy: release delay (R9)
        RT_q4_tippler = self._timer('RT_q4_tippler', RTI_q4_tippler, dt_ms)  # q4_tippler: release delay (R9)
        RT_q5_bypass1 = self._timer('RT_q5_bypass1', RTI_q5_bypass1, dt_ms)  # q5_bypass1: release delay (R9)
        RT_q6_empty = self._timer('RT_q6_empty', RTI_q6_empty, dt_ms)  # q6_empty: release delay (R9)
        RT_q7 = self._timer('RT_q7', RTI_q7, dt_ms)  # q7: release delay (R9)
        RT_q8_dep = self._timer('RT_q8_dep', RTI_q8_dep, dt_ms)  # q8_dep: release delay (R9)
        RT_q9 = self._timer('RT_q9', RTI_q9, dt_ms)  # q9: release delay (R9)
        CA_q1 = VALID and (not OCC_q1) and (not U_q1) and L_q1_2 and (not (L_q1_2 and L_q2_4))  # the lock before q1 was withdrawn (R8)
        HR_q1 = VALID and (not OCC_q1) and (not (L_q1_2 and L_q2_4)) and REL_q1 and (L_q1_1 or L_q1_2) and ((not L_q1_1) or ((not A_R1) and ((not OCC_ap_W) or AT_S0)))  # q1 released by hand (R8, section fault release)
        SR_q1 = VALID and (not OCC_q1) and K_q1 and (REL_q1 or RELALL)  # q1 released after a restart (R16)
        RLS_q1 = RT_q1 or CA_q1 or CD_S0 or HR_q1 or SR_q1  # q1 is released
        CA_q10_bypass2 = VALID and (not OCC_q10_bypass2) and (not U_q10_bypass2) and (L_q10_bypass2_1 or L_q10_bypass2_2) and (not (L_q10_bypass2_1 and L_q7_2)) and (not (L_q10_bypass2_2 and L_q9_3))  # the lock before q10_bypass2 was withdrawn (R8)
        HR_q10_bypass2 = VALID and (not OCC_q10_bypass2) and (not (L_q10_bypass2_1 and L_q7_2)) and (not (L_q10_bypass2_2 and L_q9_3)) and REL_q10_bypass2 and (L_q10_bypass2_1 or L_q10_bypass2_2)  # q10_bypass2 released by hand (R8, section fault release)
        SR_q10_bypass2 = VALID and (not OCC_q10_bypass2) and K_q10_bypass2 and (REL_q10_bypass2 or RELALL)  # q10_bypass2 released after a restart (R16)
        RLS_q10_bypass2 = RT_q10_bypass2 or CA_q10_bypass2 or HR_q10_bypass2 or SR_q10_bypass2  # q10_bypass2 is released
        CA_q11_material = VALID and (not OCC_q11_material) and (not U_q11_material) and L_q11_material_2 and (not (L_q11_material_2 and L_q9_4))  # the lock before q11_material was withdrawn (R8)
        HR_q11_material = VALID and (not OCC_q11_material) and (not (L_q11_material_2 and L_q9_4)) and REL_q11_material and L_q11_material_2  # q11_material released by hand (R8, section fault release)
        SR_q11_material = VALID and (not OCC_q11_material) and K_q11_material and (REL_q11_material or RELALL)  # q11_material released after a restart (R16)
        RLS_q11_material = RT_q11_material or CA_q11_material or HR_q11_material or SR_q11_material  # q11_material is released
        CA_q12 = VALID and (not OCC_q12) and (not U_q12) and (L_q12_2 or L_q12_3) and (not ((L_q12_2 or L_q12_3) and (L_q7_1 or L_q7_4)))  # the lock before q12 was withdrawn (R8)
        HR_q12 = VALID and (not OCC_q12) and (not (PA_R14 or PA_R16)) and (not ((L_q12_2 or L_q12_3) and (L_q7_1 or L_q7_4))) and REL_q12 and (L_q12_1 or L_q12_2 or L_q12_3 or L_q12_4) and ((not L_q12_1) or ((not A_R14) and ((not OCC_q13_man) or AT_S7))) and ((not L_q12_4) or ((not A_R16) and ((not OCC_q8_dep) or AT_S9)))  # q12 released by hand (R8, section fault release)
        SR_q12 = VALID and (not OCC_q12) and K_q12 and (REL_q12 or RELALL)  # q12 released after a restart (R16)
        RLS_q12 = RT_q12 or CA_q12 or CD_S7 or CD_S9 or HR_q12 or SR_q12  # q12 is released
        CA_q13_man = VALID and (not OCC_q13_man) and (not U_q13_man) and L_q13_man_2 and (not (L_q13_man_2 and L_q12_2))  # the lock before q13_man was withdrawn (R8)
        HR_q13_man = VALID and (not OCC_q13_man) and (not (L_q13_man_2 and L_q12_2)) and REL_q13_man and L_q13_man_2  # q13_man released by hand (R8, section fault release)
        SR_q13_man = VALID and (not OCC_q13_man) and K_q13_man and (REL_q13_man or RELALL)  # q13_man released after a restart (R16)
        RLS_q13_man = RT_q13_man or CA_q13_man or HR_q13_man or SR_q13_man  # q13_man is released
        CA_q2 = VALID and (not OCC_q2) and (not U_q2) and False  # the lock before q2 was withdrawn (R8)
        HR_q2 = VALID and (not OCC_q2) and (not (PA_R2 or PA_R3 or PA_R5)) and REL_q2 and (L_q2_1 or L_q2_2 or L_q2_4) and ((not (L_q2_1 or L_q2_2)) or ((not (A_R2 or A_R3)) and ((not OCC_q1) or AT_S1))) and ((not L_q2_4) or ((not A_R5) and ((not OCC_q5_bypass1) or AT_S11)))  # q2 released by hand (R8, section fault release)
        SR_q2 = VALID and (not OCC_q2) and K_q2 and (REL_q2 or RELALL)  # q2 released after a restart (R16)
        RLS_q2 = RT_q2 or CA_q2 or CD_S1 or CD_S11 or HR_q2 or SR_q2  # q2 is released
        CA_q3_heavy = VALID and (not OCC_q3_heavy) and (not U_q3_heavy) and L_q3_heavy_1 and (not (L_q3_heavy_1 and L_q2_1))  # the lock before q3_heavy was withdrawn (R8)
        HR_q3_heavy = VALID and (not OCC_q3_heavy) and (not (L_q3_heavy_1 and L_q2_1)) and REL_q3_heavy and L_q3_heavy_1  # q3_heavy released by hand (R8, section fault release)
        SR_q3_heavy = VALID and (not OCC_q3_heavy) and K_q3_heavy and (REL_q3_heavy or RELALL)  # q3_heavy released after a restart (R16)
        RLS_q3_heavy = RT_q3_heavy or CA_q3_heavy or HR_q3_heavy or SR_q3_heavy  # q3_heavy is released
        CA_q4_tippler = VALID and (not OCC_q4_tippler) and (not U_q4_tippler) and False  # the lock before q4_tippler was withdrawn (R8)
        HR_q4_tippler = VALID and (not OCC_q4_tippler) and (not PA_R6) and REL_q4_tippler and L_q4_tippler_1 and ((not L_q4_tippler_1) or ((not A_R6) and ((not OCC_q3_heavy) or AT_S2)))  # q4_tippler released by hand (R8, section fault release)
        SR_q4_tippler = VALID and (not OCC_q4_tippler) and K_q4_tippler and (REL_q4_tippler or RELALL)  # q4_tippler released after a restart (R16)
        RLS_q4_tippler = RT_q4_tippler or CA_q4_tippler or CD_S2 or HR_q4_tippler or SR_q4_tippler  # q4_tippler is released
        CA_q5_bypass1 = VALID and (not OCC_q5_bypass1) and (not U_q5_bypass1) and (L_q5_bypass1_1 or L_q5_bypass1_2) and (not (L_q5_bypass1_1 and L_q2_2)) and (not (L_q5_bypass1_2 and (L_q9_1 or L_q9_2)))  # the lock before q5_bypass1 was withdrawn (R8)
        HR_q5_bypass1 = VALID and (not OCC_q5_bypass1) and (not (L_q5_bypass1_1 and L_q2_2)) and (not (L_q5_bypass1_2 and (L_q9_1 or L_q9_2))) and REL_q5_bypass1 and (L_q5_bypass1_1 or L_q5_bypass1_2)  # q5_bypass1 released by hand (R8, section fault release)
        SR_q5_bypass1 = VALID and (not OCC_q5_bypass1) and K_q5_bypass1 and (REL_q5_bypass1 or RELALL)  # q5_bypass1 released after a restart (R16)
        RLS_q5_bypass1 = RT_q5_bypass1 or CA_q5_bypass1 or HR_q5_bypass1 or SR_q5_bypass1  # q5_bypass1 is released
        CA_q6_empty = VALID and (not OCC_q6_empty) and (not U_q6_empty) and L_q6_empty_1 and (not (L_q6_empty_1 and L_q4_tippler_1))  # the lock before q6_empty was withdrawn (R8)
        HR_q6_empty = VALID and (not OCC_q6_empty) and (not (L_q6_empty_1 and L_q4_tippler_1)) and REL_q6_empty and L_q6_empty_1  # q6_empty released by hand (R8, section fault release)
        SR_q6_empty = VALID and (not OCC_q6_empty) and K_q6_empty and (REL_q6_empty or RELALL)  # q6_empty released after a restart (R16)
        RLS_q6_empty = RT_q6_empty or CA_q6_empty or HR_q6_empty or SR_q6_empty  # q6_empty is released
        CA_q7 = VALID and (not OCC_q7) and (not U_q7) and L_q7_2 and (not (L_q7_2 and (L_q12_1 or L_q12_4)))  # the lock before q7 was withdrawn (R8)
        HR_q7 = VALID and (not OCC_q7) and (not (PA_R11 or PA_R12 or PA_R7 or PA_R8)) and (not (L_q7_2 and (L_q12_1 or L_q12_4))) and REL_q7 and (L_q7_1 or L_q7_2 or L_q7_4) and ((not L_q7_1) or ((not (A_R11 or A_R12)) and ((not OCC_q10_bypass2) or AT_S5))) and ((not L_q7_4) or ((not (A_R7 or A_R8)) and ((not OCC_q6_empty) or AT_S3)))  # q7 released by hand (R8, section fault release)
        SR_q7 = VALID and (not OCC_q7) and K_q7 and (REL_q7 or RELALL)  # q7 released after a restart (R16)
        RLS_q7 = RT_q7 or CA_q7 or CD_S5 or CD_S3 or HR_q7 or SR_q7  # q7 is released
        CA_q8_dep = VALID and (not OCC_q8_dep) and (not U_q8_dep) and L_q8_dep_2 and (not (L_q8_dep_2 and L_q12_3))  # the lock before q8_dep was withdrawn (R8)
        HR_q8_dep = VALID and (not OCC_q8_dep) and (not (L_q8_dep_2 and L_q12_3)) and REL_q8_dep and (L_q8_dep_1 or L_q8_dep_2) and ((not L_q8_dep_1) or ((not A_R15) and ((not OCC_ap_E) or AT_S8)))  # q8_dep released by hand (R8, section fault release)
        SR_q8_dep = VALID and (not OCC_q8_dep) and K_q8_dep and (REL_q8_dep or RELALL)  # q8_dep released after a restart (R16)
        RLS_q8_dep = RT_q8_dep or CA_q8_dep or CD_S8 or HR_q8_dep or SR_q8_dep  # q8_dep is released
        CA_q9 = VALID and (not OCC_q9) and (not U_q9) and False  # the lock before q9 was withdrawn (R8)
        HR_q9 = VALID and (not OCC_q9) and (not (PA_R4 or PA_R13 or PA_R9 or PA_R10)) and REL_q9 and (L_q9_1 or L_q9_2 or L_q9_3 or L_q9_4) and ((not L_q9_1) or ((not A_R4) and ((not OCC_q10_bypass2) or AT_S10))) and ((not L_q9_2) or ((not A_R13) and ((not OCC_q11_material) or AT_S6))) and ((not (L_q9_3 or L_q9_4)) or ((not (A_R9 or A_R10)) and ((not OCC_q5_bypass1) or AT_S4)))  # q9 released by hand (R8, section fault release)
        SR_q9 = VALID and (not OCC_q9) and K_q9 and (REL_q9 or RELALL)  # q9 released after a restart (R16)
        RLS_q9 = RT_q9 or CA_q9 or CD_S10 or CD_S6 or CD_S4 or HR_q9 or SR_q9  # q9 is released
        TG_P1 = (GW_q2_1 or GW_q2_2 or GW_q2_4)  # a grant touches machine P1 in this scan
        GPN_P1 = GW_q2_1  # a grant needs P1 N
        MAN_P1 = MN_P1 and (not MR_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved N by hand
        GPR_P1 = (GW_q2_2 or GW_q2_4)  # a grant needs P1 R
        MAR_P1 = MR_P1 and (not MN_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved R by hand
        HDN_P1 = CN_P1 and (not GPR_P1) and (not MAR_P1)  # the command N stays
        HDR_P1 = CR_P1 and (not GPN_P1) and (not MAN_P1)  # the command R stays
        TG_P2 = (GW_q7_1 or GW_q7_2 or GW_q7_4)  # a grant touches machine P2 in this scan
        GPN_P2 = GW_q7_4  # a grant needs P2 N
        MAN_P2 = MN_P2 and (not MR_P2) and MOV_P2 and (not TG_P2)  # machine P2 moved N by hand
        GPR_P2 = (GW_q7_1 or GW_q7_2)  # a grant needs P2 R
        MAR_P2 = MR_P2 and (not MN_P2) and MOV_P2 and (not TG_P2)  # machine P2 moved R by hand
        HDN_P2 = CN_P2 and (not GPR_P2) and (not MAR_P2)  # the command N stays
        HDR_P2 = CR_P2 and (not GPN_P2) and (not MAN_P2)  # the command R stays
        TG_P3 = (GW_q9_1 or GW_q9_2 or GW_q9_3 or GW_q9_4)  # a grant touches machine P3 in this scan
        GPN_P3 = (GW_q9_1 or GW_q9_3)  # a grant needs P3 N
        MAN_P3 = MN_P3 and (not MR_P3) and MOV_P3 and (not TG_P3)  # machine P3 moved N by hand
        GPR_P3 = (GW_q9_2 or GW_q9_4)  # a grant needs P3 R
        MAR_P3 = MR_P3 and (not MN_P3) and MOV_P3 and (not TG_P3)  # machine P3 moved R by hand
        HDN_P3 = CN_P3 and (not GPR_P3) and (not MAR_P3)  # the command N stays
        HDR_P3 = CR_P3 and (not GPN_P3) and (not MAN_P3)  # the command R stays
        TG_P4 = (GW_q12_1 or GW_q12_2 or GW_q12_3 or GW_q12_4)  # a grant touches machine P4 in this scan
        GPN_P4 = (GW_q12_3 or GW_q12_4)  # a grant needs P4 N
        MAN_P4 = MN_P4 and (not MR_P4) and MOV_P4 and (not TG_P4)  # machine P4 moved N by hand
        GPR_P4 = (GW_q12_1 or GW_q12_2)  # a grant needs P4 R
        MAR_P4 = MR_P4 and (not MN_P4) and MOV_P4 and (not TG_P4)  # machine P4 moved R by hand
        HDN_P4 = CN_P4 and (not GPR_P4) and (not MAR_P4)  # the command N stays
        HDR_P4 = CR_P4 and (not GPN_P4) and (not MAN_P4)  # the command R stays
        STI_P1 = (CN_P1 and (not QN_P1)) or (CR_P1 and (not QR_P1))  # machine P1 is not where it was commanded
        STI_P2 = (CN_P2 and (not QN_P2)) or (CR_P2 and (not QR_P2))  # machine P2 is not where it was commanded
        STI_P3 = (CN_P3 and (not QN_P3)) or (CR_P3 and (not QR_P3))  # machine P3 is not where it was commanded
        STI_P4 = (CN_P4 and (not QN_P4)) or (CR_P4 and (not QR_P4))  # machine P4 is not where it was commanded
        ST_P1 = self._timer('ST_P1', STI_P1, dt_ms)  # machine P1: time-out
        ST_P2 = self._timer('ST_P2', STI_P2, dt_ms)  # machine P2: time-out
        ST_P3 = self._timer('ST_P3', STI_P3, dt_ms)  # machine P3: time-out
        ST_P4 = self._timer('ST_P4', STI_P4, dt_ms)  # machine P4: time-out
        KP_R1 = (not NU_q1_1) and (not CD_S0)  # route S0-S1 stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_S0) and (not CAN_S0)  # proceed for route S0-S1 (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route S0-S1: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_q2_1) and (not CD_S1)  # route S1-S2 stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_S1) and (not CAN_S1)  # proceed for route S1-S2 (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route S1-S2: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_q2_1) and (not CD_S1)  # route S1-S4 stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_S1) and (not CAN_S1)  # proceed for route S1-S4 (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route S1-S4: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_q9_1) and (not CD_S10)  # route S10-S11 stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_S10) and (not CAN_S10)  # proceed for route S10-S11 (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route S10-S11: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_q2_3) and (not CD_S11)  # route S11-W stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_S11) and (not CAN_S11)  # proceed for route S11-W (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route S11-W: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_q4_tippler_1) and (not CD_S2)  # route S2-S3 stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_S2) and (not CAN_S2)  # proceed for route S2-S3 (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route S2-S3: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_q7_3) and (not CD_S3)  # route S3-E stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_S3) and (not CAN_S3)  # proceed for route S3-E (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route S3-E: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_q7_3) and (not CD_S3)  # route S3-MAN stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_S3) and (not CAN_S3)  # proceed for route S3-MAN (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route S3-MAN: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_q9_3) and (not CD_S4)  # route S4-MAT stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_S4) and (not CAN_S4)  # proceed for route S4-MAT (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route S4-MAT: a condition was lost; no reopening by itself (R14)
        KP_R10 = (not NU_q9_3) and (not CD_S4)  # route S4-S5 stays set
        PR_R10 = A_R10 and B_R10 and W_R10 and CO_R10 and KP_R10 and (not X_S4) and (not CAN_S4)  # proceed for route S4-S5 (R3, R11)
        LS_R10 = S_R10 and (not CO_R10)  # route S4-S5: a condition was lost; no reopening by itself (R14)
        KP_R11 = (not NU_q7_1) and (not CD_S5)  # route S5-E stays set
        PR_R11 = A_R11 and B_R11 and W_R11 and CO_R11 and KP_R11 and (not X_S5) and (not CAN_S5)  # proceed for route S5-E (R3, R11)
        LS_R11 = S_R11 and (not CO_R11)  # route S5-E: a condition was lost; no reopening by itself (R14)
        KP_R12 = (not NU_q7_1) and (not CD_S5)  # route S5-MAN stays set
        PR_R12 = A_R12 and B_R12 and W_R12 and CO_R12 and KP_R12 and (not X_S5) and (not CAN_S5)  # proceed for route S5-MAN (R3, R11)
        LS_R12 = S_R12 and (not CO_R12)  # route S5-MAN: a condition was lost; no reopening by itself (R14)
        KP_R13 = (not NU_q9_2) and (not CD_S6)  # route S6-S11 stays set
        PR_R13 = A_R13 and B_R13 and W_R13 and CO_R13 and KP_R13 and (not X_S6) and (not CAN_S6)  # proceed for route S6-S11 (R3, R11)
        LS_R13 = S_R13 and (not CO_R13)  # route S6-S11: a condition was lost; no reopening by itself (R14)
        KP_R14 = (not NU_q12_1) and (not CD_S7)  # route S7-S10 stays set
        PR_R14 = A_R14 and B_R14 and W_R14 and CO_R14 and KP_R14 and (not X_S7) and (not CAN_S7)  # proceed for route S7-S10 (R3, R11)
        LS_R14 = S_R14 and (not CO_R14)  # route S7-S10: a condition was lost; no reopening by itself (R14)
        KP_R15 = (not NU_q8_dep_1) and (not CD_S8)  # route S8-S9 stays set
        PR_R15 = A_R15 and B_R15 and W_R15 and CO_R15 and KP_R15 and (not X_S8) and (not CAN_S8)  # proceed for route S8-S9 (R3, R11)
        LS_R15 = S_R15 and (not CO_R15)  # route S8-S9: a condition was lost; no reopening by itself (R14)
        KP_R16 = (not NU_q12_3) and (not CD_S9)  # route S9-S10 stays set
        PR_R16 = A_R16 and B_R16 and W_R16 and CO_R16 and KP_R16 and (not X_S9) and (not CAN_S9)  # proceed for route S9-S10 (R3, R11)
        LS_R16 = S_R16 and (not CO_R16)  # route S9-S10: a condition was lost; no reopening by itself (R14)
        N_CN_P1 = GPN_P1 or MAN_P1 or HDN_P1  # machine P1 commanded N
        N_CR_P1 = GPR_P1 or MAR_P1 or HDR_P1  # machine P1 commanded R
        N_CN_P2 = GPN_P2 or MAN_P2 or HDN_P2  # machine P2 commanded N
        N_CR_P2 = GPR_P2 or MAR_P2 or HDR_P2  # machine P2 commanded R
        N_CN_P3 = GPN_P3 or MAN_P3 or HDN_P3  # machine P3 commanded N
        N_CR_P3 = GPR_P3 or MAR_P3 or HDR_P3  # machine P3 commanded R
        N_CN_P4 = GPN_P4 or MAN_P4 or HDN_P4  # machine P4 commanded N
        N_CR_P4 = GPR_P4 or MAR_P4 or HDR_P4  # machine P4 commanded R
        N_AL_P1 = ST_P1  # alarm: machine P1 not detected
        N_AL_P2 = ST_P2  # alarm: machine P2 not detected
        N_AL_P3 = ST_P3  # alarm: machine P3 not detected
        N_AL_P4 = ST_P4  # alarm: machine P4 not detected
        N_TH_P1 = ((CN_P1 and QN_P1) or (CR_P1 and QR_P1)) and (not (GPN_P1 or GPR_P1 or MAN_P1 or MAR_P1))  # machine P1 was detected where it is commanded
        N_TR_P1 = (TH_P1 and VALID and ((CN_P1 and (not QN_P1) and (not GPR_P1) and (not MAR_P1)) or (CR_P1 and (not QR_P1) and (not GPN_P1) and (not MAN_P1)))) or (TR_P1 and (not (TC_P1 and VALID and (not OCC_q2))))  # machine P1 was trailed
        N_TH_P2 = ((CN_P2 and QN_P2) or (CR_P2 and QR_P2)) and (not (GPN_P2 or GPR_P2 or MAN_P2 or MAR_P2))  # machine P2 was detected where it is commanded
        N_TR_P2 = (TH_P2 and VALID and ((CN_P2 and (not QN_P2) and (not GPR_P2) and (not MAR_P2)) or (CR_P2 and (not QR_P2) and (not GPN_P2) and (not MAN_P2)))) or (TR_P2 and (not (TC_P2 and VALID and (not OCC_q7))))  # machine P2 was trailed
        N_TH_P3 = ((CN_P3 and QN_P3) or (CR_P3 and QR_P3)) and (not (GPN_P3 or GPR_P3 or MAN_P3 or MAR_P3))  # machine P3 was detected where it is commanded
        N_TR_P3 = (TH_P3 and VALID and ((CN_P3 and (not QN_P3) and (not GPR_P3) and (not MAR_P3)) or (CR_P3 and (not QR_P3) and (not GPN_P3) and (not MAN_P3)))) or (TR_P3 and (not (TC_P3 and VALID and (not OCC_q9))))  # machine P3 was trailed
        N_TH_P4 = ((CN_P4 and QN_P4) or (CR_P4 and QR_P4)) and (not (GPN_P4 or GPR_P4 or MAN_P4 or MAR_P4))  # machine P4 was detected where it is commanded
        N_TR_P4 = (TH_P4 and VALID and ((CN_P4 and (not QN_P4) and (not GPR_P4) and (not MAR_P4)) or (CR_P4 and (not QR_P4) and (not GPN_P4) and (not MAN_P4)))) or (TR_P4 and (not (TC_P4 and VALID and (not OCC_q12))))  # machine P4 was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route S0-S1 active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route S0-S1 locked
        N_W_R1 = (W_R1 or LK_R1 or (((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and B_R1)) and (not LS_R1) and KP_R1 and (not X_S0) and (not CAN_S0)  # route S0-S1: proceed wanted
        N_S_R1 = PR_R1  # route S0-S1: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route S0-S1: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route S1-S2 active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route S1-S2 locked
        N_W_R2 = (W_R2 or LK_R2 or (((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) and B_R2)) and (not LS_R2) and KP_R2 and (not X_S1) and (not CAN_S1)  # route S1-S2: proceed wanted
        N_PA_R2 = (PA_R2 or (S_R2 and NU_q2_1)) and VALID and (not CAN_S1) and OCC_q1 and OCC_q2 and WD_q2_1 and (not BLK_q2) and (not BLK_q3_heavy) and (not D_q2)  # route S1-S2: open for the movement that passes S1
        N_S_R2 = PR_R2  # route S1-S2: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route S1-S2: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route S1-S4 active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route S1-S4 locked
        N_W_R3 = (W_R3 or LK_R3 or (((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and B_R3)) and (not LS_R3) and KP_R3 and (not X_S1) and (not CAN_S1)  # route S1-S4: proceed wanted
        N_PA_R3 = (PA_R3 or (S_R3 and NU_q2_1)) and VALID and (not CAN_S1) and OCC_q1 and OCC_q2 and WD_q2_2 and (not BLK_q2) and (not BLK_q5_bypass1) and (not D_q2)  # route S1-S4: open for the movement that passes S1
        N_S_R3 = PR_R3  # route S1-S4: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route S1-S4: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route S10-S11 active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route S10-S11 locked
        N_W_R4 = (W_R4 or LK_R4 or (((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and B_R4)) and (not LS_R4) and KP_R4 and (not X_S10) and (not CAN_S10)  # route S10-S11: proceed wanted
        N_PA_R4 = (PA_R4 or (S_R4 and NU_q9_1)) and VALID and (not CAN_S10) and OCC_q10_bypass2 and OCC_q9 and WD_q9_1 and (not BLK_q9) and (not BLK_q5_bypass1) and (not D_q9)  # route S10-S11: open for the movement that passes S10
        N_S_R4 = PR_R4  # route S10-S11: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route S10-S11: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route S11-W active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route S11-W locked
        N_W_R5 = (W_R5 or LK_R5 or (((LREQ == 5) or ((LREQ == 0) and (REQ == 5))) and B_R5)) and (not LS_R5) and KP_R5 and (not X_S11) and (not CAN_S11)  # route S11-W: proceed wanted
        N_PA_R5 = (PA_R5 or (S_R5 and NU_q2_3)) and VALID and (not CAN_S11) and OCC_q5_bypass1 and OCC_q2 and WD_q2_4 and (not BLK_q2) and (not BLK_q1) and (not OCC_ap_W) and (not D_q2)  # route S11-W: open for the movement that passes S11
        N_S_R5 = PR_R5  # route S11-W: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route S11-W: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route S2-S3 active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route S2-S3 locked
        N_W_R6 = (W_R6 or LK_R6 or (((LREQ == 6) or ((LREQ == 0) and (REQ == 6))) and B_R6)) and (not LS_R6) and KP_R6 and (not X_S2) and (not CAN_S2)  # route S2-S3: proceed wanted
        N_PA_R6 = (PA_R6 or (S_R6 and NU_q4_tippler_1)) and VALID and (not CAN_S2) and OCC_q3_heavy and OCC_q4_tippler and (not BLK_q4_tippler) and (not BLK_q6_empty) and E_PUSHER_HOME and E_TIP_HOME and (not D_q4_tippler)  # route S2-S3: open for the movement that passes S2
        N_S_R6 = PR_R6  # route S2-S3: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route S2-S3: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route S3-E active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route S3-E locked
        N_W_R7 = (W_R7 or LK_R7 or (((LREQ == 7) or ((LREQ == 0) and (REQ == 7))) and B_R7)) and (not LS_R7) and KP_R7 and (not X_S3) and (not CAN_S3)  # route S3-E: proceed wanted
        N_PA_R7 = (PA_R7 or (S_R7 and NU_q7_3)) and VALID and (not CAN_S3) and OCC_q6_empty and OCC_q7 and WD_q7_4 and (not BLK_q7) and WD_q12_3 and (not BLK_q12) and (not BLK_q8_dep) and (not OCC_ap_E) and (not D_q7)  # route S3-E: open for the movement that passes S3
        N_S_R7 = PR_R7  # route S3-E: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route S3-E: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route S3-MAN active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route S3-MAN locked
        N_W_R8 = (W_R8 or LK_R8 or (((LREQ == 8) or ((LREQ == 0) and (REQ == 8))) and B_R8)) and (not LS_R8) and KP_R8 and (not X_S3) and (not CAN_S3)  # route S3-MAN: proceed wanted
        N_PA_R8 = (PA_R8 or (S_R8 and NU_q7_3)) and VALID and (not CAN_S3) and OCC_q6_empty and OCC_q7 and WD_q7_4 and (not BLK_q7) and WD_q12_2 and (not BLK_q12) and (not BLK_q13_man) and (not D_q7)  # route S3-MAN: open for the movement that passes S3
        N_S_R8 = PR_R8  # route S3-MAN: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route S3-MAN: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route S4-MAT active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route S4-MAT locked
        N_W_R9 = (W_R9 or LK_R9 or (((LREQ == 9) or ((LREQ == 0) and (REQ == 9))) and B_R9)) and (not LS_R9) and KP_R9 and (not X_S4) and (not CAN_S4)  # route S4-MAT: proceed wanted
        N_PA_R9 = (PA_R9 or (S_R9 and NU_q9_3)) and VALID and (not CAN_S4) and OCC_q5_bypass1 and OCC_q9 and WD_q9_4 and (not BLK_q9) and (not BLK_q11_material) and (not D_q9)  # route S4-MAT: open for the movement that passes S4
        N_S_R9 = PR_R9  # route S4-MAT: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route S4-MAT: signal has been open
        N_A_R10 = (A_R10 or G_R10) and KP_R10  # route S4-S5 active
        N_B_R10 = (B_R10 or LK_R10) and KP_R10  # route S4-S5 locked
        N_W_R10 = (W_R10 or LK_R10 or (((LREQ == 10) or ((LREQ == 0) and (REQ == 10))) and B_R10)) and (not LS_R10) and KP_R10 and (not X_S4) and (not CAN_S4)  # route S4-S5: proceed wanted
        N_PA_R10 = (PA_R10 or (S_R10 and NU_q9_3)) and VALID and (not CAN_S4) and OCC_q5_bypass1 and OCC_q9 and WD_q9_3 and (not BLK_q9) and (not BLK_q10_bypass2) and (not D_q9)  # route S4-S5: open for the movement that passes S4
        N_S_R10 = PR_R10  # route S4-S5: proceed
        N_H_R10 = (H_R10 or PR_R10) and KP_R10  # route S4-S5: signal has been open
        N_A_R11 = (A_R11 or G_R11) and KP_R11  # route S5-E active
        N_B_R11 = (B_R11 or LK_R11) and KP_R11  # route S5-E locked
        N_W_R11 = (W_R11 or LK_R11 or (((LREQ == 11) or ((LREQ == 0) and (REQ == 11))) and B_R11)) and (not LS_R11) and KP_R11 and (not X_S5) and (not CAN_S5)  # route S5-E: proceed wanted
        N_PA_R11 = (PA_R11 or (S_R11 and NU_q7_1)) and VALID and (not CAN_S5) and OCC_q10_bypass2 and OCC_q7 and WD_q7_1 and (not BLK_q7) and WD_q12_3 and (not BLK_q12) and (not BLK_q8_dep) and (not OCC_ap_E) and (not D_q7)  # route S5-E: open for the movement that passes S5
        N_S_R11 = PR_R11  # route S5-E: proceed
        N_H_R11 = (H_R11 or PR_R11) and KP_R11  # route S5-E: signal has been open
        N_A_R12 = (A_R12 or G_R12) and KP_R12  # route S5-MAN active
        N_B_R12 = (B_R12 or LK_R12) and KP_R12  # route S5-MAN locked
        N_W_R12 = (W_R12 or LK_R12 or (((LREQ == 12) or ((LREQ == 0) and (REQ == 12))) and B_R12)) and (not LS_R12) and KP_R12 and (not X_S5) and (not CAN_S5)  # route S5-MAN: proceed wanted
        N_PA_R12 = (PA_R12 or (S_R12 and NU_q7_1)) and VALID and (not CAN_S5) and OCC_q10_bypass2 and OCC_q7 and WD_q7_1 and (not BLK_q7) and WD_q12_2 and (not BLK_q12) and (not BLK_q13_man) and (not D_q7)  # route S5-MAN: open for the movement that passes S5
        N_S_R12 = PR_R12  # route S5-MAN: proceed
        N_H_R12 = (H_R12 or PR_R12) and KP_R12  # route S5-MAN: signal has been open
        N_A_R13 = (A_R13 or G_R13) and KP_R13  # route S6-S11 active
        N_B_R13 = (B_R13 or LK_R13) and KP_R13  # route S6-S11 locked
        N_W_R13 = (W_R13 or LK_R13 or (((LREQ == 13) or ((LREQ == 0) and (REQ == 13))) and B_R13)) and (not LS_R13) and KP_R13 and (not X_S6) and (not CAN_S6)  # route S6-S11: proceed wanted
        N_PA_R13 = (PA_R13 or (S_R13 and NU_q9_2)) and VALID and (not CAN_S6) and OCC_q11_material and OCC_q9 and WD_q9_2 and (not BLK_q9) and (not BLK_q5_bypass1) and (not D_q9)  # route S6-S11: open for the movement that passes S6
        N_S_R13 = PR_R13  # route S6-S11: proceed
        N_H_R13 = (H_R13 or PR_R13) and KP_R13  # route S6-S11: signal has been open
        N_A_R14 = (A_R14 or G_R14) and KP_R14  # route S7-S10 active
        N_B_R14 = (B_R14 or LK_R14) and KP_R14  # route S7-S10 locked
        N_W_R14 = (W_R14 or LK_R14 or (((LREQ == 14) or ((LREQ == 0) and (REQ == 14))) and B_R14)) and (not LS_R14) and KP_R14 and (not X_S7) and (not CAN_S7)  # route S7-S10: proceed wanted
        N_PA_R14 = (PA_R14 or (S_R14 and NU_q12_1)) and VALID and (not CAN_S7) and OCC_q13_man and OCC_q12 and WD_q12_1 and (not BLK_q12) and WD_q7_2 and (not BLK_q7) and (not BLK_q10_bypass2) and (not D_q12)  # route S7-S10: open for the movement that passes S7
        N_S_R14 = PR_R14  # route S7-S10: proceed
        N_H_R14 = (H_R14 or PR_R14) and KP_R14  # route S7-S10: signal has been open
        N_A_R15 = (A_R15 or G_R15) and KP_R15  # route S8-S9 active
        N_B_R15 = (B_R15 or LK_R15) and KP_R15  # route S8-S9 locked
        N_W_R15 = (W_R15 or LK_R15 or (((LREQ == 15) or ((LREQ == 0) and (REQ == 15))) and B_R15)) and (not LS_R15) and KP_R15 and (not X_S8) and (not CAN_S8)  # route S8-S9: proceed wanted
        N_S_R15 = PR_R15  # route S8-S9: proceed
        N_H_R15 = (H_R15 or PR_R15) and KP_R15  # route S8-S9: signal has been open
        N_A_R16 = (A_R16 or G_R16) and KP_R16  # route S9-S10 active
        N_B_R16 = (B_R16 or LK_R16) and KP_R16  # route S9-S10 locked
        N_W_R16 = (W_R16 or LK_R16 or (((LREQ == 16) or ((LREQ == 0) and (REQ == 16))) and B_R16)) and (not LS_R16) and KP_R16 and (not X_S9) and (not CAN_S9)  # route S9-S10: proceed wanted
        N_PA_R16 = (PA_R16 or (S_R16 and NU_q12_3)) and VALID and (not CAN_S9) and OCC_q8_dep and OCC_q12 and WD_q12_4 and (not BLK_q12) and WD_q7_2 and (not BLK_q7) and (not BLK_q10_bypass2) and (not D_q12)  # route S9-S10: open for the movement that passes S9
        N_S_R16 = PR_R16  # route S9-S10: proceed
        N_H_R16 = (H_R16 or PR_R16) and KP_R16  # route S9-S10: signal has been open
        N_X_S0 = (X_S0 or CAN_S0) and A_R1 and (not CD_S0)  # S0: cancelling
        N_X_S1 = (X_S1 or CAN_S1) and (A_R2 or A_R3) and (not CD_S1)  # S1: cancelling
        N_X_S10 = (X_S10 or CAN_S10) and A_R4 and (not CD_S10)  # S10: cancelling
        N_X_S11 = (X_S11 or CAN_S11) and A_R5 and (not CD_S11)  # S11: cancelling
        N_X_S2 = (X_S2 or CAN_S2) and A_R6 and (not CD_S2)  # S2: cancelling
        N_X_S3 = (X_S3 or CAN_S3) and (A_R7 or A_R8) and (not CD_S3)  # S3: cancelling
        N_X_S4 = (X_S4 or CAN_S4) and (A_R9 or A_R10) and (not CD_S4)  # S4: cancelling
        N_X_S5 = (X_S5 or CAN_S5) and (A_R11 or A_R12) and (not CD_S5)  # S5: cancelling
        N_X_S6 = (X_S6 or CAN_S6) and A_R13 and (not CD_S6)  # S6: cancelling
        N_X_S7 = (X_S7 or CAN_S7) and A_R14 and (not CD_S7)  # S7: cancelling
        N_X_S8 = (X_S8 or CAN_S8) and A_R15 and (not CD_S8)  # S8: cancelling
        N_X_S9 = (X_S9 or CAN_S9) and A_R16 and (not CD_S9)  # S9: cancelling
        N_K_q1 = K_q1 and (not RLS_q1)  # q1: restart lock (R16)
        N_L_q1_1 = (L_q1_1 or GW_q1_1) and (not RLS_q1)  # q1 locked from W to q1|q2@P1.toe
        N_L_q1_2 = (L_q1_2 or GW_q1_2) and (not RLS_q1)  # q1 locked from q1|q2@P1.toe to W
        N_F_q1 = (F_q1 or LK_R1 or LK_R5) and (not RLS_q1)  # q1 firmly locked
        N_U_q1 = (U_q1 or NU_q1_1 or NU_q1_2) and (not RLS_q1)  # q1 used by a train (R9)
        N_P_q1 = (P_q1 or (U_q1 and OCC_q1 and NU_q2_1)) and (not RLS_q1)  # q1: the train went on (R9)
        N_D_q1 = (D_q1 or ((not VALID) and (L_q1_1 or L_q1_2))) and (not RLS_q1)  # q1: detection is not relied on, inputs were lost or a train is called on
        N_K_q10_bypass2 = K_q10_bypass2 and (not RLS_q10_bypass2)  # q10_bypass2: restart lock (R16)
        N_L_q10_bypass2_1 = (L_q10_bypass2_1 or GW_q10_bypass2_1) and (not RLS_q10_bypass2)  # q10_bypass2 locked from q10_bypass2|q7@P2.reverse to q10_bypass2|q9@P3.normal
        N_L_q10_bypass2_2 = (L_q10_bypass2_2 or GW_q10_bypass2_2) and (not RLS_q10_bypass2)  # q10_bypass2 locked from q10_bypass2|q9@P3.normal to q10_bypass2|q7@P2.reverse
        N_F_q10_bypass2 = (F_q10_bypass2 or LK_R14 or LK_R16 or LK_R10) and (not RLS_q10_bypass2)  # q10_bypass2 firmly locked
        N_U_q10_bypass2 = (U_q10_bypass2 or NU_q10_bypass2_1 or NU_q10_bypass2_2) and (not RLS_q10_bypass2)  # q10_bypass2 used by a train (R9)
        N_P_q10_bypass2 = (P_q10_bypass2 or (U_q10_bypass2 and OCC_q10_bypass2 and (NU_q7_1 or NU_q9_1))) and (not RLS_q10_bypass2)  # q10_bypass2: the train went on (R9)
        N_D_q10_bypass2 = (D_q10_bypass2 or ((not VALID) and (L_q10_bypass2_1 or L_q10_bypass2_2))) and (not RLS_q10_bypass2)  # q10_bypass2: detection is not relied on, inputs were lost or a train is called on
        N_K_q11_material = K_q11_material and (not RLS_q11_material)  # q11_material: restart lock (R16)
        N_L_q11_material_2 = (L_q11_material_2 or GW_q11_material_2) and (not RLS_q11_material)  # q11_material locked from q11_material|q9@P3.reverse to MAT
        N_F_q11_material = (F_q11_material or LK_R9) and (not RLS_q11_material)  # q11_material firmly locked
        N_U_q11_material = (U_q11_material or NU_q11_material_2) and (not RLS_q11_material)  # q11_material used by a train (R9)
        N_P_q11_material = (P_q11_material or (U_q11_material and OCC_q11_material and NU_q9_2)) and (not RLS_q11_material)  # q11_material: the train went on (R9)
        N_D_q11_material = (D_q11_material or ((not VALID) and L_q11_material_2)) and (not RLS_q11_material)  # q11_material: detection is not relied on, inputs were lost or a train is called on
        N_K_q12 = K_q12 and (not RLS_q12)  # q12: restart lock (R16)
        N_L_q12_1 = (L_q12_1 or GW_q12_1) and (not RLS_q12)  # q12 locked from q12|q13_man@P4.reverse to q12|q7@P2.toe
        N_L_q12_2 = (L_q12_2 or GW_q12_2) and (not RLS_q12)  # q12 locked from q12|q7@P2.toe to q12|q13_man@P4.reverse
        N_L_q12_3 = (L_q12_3 or GW_q12_3) and (not RLS_q12)  # q12 locked from q12|q7@P2.toe to q12|q8_dep@P4.normal
        N_L_q12_4 = (L_q12_4 or GW_q12_4) and (not RLS_q12)  # q12 locked from q12|q8_dep@P4.normal to q12|q7@P2.toe
        N_F_q12 = (F_q12 or LK_R14 or LK_R8 or LK_R12 or LK_R7 or LK_R11 or LK_R16) and (not RLS_q12)  # q12 firmly locked
        N_U_q12 = (U_q12 or NU_q12_1 or NU_q12_2 or NU_q12_3) and (not RLS_q12)  # q12 used by a train (R9)
        N_P_q12 = (P_q12 or (U_q12 and OCC_q12 and (NU_q13_man_2 or NU_q7_2 or NU_q8_dep_2))) and (not RLS_q12)  # q12: the train went on (R9)
        N_D_q12 = (D_q12 or ((not VALID) and (L_q12_1 or L_q12_2 or L_q12_3 or L_q12_4))) and (not RLS_q12)  # q12: detection is not relied on, inputs were lost or a train is called on
        N_K_q13_man = K_q13_man and (not RLS_q13_man)  # q13_man: restart lock (R16)
        N_L_q13_man_2 = (L_q13_man_2 or GW_q13_man_2) and (not RLS_q13_man)  # q13_man locked from q12|q13_man@P4.reverse to MAN
        N_F_q13_man = (F_q13_man or LK_R8 or LK_R12) and (not RLS_q13_man)  # q13_man firmly locked
        N_U_q13_man = (U_q13_man or NU_q13_man_2) and (not RLS_q13_man)  # q13_man used by a train (R9)
        N_P_q13_man = (P_q13_man or (U_q13_man and OCC_q13_man and NU_q12_1)) and (not RLS_q13_man)  # q13_man: the train went on (R9)
        N_D_q13_man = (D_q13_man or ((not VALID) and L_q13_man_2)) and (not RLS_q13_man)  # q13_man: detection is not relied on, inputs were lost or a train is called on
        N_K_q2 = K_q2 and (not RLS_q2)  # q2: restart lock (R16)
        N_L_q2_1 = (L_q2_1 or GW_q2_1) and (not RLS_q2)  # q2 locked from q1|q2@P1.toe to q2|q3_heavy@P1.normal
        N_L_q2_2 = (L_q2_2 or GW_q2_2) and (not RLS_q2)  # q2 locked from q1|q2@P1.toe to q2|q5_bypass1@P1.reverse
        N_L_q2_4 = (L_q2_4 or GW_q2_4) and (not RLS_q2)  # q2 locked from q2|q5_bypass1@P1.reverse to q1|q2@P1.toe
        N_F_q2 = (F_q2 or LK_R2 or LK_R3 or LK_R5) and (not RLS_q2)  # q2 firmly locked
        N_U_q2 = (U_q2 or NU_q2_1 or NU_q2_3) and (not RLS_q2)  # q2 used by a train (R9)
        N_P_q2 = (P_q2 or (U_q2 and OCC_q2 and (NU_q1_2 or NU_q3_heavy_1 or NU_q5_bypass1_1))) and (not RLS_q2)  # q2: the train went on (R9)
        N_D_q2 = (D_q2 or ((not VALID) and (L_q2_1 or L_q2_2 or L_q2_4))) and (not RLS_q2)  # q2: detection is not relied on, inputs were lost or a train is called on
        N_K_q3_heavy = K_q3_heavy and (not RLS_q3_heavy)  # q3_heavy: restart lock (R16)
        N_L_q3_heavy_1 = (L_q3_heavy_1 or GW_q3_heavy_1) and (not RLS_q3_heavy)  # q3_heavy locked from q2|q3_heavy@P1.normal to q3_heavy|q4_tippler@heavy.0
        N_F_q3_heavy = (F_q3_heavy or LK_R2) and (not RLS_q3_heavy)  # q3_heavy firmly locked
        N_U_q3_heavy = (U_q3_heavy or NU_q3_heavy_1) and (not RLS_q3_heavy)  # q3_heavy used by a train (R9)
        N_P_q3_heavy = (P_q3_heavy or (U_q3_heavy and OCC_q3_heavy and NU_q4_tippler_1)) and (not RLS_q3_heavy)  # q3_heavy: the train went on (R9)
        N_D_q3_heavy = (D_q3_heavy or ((not VALID) and L_q3_heavy_1)) and (not RLS_q3_heavy)  # q3_heavy: detection is not relied on, inputs were lost or a train is called on
        N_K_q4_tippler = K_q4_tippler and (not RLS_q4_tippler)  # q4_tippler: restart lock (R16)
        N_L_q4_tippler_1 = (L_q4_tippler_1 or GW_q4_tippler_1) and (not RLS_q4_tippler)  # q4_tippler locked from q3_heavy|q4_tippler@heavy.0 to q4_tippler|q6_empty@heavy.1
        N_F_q4_tippler = (F_q4_tippler or LK_R6) and (not RLS_q4_tippler)  # q4_tippler firmly locked
        N_U_q4_tippler = (U_q4_tippler or NU_q4_tippler_1) and (not RLS_q4_tippler)  # q4_tippler used by a train (R9)
        N_P_q4_tippler = (P_q4_tippler or (U_q4_tippler and OCC_q4_tippler and NU_q6_empty_1)) and (not RLS_q4_tippler)  # q4_tippler: the train went on (R9)
        N_D_q4_tippler = (D_q4_tippler or ((not VALID) and L_q4_tippler_1)) and (not RLS_q4_tippler)  # q4_tippler: detection is not relied on, inputs were lost or a train is called on
        N_K_q5_bypass1 = K_q5_bypass1 and (not RLS_q5_bypass1)  # q5_bypass1: restart lock (R16)
        N_L_q5_bypass1_1 = (L_q5_bypass1_1 or GW_q5_bypass1_1) and (not RLS_q5_bypass1)  # q5_bypass1 locked from q2|q5_bypass1@P1.reverse to q5_bypass1|q9@P3.toe
        N_L_q5_bypass1_2 = (L_q5_bypass1_2 or GW_q5_bypass1_2) and (not RLS_q5_bypass1)  # q5_bypass1 locked from q5_bypass1|q9@P3.toe to q2|q5_bypass1@P1.reverse
        N_F_q5_bypass1 = (F_q5_bypass1 or LK_R3 or LK_R4 or LK_R13) and (not RLS_q5_bypass1)  # q5_bypass1 firmly locked
        N_U_q5_bypass1 = (U_q5_bypass1 or NU_q5_bypass1_1 or NU_q5_bypass1_2) and (not RLS_q5_bypass1)  # q5_bypass1 used by a train (R9)
        N_P_q5_bypass1 = (P_q5_bypass1 or (U_q5_bypass1 and OCC_q5_bypass1 and (NU_q2_3 or NU_q9_3))) and (not RLS_q5_bypass1)  # q5_bypass1: the train went on (R9)
        N_D_q5_bypass1 = (D_q5_bypass1 or ((not VALID) and (L_q5_bypass1_1 or L_q5_bypass1_2))) and (not RLS_q5_bypass1)  # q5_bypass1: detection is not relied on, inputs were lost or a train is called on
        N_K_q6_empty = K_q6_empty and (not RLS_q6_empty)  # q6_empty: restart lock (R16)
        N_L_q6_empty_1 = (L_q6_empty_1 or GW_q6_empty_1) and (not RLS_q6_empty)  # q6_empty locked from q4_tippler|q6_empty@heavy.1 to q6_empty|q7@P2.normal
        N_F_q6_empty = (F_q6_empty or LK_R6) and (not RLS_q6_empty)  # q6_empty firmly locked
        N_U_q6_empty = (U_q6_empty or NU_q6_empty_1) and (not RLS_q6_empty)  # q6_empty used by a train (R9)
        N_P_q6_empty = (P_q6_empty or (U_q6_empty and OCC_q6_empty and NU_q7_3)) and (not RLS_q6_empty)  # q6_empty: the train went on (R9)
        N_D_q6_empty = (D_q6_empty or ((not VALID) and L_q6_empty_1)) and (not RLS_q6_empty)  # q6_empty: detection is not relied on, inputs were lost or a train is called on
        N_K_q7 = K_q7 and (not RLS_q7)  # q7: restart lock (R16)
        N_L_q7_1 = (L_q7_1 or GW_q7_1) and (not RLS_q7)  # q7 locked from q10_bypass2|q7@P2.reverse to q12|q7@P2.toe
        N_L_q7_2 = (L_q7_2 or GW_q7_2) and (not RLS_q7)  # q7 locked from q12|q7@P2.toe to q10_bypass2|q7@P2.reverse
        N_L_q7_4 = (L_q7_4 or GW_q7_4) and (not RLS_q7)  # q7 locked from q6_empty|q7@P2.normal to q12|q7@P2.toe
        N_F_q7 = (F_q7 or LK_R11 or LK_R12 or LK_R14 or LK_R16 or LK_R7 or LK_R8) and (not RLS_q7)  # q7 firmly locked
        N_U_q7 = (U_q7 or NU_q7_1 or NU_q7_2 or NU_q7_3) and (not RLS_q7)  # q7 used by a train (R9)
        N_P_q7 = (P_q7 or (U_q7 and OCC_q7 and (NU_q10_bypass2_1 or NU_q12_2))) and (not RLS_q7)  # q7: the train went on (R9)
        N_D_q7 = (D_q7 or ((not VALID) and (L_q7_1 or L_q7_2 or L_q7_4))) and (not RLS_q7)  # q7: detection is not relied on, inputs were lost or a train is called on
        N_K_q8_dep = K_q8_dep and (not RLS_q8_dep)  # q8_dep: restart lock (R16)
        N_L_q8_dep_1 = (L_q8_dep_1 or GW_q8_dep_1) and (not RLS_q8_dep)  # q8_dep locked from E to q12|q8_dep@P4.normal
        N_L_q8_dep_2 = (L_q8_dep_2 or GW_q8_dep_2) and (not RLS_q8_dep)  # q8_dep locked from q12|q8_dep@P4.normal to E
        N_F_q8_dep = (F_q8_dep or LK_R15 or LK_R7 or LK_R11) and (not RLS_q8_dep)  # q8_dep firmly locked
        N_U_q8_dep = (U_q8_dep or NU_q8_dep_1 or NU_q8_dep_2) and (not RLS_q8_dep)  # q8_dep used by a train (R9)
        N_P_q8_dep = (P_q8_dep or (U_q8_dep and OCC_q8_dep and NU_q12_3)) and (not RLS_q8_dep)  # q8_dep: the train went on (R9)
        N_D_q8_dep = (D_q8_dep or ((not VALID) and (L_q8_dep_1 or L_q8_dep_2))) and (not RLS_q8_dep)  # q8_dep: detection is not relied on, inputs were lost or a train is called on
        N_K_q9 = K_q9 and (not RLS_q9)  # q9: restart lock (R16)
        N_L_q9_1 = (L_q9_1 or GW_q9_1) and (not RLS_q9)  # q9 locked from q10_bypass2|q9@P3.normal to q5_bypass1|q9@P3.toe
        N_L_q9_2 = (L_q9_2 or GW_q9_2) and (not RLS_q9)  # q9 locked from q11_material|q9@P3.reverse to q5_bypass1|q9@P3.toe
        N_L_q9_3 = (L_q9_3 or GW_q9_3) and (not RLS_q9)  # q9 locked from q5_bypass1|q9@P3.toe to q10_bypass2|q9@P3.normal
        N_L_q9_4 = (L_q9_4 or GW_q9_4) and (not RLS_q9)  # q9 locked from q5_bypass1|q9@P3.toe to q11_material|q9@P3.reverse
        N_F_q9 = (F_q9 or LK_R4 or LK_R13 or LK_R10 or LK_R9) and (not RLS_q9)  # q9 firmly locked
        N_U_q9 = (U_q9 or NU_q9_1 or NU_q9_2 or NU_q9_3) and (not RLS_q9)  # q9 used by a train (R9)
        N_P_q9 = (P_q9 or (U_q9 and OCC_q9 and (NU_q10_bypass2_2 or NU_q11_material_2 or NU_q5_bypass1_2))) and (not RLS_q9)  # q9: the train went on (R9)
        N_D_q9 = (D_q9 or ((not VALID) and (L_q9_1 or L_q9_2 or L_q9_3 or L_q9_4))) and (not RLS_q9)  # q9: detection is not relied on, inputs were lost or a train is called on
        N_FA_ap_E = (not SH_ap_E)  # alarm: detector of ap_E faulty
        N_FA_ap_W = (not SH_ap_W)  # alarm: detector of ap_W faulty
        N_FA_q1 = (not SH_q1)  # alarm: detector of q1 faulty
        N_FA_q10_bypass2 = (not SH_q10_bypass2)  # alarm: detector of q10_bypass2 faulty
        N_FA_q11_material = (not SH_q11_material)  # alarm: detector of q11_material faulty
        N_FA_q12 = (not SH_q12)  # alarm: detector of q12 faulty
        N_FA_q13_man = (not SH_q13_man)  # alarm: detector of q13_man faulty
        N_FA_q2 = (not SH_q2)  # alarm: detector of q2 faulty
        N_FA_q3_heavy = (not SH_q3_heavy)  # alarm: detector of q3_heavy faulty
        N_FA_q4_tippler = (not SH_q4_tippler)  # alarm: detector of q4_tippler faulty
        N_FA_q5_bypass1 = (not SH_q5_bypass1)  # alarm: detector of q5_bypass1 faulty
        N_FA_q6_empty = (not SH_q6_empty)  # alarm: detector of q6_empty faulty
        N_FA_q7 = (not SH_q7)  # alarm: detector of q7 faulty
        N_FA_q8_dep = (not SH_q8_dep)  # alarm: detector of q8_dep faulty
        N_FA_q9 = (not SH_q9)  # alarm: detector of q9 faulty
        self.state = {
            'CN_P1': bool(N_CN_P1),
            'CR_P1': bool(N_CR_P1),
            'CN_P2': bool(N_CN_P2),
            'CR_P2': bool(N_CR_P2),
            'CN_P3': bool(N_CN_P3),
            'CR_P3': bool(N_CR_P3),
            'CN_P4': bool(N_CN_P4),
            'CR_P4': bool(N_CR_P4),
            'AL_P1': bool(N_AL_P1),
            'AL_P2': bool(N_AL_P2),
            'AL_P3': bool(N_AL_P3),
            'AL_P4': bool(N_AL_P4),
            'TH_P1': bool(N_TH_P1),
            'TR_P1': bool(N_TR_P1),
            'TH_P2': bool(N_TH_P2),
            'TR_P2': bool(N_TR_P2),
            'TH_P3': bool(N_TH_P3),
            'TR_P3': bool(N_TR_P3),
            'TH_P4': bool(N_TH_P4),
            'TR_P4': bool(N_TR_P4),
            'A_R1': bool(N_A_R1),
            'B_R1': bool(N_B_R1),
            'W_R1': bool(N_W_R1),
            'S_R1': bool(N_S_R1),
            'H_R1': bool(N_H_R1),
            'A_R2': bool(N_A_R2),
            'B_R2': bool(N_B_R2),
            'W_R2': bool(N_W_R2),
            'PA_R2': bool(N_PA_R2),
            'S_R2': bool(N_S_R2),
            'H_R2': bool(N_H_R2),
            'A_R3': bool(N_A_R3),
            'B_R3': bool(N_B_R3),
            'W_R3': bool(N_W_R3),
            'PA_R3': bool(N_PA_R3),
            'S_R3': bool(N_S_R3),
            'H_R3': bool(N_H_R3),
            'A_R4': bool(N_A_R4),
            'B_R4': bool(N_B_R4),
            'W_R4': bool(N_W_R4),
            'PA_R4': bool(N_PA_R4),
            'S_R4': bool(N_S_R4),
            'H_R4': bool(N_H_R4),
            'A_R5': bool(N_A_R5),
            'B_R5': bool(N_B_R5),
            'W_R5': bool(N_W_R5),
            'PA_R5': bool(N_PA_R5),
            'S_R5': bool(N_S_R5),
            'H_R5': bool(N_H_R5),
            'A_R6': bool(N_A_R6),
            'B_R6': bool(N_B_R6),
            'W_R6': bool(N_W_R6),
            'PA_R6': bool(N_PA_R6),
            'S_R6': bool(N_S_R6),
            'H_R6': bool(N_H_R6),
            'A_R7': bool(N_A_R7),
            'B_R7': bool(N_B_R7),
            'W_R7': bool(N_W_R7),
            'PA_R7': bool(N_PA_R7),
            'S_R7': bool(N_S_R7),
            'H_R7': bool(N_H_R7),
            'A_R8': bool(N_A_R8),
            'B_R8': bool(N_B_R8),
            'W_R8': bool(N_W_R8),
            'PA_R8': bool(N_PA_R8),
            'S_R8': bool(N_S_R8),
            'H_R8': bool(N_H_R8),
            'A_R9': bool(N_A_R9),
            'B_R9': bool(N_B_R9),
            'W_R9': bool(N_W_R9),
            'PA_R9': bool(N_PA_R9),
            'S_R9': bool(N_S_R9),
            'H_R9': bool(N_H_R9),
            'A_R10': bool(N_A_R10),
            'B_R10': bool(N_B_R10),
            'W_R10': bool(N_W_R10),
            'PA_R10': bool(N_PA_R10),
            'S_R10': bool(N_S_R10),
            'H_R10': bool(N_H_R10),
            'A_R11': bool(N_A_R11),
            'B_R11': bool(N_B_R11),
            'W_R11': bool(N_W_R11),
            'PA_R11': bool(N_PA_R11),
            'S_R11': bool(N_S_R11),
            'H_R11': bool(N_H_R11),
            'A_R12': bool(N_A_R12),
            'B_R12': bool(N_B_R12),
            'W_R12': bool(N_W_R12),
            'PA_R12': bool(N_PA_R12),
            'S_R12': bool(N_S_R12),
            'H_R12': bool(N_H_R12),
            'A_R13': bool(N_A_R13),
            'B_R13': bool(N_B_R13),
            'W_R13': bool(N_W_R13),
            'PA_R13': bool(N_PA_R13),
            'S_R13': bool(N_S_R13),
            'H_R13': bool(N_H_R13),
            'A_R14': bool(N_A_R14),
            'B_R14': bool(N_B_R14),
            'W_R14': bool(N_W_R14),
            'PA_R14': bool(N_PA_R14),
            'S_R14': bool(N_S_R14),
            'H_R14': bool(N_H_R14),
            'A_R15': bool(N_A_R15),
            'B_R15': bool(N_B_R15),
            'W_R15': bool(N_W_R15),
            'S_R15': bool(N_S_R15),
            'H_R15': bool(N_H_R15),
            'A_R16': bool(N_A_R16),
            'B_R16': bool(N_B_R16),
            'W_R16': bool(N_W_R16),
            'PA_R16': bool(N_PA_R16),
            'S_R16': bool(N_S_R16),
            'H_R16': bool(N_H_R16),
            'X_S0': bool(N_X_S0),
            'X_S1': bool(N_X_S1),
            'X_S10': bool(N_X_S10),
            'X_S11': bool(N_X_S11),
            'X_S2': bool(N_X_S2),
            'X_S3': bool(N_X_S3),
            'X_S4': bool(N_X_S4),
            'X_S5': bool(N_X_S5),
            'X_S6': bool(N_X_S6),
            'X_S7': bool(N_X_S7),
            'X_S8': bool(N_X_S8),
            'X_S9': bool(N_X_S9),
            'K_q1': bool(N_K_q1),
            'L_q1_1': bool(N_L_q1_1),
            'L_q1_2': bool(N_L_q1_2),
            'F_q1': bool(N_F_q1),
            'U_q1': bool(N_U_q1),
            'P_q1': bool(N_P_q1),
            'D_q1': bool(N_D_q1),
            'K_q10_bypass2': bool(N_K_q10_bypass2),
            'L_q10_bypass2_1': bool(N_L_q10_bypass2_1),
            'L_q10_bypass2_2': bool(N_L_q10_bypass2_2),
            'F_q10_bypass2': bool(N_F_q10_bypass2),
            'U_q10_bypass2': bool(N_U_q10_bypass2),
            'P_q10_bypass2': bool(N_P_q10_bypass2),
            'D_q10_bypass2': bool(N_D_q10_bypass2),
            'K_q11_material': bool(N_K_q11_material),
            'L_q11_material_2': bool(N_L_q11_material_2),
            'F_q11_material': bool(N_F_q11_material),
            'U_q11_material': bool(N_U_q11_material),
            'P_q11_material': bool(N_P_q11_material),
            'D_q11_material': bool(N_D_q11_material),
            'K_q12': bool(N_K_q12),
            'L_q12_1': bool(N_L_q12_1),
            'L_q12_2': bool(N_L_q12_2),
            'L_q12_3': bool(N_L_q12_3),
            'L_q12_4': bool(N_L_q12_4),
            'F_q12': bool(N_F_q12),
            'U_q12': bool(N_U_q12),
            'P_q12': bool(N_P_q12),
            'D_q12': bool(N_D_q12),
            'K_q13_man': bool(N_K_q13_man),
            'L_q13_man_2': bool(N_L_q13_man_2),
            'F_q13_man': bool(N_F_q13_man),
            'U_q13_man': bool(N_U_q13_man),
            'P_q13_man': bool(N_P_q13_man),
            'D_q13_man': bool(N_D_q13_man),
            'K_q2': bool(N_K_q2),
            'L_q2_1': bool(N_L_q2_1),
            'L_q2_2': bool(N_L_q2_2),
            'L_q2_4': bool(N_L_q2_4),
            'F_q2': bool(N_F_q2),
            'U_q2': bool(N_U_q2),
            'P_q2': bool(N_P_q2),
            'D_q2': bool(N_D_q2),
            'K_q3_heavy': bool(N_K_q3_heavy),
            'L_q3_heavy_1': bool(N_L_q3_heavy_1),
            'F_q3_heavy': bool(N_F_q3_heavy),
            'U_q3_heavy': bool(N_U_q3_heavy),
            'P_q3_heavy': bool(N_P_q3_heavy),
            'D_q3_heavy': bool(N_D_q3_heavy),
            'K_q4_tippler': bool(N_K_q4_tippler),
            'L_q4_tippler_1': bool(N_L_q4_tippler_1),
            'F_q4_tippler': bool(N_F_q4_tippler),
            'U_q4_tippler': bool(N_U_q4_tippler),
            'P_q4_tippler': bool(N_P_q4_tippler),
            'D_q4_tippler': bool(N_D_q4_tippler),
            'K_q5_bypass1': bool(N_K_q5_bypass1),
            'L_q5_bypass1_1': bool(N_L_q5_bypass1_1),
            'L_q5_bypass1_2': bool(N_L_q5_bypass1_2),
            'F_q5_bypass1': bool(N_F_q5_bypass1),
            'U_q5_bypass1': bool(N_U_q5_bypass1),
            'P_q5_bypass1': bool(N_P_q5_bypass1),
            'D_q5_bypass1': bool(N_D_q5_bypass1),
            'K_q6_empty': bool(N_K_q6_empty),
            'L_q6_empty_1': bool(N_L_q6_empty_1),
            'F_q6_empty': bool(N_F_q6_empty),
            'U_q6_empty': bool(N_U_q6_empty),
            'P_q6_empty': bool(N_P_q6_empty),
            'D_q6_empty': bool(N_D_q6_empty),
            'K_q7': bool(N_K_q7),
            'L_q7_1': bool(N_L_q7_1),
            'L_q7_2': bool(N_L_q7_2),
            'L_q7_4': bool(N_L_q7_4),
            'F_q7': bool(N_F_q7),
            'U_q7': bool(N_U_q7),
            'P_q7': bool(N_P_q7),
            'D_q7': bool(N_D_q7),
            'K_q8_dep': bool(N_K_q8_dep),
            'L_q8_dep_1': bool(N_L_q8_dep_1),
            'L_q8_dep_2': bool(N_L_q8_dep_2),
            'F_q8_dep': bool(N_F_q8_dep),
            'U_q8_dep': bool(N_U_q8_dep),
            'P_q8_dep': bool(N_P_q8_dep),
            'D_q8_dep': bool(N_D_q8_dep),
            'K_q9': bool(N_K_q9),
            'L_q9_1': bool(N_L_q9_1),
            'L_q9_2': bool(N_L_q9_2),
            'L_q9_3': bool(N_L_q9_3),
            'L_q9_4': bool(N_L_q9_4),
            'F_q9': bool(N_F_q9),
            'U_q9': bool(N_U_q9),
            'P_q9': bool(N_P_q9),
            'D_q9': bool(N_D_q9),
            'FA_ap_E': bool(N_FA_ap_E),
            'FA_ap_W': bool(N_FA_ap_W),
            'FA_q1': bool(N_FA_q1),
            'FA_q10_bypass2': bool(N_FA_q10_bypass2),
            'FA_q11_material': bool(N_FA_q11_material),
            'FA_q12': bool(N_FA_q12),
            'FA_q13_man': bool(N_FA_q13_man),
            'FA_q2': bool(N_FA_q2),
            'FA_q3_heavy': bool(N_FA_q3_heavy),
            'FA_q4_tippler': bool(N_FA_q4_tippler),
            'FA_q5_bypass1': bool(N_FA_q5_bypass1),
            'FA_q6_empty': bool(N_FA_q6_empty),
            'FA_q7': bool(N_FA_q7),
            'FA_q8_dep': bool(N_FA_q8_dep),
            'FA_q9': bool(N_FA_q9),
        }
        CN_P1 = self.state['CN_P1']
        CR_P1 = self.state['CR_P1']
        CN_P2 = self.state['CN_P2']
        CR_P2 = self.state['CR_P2']
        CN_P3 = self.state['CN_P3']
        CR_P3 = self.state['CR_P3']
        CN_P4 = self.state['CN_P4']
        CR_P4 = self.state['CR_P4']
        AL_P1 = self.state['AL_P1']
        AL_P2 = self.state['AL_P2']
        AL_P3 = self.state['AL_P3']
        AL_P4 = self.state['AL_P4']
        TH_P1 = self.state['TH_P1']
        TR_P1 = self.state['TR_P1']
        TH_P2 = self.state['TH_P2']
        TR_P2 = self.state['TR_P2']
        TH_P3 = self.state['TH_P3']
        TR_P3 = self.state['TR_P3']
        TH_P4 = self.state['TH_P4']
        TR_P4 = self.state['TR_P4']
        A_R1 = self.state['A_R1']
        B_R1 = self.state['B_R1']
        W_R1 = self.state['W_R1']
        S_R1 = self.state['S_R1']
        H_R1 = self.state['H_R1']
        A_R2 = self.state['A_R2']
        B_R2 = self.state['B_R2']
        W_R2 = self.state['W_R2']
        PA_R2 = self.state['PA_R2']
        S_R2 = self.state['S_R2']
        H_R2 = self.state['H_R2']
        A_R3 = self.state['A_R3']
        B_R3 = self.state['B_R3']
        W_R3 = self.state['W_R3']
        PA_R3 = self.state['PA_R3']
        S_R3 = self.state['S_R3']
        H_R3 = self.state['H_R3']
        A_R4 = self.state['A_R4']
        B_R4 = self.state['B_R4']
        W_R4 = self.state['W_R4']
        PA_R4 = self.state['PA_R4']
        S_R4 = self.state['S_R4']
        H_R4 = self.state['H_R4']
        A_R5 = self.state['A_R5']
        B_R5 = self.state['B_R5']
        W_R5 = self.state['W_R5']
        PA_R5 = self.state['PA_R5']
        S_R5 = self.state['S_R5']
        H_R5 = self.state['H_R5']
        A_R6 = self.state['A_R6']
        B_R6 = self.state['B_R6']
        W_R6 = self.state['W_R6']
        PA_R6 = self.state['PA_R6']
        S_R6 = self.state['S_R6']
        H_R6 = self.state['H_R6']
        A_R7 = self.state['A_R7']
        B_R7 = self.state['B_R7']
        W_R7 = self.state['W_R7']
        PA_R7 = self.state['PA_R7']
        S_R7 = self.state['S_R7']
        H_R7 = self.state['H_R7']
        A_R8 = self.state['A_R8']
        B_R8 = self.state['B_R8']
        W_R8 = self.state['W_R8']
        PA_R8 = self.state['PA_R8']
        S_R8 = self.state['S_R8']
        H_R8 = self.state['H_R8']
        A_R9 = self.state['A_R9']
        B_R9 = self.state['B_R9']
        W_R9 = self.state['W_R9']
        PA_R9 = self.state['PA_R9']
        S_R9 = self.state['S_R9']
        H_R9 = self.state['H_R9']
        A_R10 = self.state['A_R10']
        B_R10 = self.state['B_R10']
        W_R10 = self.state['W_R10']
        PA_R10 = self.state['PA_R10']
        S_R10 = self.state['S_R10']
        H_R10 = self.state['H_R10']
        A_R11 = self.state['A_R11']
        B_R11 = self.state['B_R11']
        W_R11 = self.state['W_R11']
        PA_R11 = self.state['PA_R11']
        S_R11 = self.state['S_R11']
        H_R11 = self.state['H_R11']
        A_R12 = self.state['A_R12']
        B_R12 = self.state['B_R12']
        W_R12 = self.state['W_R12']
        PA_R12 = self.state['PA_R12']
        S_R12 = self.state['S_R12']
        H_R12 = self.state['H_R12']
        A_R13 = self.state['A_R13']
        B_R13 = self.state['B_R13']
        W_R13 = self.state['W_R13']
        PA_R13 = self.state['PA_R13']
        S_R13 = self.state['S_R13']
        H_R13 = self.state['H_R13']
        A_R14 = self.state['A_R14']
        B_R14 = self.state['B_R14']
        W_R14 = self.state['W_R14']
        PA_R14 = self.state['PA_R14']
        S_R14 = self.state['S_R14']
        H_R14 = self.state['H_R14']
        A_R15 = self.state['A_R15']
        B_R15 = self.state['B_R15']
        W_R15 = self.state['W_R15']
        S_R15 = self.state['S_R15']
        H_R15 = self.state['H_R15']
        A_R16 = self.state['A_R16']
        B_R16 = self.state['B_R16']
        W_R16 = self.state['W_R16']
        PA_R16 = self.state['PA_R16']
        S_R16 = self.state['S_R16']
        H_R16 = self.state['H_R16']
        X_S0 = self.state['X_S0']
        X_S1 = self.state['X_S1']
        X_S10 = self.state['X_S10']
        X_S11 = self.state['X_S11']
        X_S2 = self.state['X_S2']
        X_S3 = self.state['X_S3']
        X_S4 = self.state['X_S4']
        X_S5 = self.state['X_S5']
        X_S6 = self.state['X_S6']
        X_S7 = self.state['X_S7']
        X_S8 = self.state['X_S8']
        X_S9 = self.state['X_S9']
        K_q1 = self.state['K_q1']
        L_q1_1 = self.state['L_q1_1']
        L_q1_2 = self.state['L_q1_2']
        F_q1 = self.state['F_q1']
        U_q1 = self.state['U_q1']
        P_q1 = self.state['P_q1']
        D_q1 = self.state['D_q1']
        K_q10_bypass2 = self.state['K_q10_bypass2']
        L_q10_bypass2_1 = self.state['L_q10_bypass2_1']
        L_q10_bypass2_2 = self.state['L_q10_bypass2_2']
        F_q10_bypass2 = self.state['F_q10_bypass2']
        U_q10_bypass2 = self.state['U_q10_bypass2']
        P_q10_bypass2 = self.state['P_q10_bypass2']
        D_q10_bypass2 = self.state['D_q10_bypass2']
        K_q11_material = self.state['K_q11_material']
        L_q11_material_2 = self.state['L_q11_material_2']
        F_q11_material = self.state['F_q11_material']
        U_q11_material = self.state['U_q11_material']
        P_q11_material = self.state['P_q11_material']
        D_q11_material = self.state['D_q11_material']
        K_q12 = self.state['K_q12']
        L_q12_1 = self.state['L_q12_1']
        L_q12_2 = self.state['L_q12_2']
        L_q12_3 = self.state['L_q12_3']
        L_q12_4 = self.state['L_q12_4']
        F_q12 = self.state['F_q12']
        U_q12 = self.state['U_q12']
        P_q12 = self.state['P_q12']
        D_q12 = self.state['D_q12']
        K_q13_man = self.state['K_q13_man']
        L_q13_man_2 = self.state['L_q13_man_2']
        F_q13_man = self.state['F_q13_man']
        U_q13_man = self.state['U_q13_man']
        P_q13_man = self.state['P_q13_man']
        D_q13_man = self.state['D_q13_man']
        K_q2 = self.state['K_q2']
        L_q2_1 = self.state['L_q2_1']
        L_q2_2 = self.state['L_q2_2']
        L_q2_4 = self.state['L_q2_4']
        F_q2 = self.state['F_q2']
        U_q2 = self.state['U_q2']
        P_q2 = self.state['P_q2']
        D_q2 = self.state['D_q2']
        K_q3_heavy = self.state['K_q3_heavy']
        L_q3_heavy_1 = self.state['L_q3_heavy_1']
        F_q3_heavy = self.state['F_q3_heavy']
        U_q3_heavy = self.state['U_q3_heavy']
        P_q3_heavy = self.state['P_q3_heavy']
        D_q3_heavy = self.state['D_q3_heavy']
        K_q4_tippler = self.state['K_q4_tippler']
        L_q4_tippler_1 = self.state['L_q4_tippler_1']
        F_q4_tippler = self.state['F_q4_tippler']
        U_q4_tippler = self.state['U_q4_tippler']
        P_q4_tippler = self.state['P_q4_tippler']
        D_q4_tippler = self.state['D_q4_tippler']
        K_q5_bypass1 = self.state['K_q5_bypass1']
        L_q5_bypass1_1 = self.state['L_q5_bypass1_1']
        L_q5_bypass1_2 = self.state['L_q5_bypass1_2']
        F_q5_bypass1 = self.state['F_q5_bypass1']
        U_q5_bypass1 = self.state['U_q5_bypass1']
        P_q5_bypass1 = self.state['P_q5_bypass1']
        D_q5_bypass1 = self.state['D_q5_bypass1']
        K_q6_empty = self.state['K_q6_empty']
        L_q6_empty_1 = self.state['L_q6_empty_1']
        F_q6_empty = self.state['F_q6_empty']
        U_q6_empty = self.state['U_q6_empty']
        P_q6_empty = self.state['P_q6_empty']
        D_q6_empty = self.state['D_q6_empty']
        K_q7 = self.state['K_q7']
        L_q7_1 = self.state['L_q7_1']
        L_q7_2 = self.state['L_q7_2']
        L_q7_4 = self.state['L_q7_4']
        F_q7 = self.state['F_q7']
        U_q7 = self.state['U_q7']
        P_q7 = self.state['P_q7']
        D_q7 = self.state['D_q7']
        K_q8_dep = self.state['K_q8_dep']
        L_q8_dep_1 = self.state['L_q8_dep_1']
        L_q8_dep_2 = self.state['L_q8_dep_2']
        F_q8_dep = self.state['F_q8_dep']
        U_q8_dep = self.state['U_q8_dep']
        P_q8_dep = self.state['P_q8_dep']
        D_q8_dep = self.state['D_q8_dep']
        K_q9 = self.state['K_q9']
        L_q9_1 = self.state['L_q9_1']
        L_q9_2 = self.state['L_q9_2']
        L_q9_3 = self.state['L_q9_3']
        L_q9_4 = self.state['L_q9_4']
        F_q9 = self.state['F_q9']
        U_q9 = self.state['U_q9']
        P_q9 = self.state['P_q9']
        D_q9 = self.state['D_q9']
        FA_ap_E = self.state['FA_ap_E']
        FA_ap_W = self.state['FA_ap_W']
        FA_q1 = self.state['FA_q1']
        FA_q10_bypass2 = self.state['FA_q10_bypass2']
        FA_q11_material = self.state['FA_q11_material']
        FA_q12 = self.state['FA_q12']
        FA_q13_man = self.state['FA_q13_man']
        FA_q2 = self.state['FA_q2']
        FA_q3_heavy = self.state['FA_q3_heavy']
        FA_q4_tippler = self.state['FA_q4_tippler']
        FA_q5_bypass1 = self.state['FA_q5_bypass1']
        FA_q6_empty = self.state['FA_q6_empty']
        FA_q7 = self.state['FA_q7']
        FA_q8_dep = self.state['FA_q8_dep']
        FA_q9 = self.state['FA_q9']
        return {
            'YN_P1': bool(CN_P1),
            'YR_P1': bool(CR_P1),
            'YN_P2': bool(CN_P2),
            'YR_P2': bool(CR_P2),
            'YN_P3': bool(CN_P3),
            'YR_P3': bool(CR_P3),
            'YN_P4': bool(CN_P4),
            'YR_P4': bool(CR_P4),
            'YA_P1': bool(AL_P1),
            'YA_P2': bool(AL_P2),
            'YA_P3': bool(AL_P3),
            'YA_P4': bool(AL_P4),
            'YT_P1': bool(TR_P1),
            'YT_P2': bool(TR_P2),
            'YT_P3': bool(TR_P3),
            'YT_P4': bool(TR_P4),
            'YL_q1': bool(K_q1 or L_q1_1 or L_q1_2),
            'YL_q10_bypass2': bool(K_q10_bypass2 or L_q10_bypass2_1 or L_q10_bypass2_2),
            'YL_q11_material': bool(K_q11_material or L_q11_material_2),
            'YL_q12': bool(K_q12 or L_q12_1 or L_q12_2 or L_q12_3 or L_q12_4),
            'YL_q13_man': bool(K_q13_man or L_q13_man_2),
            'YL_q2': bool(K_q2 or L_q2_1 or L_q2_2 or L_q2_4),
            'YL_q3_heavy': bool(K_q3_heavy or L_q3_heavy_1),
            'YL_q4_tippler': bool(K_q4_tippler or L_q4_tippler_1),
            'YL_q5_bypass1': bool(K_q5_bypass1 or L_q5_bypass1_1 or L_q5_bypass1_2),
            'YL_q6_empty': bool(K_q6_empty or L_q6_empty_1),
            'YL_q7': bool(K_q7 or L_q7_1 or L_q7_2 or L_q7_4),
            'YL_q8_dep': bool(K_q8_dep or L_q8_dep_1 or L_q8_dep_2),
            'YL_q9': bool(K_q9 or L_q9_1 or L_q9_2 or L_q9_3 or L_q9_4),
            'YF_ap_E': bool(FA_ap_E),
            'YF_ap_W': bool(FA_ap_W),
            'YF_q1': bool(FA_q1),
            'YF_q10_bypass2': bool(FA_q10_bypass2),
            'YF_q11_material': bool(FA_q11_material),
            'YF_q12': bool(FA_q12),
            'YF_q13_man': bool(FA_q13_man),
            'YF_q2': bool(FA_q2),
            'YF_q3_heavy': bool(FA_q3_heavy),
            'YF_q4_tippler': bool(FA_q4_tippler),
            'YF_q5_bypass1': bool(FA_q5_bypass1),
            'YF_q6_empty': bool(FA_q6_empty),
            'YF_q7': bool(FA_q7),
            'YF_q8_dep': bool(FA_q8_dep),
            'YF_q9': bool(FA_q9),
            'YP_S0': bool(S_R1),
            'YS_S0': bool((not S_R1)),
            'YP_S1': bool(S_R2 or S_R3 or PA_R2 or PA_R3),
            'YS_S1': bool((not (S_R2 or S_R3 or PA_R2 or PA_R3))),
            'YP_S10': bool(S_R4 or PA_R4),
            'YS_S10': bool((not (S_R4 or PA_R4))),
            'YP_S11': bool(S_R5 or PA_R5),
            'YS_S11': bool((not (S_R5 or PA_R5))),
            'YP_S2': bool(S_R6 or PA_R6),
            'YS_S2': bool((not (S_R6 or PA_R6))),
            'YP_S3': bool(S_R7 or S_R8 or PA_R7 or PA_R8),
            'YS_S3': bool((not (S_R7 or S_R8 or PA_R7 or PA_R8))),
            'YP_S4': bool(S_R9 or S_R10 or PA_R9 or PA_R10),
            'YS_S4': bool((not (S_R9 or S_R10 or PA_R9 or PA_R10))),
            'YP_S5': bool(S_R11 or S_R12 or PA_R11 or PA_R12),
            'YS_S5': bool((not (S_R11 or S_R12 or PA_R11 or PA_R12))),
            'YP_S6': bool(S_R13 or PA_R13),
            'YS_S6': bool((not (S_R13 or PA_R13))),
            'YP_S7': bool(S_R14 or PA_R14),
            'YS_S7': bool((not (S_R14 or PA_R14))),
            'YP_S8': bool(S_R15),
            'YS_S8': bool((not S_R15)),
            'YP_S9': bool(S_R16 or PA_R16),
            'YS_S9': bool((not (S_R16 or PA_R16))),
        }
