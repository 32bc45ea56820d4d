# Interlocking heishan, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout 8d47c81159a97984408d8de8ecbb9327a8f86e3b60375643c689bee0dacd036c
# claims 27375a1958555b329801b8dc07f2d5d3d7b695dd0180501748565f3da5d9d92c
"""Interlocking heishan: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_XB': (0, 2),  # operator: cancel the route from XB
    'CAN_XI7': (0, 2),  # operator: cancel the route from XI7
    'CAN_XI9': (0, 2),  # operator: cancel the route from XI9
    'CAN_XL1': (0, 2),  # operator: cancel the route from XL1
    'CAN_XL2': (0, 2),  # operator: cancel the route from XL2
    'CAN_XL3': (0, 2),  # operator: cancel the route from XL3
    'CAN_XL4': (0, 2),  # operator: cancel the route from XL4
    'CAN_XL5': (0, 2),  # operator: cancel the route from XL5
    'CAN_XO': (0, 2),  # operator: cancel the route from XO
    'CAN_XT3': (0, 2),  # operator: cancel the route from XT3
    'CAN_XT7': (0, 2),  # operator: cancel the route from XT7
    'CAN_XT9': (0, 2),  # operator: cancel the route from XT9
    'REQ': (0, 18),  # operator: set route number, 0 = none
    'LREQ': (0, 18),  # operator on the spot: set route number, 0 = none
    'CLR_s10_xc4': (0, 2),  # section s10_xc4 reported clear
    'CLR_s11_xc5': (0, 2),  # section s11_xc5 reported clear
    'CLR_s1_wait': (0, 2),  # section s1_wait reported clear
    'CLR_s2': (0, 2),  # section s2 reported clear
    'CLR_s2_out': (0, 2),  # section s2_out reported clear
    'CLR_s3': (0, 2),  # section s3 reported clear
    'CLR_s4_xc1': (0, 2),  # section s4_xc1 reported clear
    'CLR_s5_xc2': (0, 2),  # section s5_xc2 reported clear
    'CLR_s6': (0, 2),  # section s6 reported clear
    'CLR_s7': (0, 2),  # section s7 reported clear
    'CLR_s8_xc3': (0, 2),  # section s8_xc3 reported clear
    'CLR_s9': (0, 2),  # section s9 reported clear
    'REL_s10_xc4': (0, 2),  # operator: release section s10_xc4 (hold until released)
    'REL_s11_xc5': (0, 2),  # operator: release section s11_xc5 (hold until released)
    'REL_s2': (0, 2),  # operator: release section s2 (hold until released)
    'REL_s2_out': (0, 2),  # operator: release section s2_out (hold until released)
    'REL_s3': (0, 2),  # operator: release section s3 (hold until released)
    'REL_s4_xc1': (0, 2),  # operator: release section s4_xc1 (hold until released)
    'REL_s5_xc2': (0, 2),  # operator: release section s5_xc2 (hold until released)
    'REL_s6': (0, 2),  # operator: release section s6 (hold until released)
    'REL_s7': (0, 2),  # operator: release section s7 (hold until released)
    'REL_s8_xc3': (0, 2),  # operator: release section s8_xc3 (hold until released)
    'REL_s9': (0, 2),  # operator: release section s9 (hold until released)
    'BLK_s10_xc4': (1, 2),  # operator: section s10_xc4 is blocked
    'BLK_s11_xc5': (1, 2),  # operator: section s11_xc5 is blocked
    'BLK_s2': (1, 2),  # operator: section s2 is blocked
    'BLK_s2_out': (1, 2),  # operator: section s2_out is blocked
    'BLK_s3': (1, 2),  # operator: section s3 is blocked
    'BLK_s4_xc1': (1, 2),  # operator: section s4_xc1 is blocked
    'BLK_s5_xc2': (1, 2),  # operator: section s5_xc2 is blocked
    'BLK_s6': (1, 2),  # operator: section s6 is blocked
    'BLK_s7': (1, 2),  # operator: section s7 is blocked
    'BLK_s8_xc3': (1, 2),  # operator: section s8_xc3 is blocked
    'BLK_s9': (1, 2),  # operator: section s9 is blocked
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
    'DN_PS': (0, 2),  # machine PS detected normal
    'DR_PS': (0, 2),  # machine PS detected reverse
    'MN_PS': (0, 2),  # operator: move machine PS normal
    'MR_PS': (0, 2),  # operator: move machine PS reverse
    'TC_PS': (0, 2),  # operator: machine PS has been looked at after it was trailed
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
    'CN_PS': False,  # machine PS commanded N
    'CR_PS': False,  # machine PS commanded R
    'AL_P1': False,  # alarm: machine P1 not detected
    'AL_P2': False,  # alarm: machine P2 not detected
    'AL_P3': False,  # alarm: machine P3 not detected
    'AL_P4': False,  # alarm: machine P4 not detected
    'AL_PS': False,  # alarm: machine PS not detected
    'TH_P1': False,  # machine P1 was detected where it is commanded
    'TR_P1': False,  # machine P1 was trailed
    'TH_P2': False,  # machine P2 was detected where it is commanded
    'TR_P2': False,  # machine P2 was trailed
    'TH_P3': False,  # machine P3 was detected where it is commanded
    'TR_P3': False,  # machine P3 was trailed
    'TH_P4': False,  # machine P4 was detected where it is commanded
    'TR_P4': False,  # machine P4 was trailed
    'TH_PS': False,  # machine PS was detected where it is commanded
    'TR_PS': False,  # machine PS was trailed
    'A_R1': False,  # route XB-OUT active
    'B_R1': False,  # route XB-OUT locked
    'W_R1': False,  # route XB-OUT: proceed wanted
    'S_R1': False,  # route XB-OUT: proceed
    'H_R1': False,  # route XB-OUT: signal has been open
    'A_R2': False,  # route XB-XC1 active
    'B_R2': False,  # route XB-XC1 locked
    'W_R2': False,  # route XB-XC1: proceed wanted
    'S_R2': False,  # route XB-XC1: proceed
    'H_R2': False,  # route XB-XC1: signal has been open
    'A_R3': False,  # route XB-XC2 active
    'B_R3': False,  # route XB-XC2 locked
    'W_R3': False,  # route XB-XC2: proceed wanted
    'S_R3': False,  # route XB-XC2: proceed
    'H_R3': False,  # route XB-XC2: signal has been open
    'A_R4': False,  # route XB-XI7 active
    'B_R4': False,  # route XB-XI7 locked
    'W_R4': False,  # route XB-XI7: proceed wanted
    'S_R4': False,  # route XB-XI7: proceed
    'H_R4': False,  # route XB-XI7: signal has been open
    'A_R5': False,  # route XI7-XC3 active
    'B_R5': False,  # route XI7-XC3 locked
    'W_R5': False,  # route XI7-XC3: proceed wanted
    'S_R5': False,  # route XI7-XC3: proceed
    'H_R5': False,  # route XI7-XC3: signal has been open
    'A_R6': False,  # route XI7-XI9 active
    'B_R6': False,  # route XI7-XI9 locked
    'W_R6': False,  # route XI7-XI9: proceed wanted
    'S_R6': False,  # route XI7-XI9: proceed
    'H_R6': False,  # route XI7-XI9: signal has been open
    'A_R7': False,  # route XI9-XC4 active
    'B_R7': False,  # route XI9-XC4 locked
    'W_R7': False,  # route XI9-XC4: proceed wanted
    'S_R7': False,  # route XI9-XC4: proceed
    'H_R7': False,  # route XI9-XC4: signal has been open
    'A_R8': False,  # route XI9-XC5 active
    'B_R8': False,  # route XI9-XC5 locked
    'W_R8': False,  # route XI9-XC5: proceed wanted
    'S_R8': False,  # route XI9-XC5: proceed
    'H_R8': False,  # route XI9-XC5: signal has been open
    'A_R9': False,  # route XL1-XT3 active
    'B_R9': False,  # route XL1-XT3 locked
    'W_R9': False,  # route XL1-XT3: proceed wanted
    'S_R9': False,  # route XL1-XT3: proceed
    'H_R9': False,  # route XL1-XT3: signal has been open
    'A_R10': False,  # route XL2-XT3 active
    'B_R10': False,  # route XL2-XT3 locked
    'W_R10': False,  # route XL2-XT3: proceed wanted
    'S_R10': False,  # route XL2-XT3: proceed
    'H_R10': False,  # route XL2-XT3: signal has been open
    'A_R11': False,  # route XL3-XT7 active
    'B_R11': False,  # route XL3-XT7 locked
    'W_R11': False,  # route XL3-XT7: proceed wanted
    'S_R11': False,  # route XL3-XT7: proceed
    'H_R11': False,  # route XL3-XT7: signal has been open
    'A_R12': False,  # route XL4-XT9 active
    'B_R12': False,  # route XL4-XT9 locked
    'W_R12': False,  # route XL4-XT9: proceed wanted
    'S_R12': False,  # route XL4-XT9: proceed
    'H_R12': False,  # route XL4-XT9: signal has been open
    'A_R13': False,  # route XL5-XT9 active
    'B_R13': False,  # route XL5-XT9 locked
    'W_R13': False,  # route XL5-XT9: proceed wanted
    'S_R13': False,  # route XL5-XT9: proceed
    'H_R13': False,  # route XL5-XT9: signal has been open
    'A_R14': False,  # route XO-W active
    'B_R14': False,  # route XO-W locked
    'W_R14': False,  # route XO-W: proceed wanted
    'S_R14': False,  # route XO-W: proceed
    'H_R14': False,  # route XO-W: signal has been open
    'A_R15': False,  # route XT3-W active
    'B_R15': False,  # route XT3-W locked
    'W_R15': False,  # route XT3-W: proceed wanted
    'S_R15': False,  # route XT3-W: proceed
    'H_R15': False,  # route XT3-W: signal has been open
    'A_R16': False,  # route XT7-XT3 active
    'B_R16': False,  # route XT7-XT3 locked
    'W_R16': False,  # route XT7-XT3: proceed wanted
    'S_R16': False,  # route XT7-XT3: proceed
    'H_R16': False,  # route XT7-XT3: signal has been open
    'A_R17': False,  # route XT9-XT7 active
    'B_R17': False,  # route XT9-XT7 locked
    'W_R17': False,  # route XT9-XT7: proceed wanted
    'S_R17': False,  # route XT9-XT7: proceed
    'H_R17': False,  # route XT9-XT7: signal has been open
    'X_XB': False,  # XB: cancelling
    'X_XI7': False,  # XI7: cancelling
    'X_XI9': False,  # XI9: cancelling
    'X_XL1': False,  # XL1: cancelling
    'X_XL2': False,  # XL2: cancelling
    'X_XL3': False,  # XL3: cancelling
    'X_XL4': False,  # XL4: cancelling
    'X_XL5': False,  # XL5: cancelling
    'X_XO': False,  # XO: cancelling
    'X_XT3': False,  # XT3: cancelling
    'X_XT7': False,  # XT7: cancelling
    'X_XT9': False,  # XT9: cancelling
    'K_s10_xc4': True,  # s10_xc4: restart lock (R16)
    'L_s10_xc4_2': False,  # s10_xc4 locked from s10_xc4|s9@P4.normal to XC4
    'F_s10_xc4': False,  # s10_xc4 firmly locked
    'U_s10_xc4': True,  # s10_xc4 used by a train (R9)
    'P_s10_xc4': False,  # s10_xc4: the train went on (R9)
    'D_s10_xc4': False,  # s10_xc4: detection is not relied on, inputs were lost or a train is called on
    'K_s11_xc5': True,  # s11_xc5: restart lock (R16)
    'L_s11_xc5_2': False,  # s11_xc5 locked from s11_xc5|s9@P4.reverse to XC5
    'F_s11_xc5': False,  # s11_xc5 firmly locked
    'U_s11_xc5': True,  # s11_xc5 used by a train (R9)
    'P_s11_xc5': False,  # s11_xc5: the train went on (R9)
    'D_s11_xc5': False,  # s11_xc5: detection is not relied on, inputs were lost or a train is called on
    'K_s2': True,  # s2: restart lock (R16)
    'L_s2_1': False,  # s2 locked from W to s2|s2_out@PS.reverse
    'L_s2_2': False,  # s2 locked from W to s2|s3@PS.normal
    'L_s2_3': False,  # s2 locked from s2|s2_out@PS.reverse to W
    'L_s2_4': False,  # s2 locked from s2|s3@PS.normal to W
    'F_s2': False,  # s2 firmly locked
    'U_s2': True,  # s2 used by a train (R9)
    'P_s2': False,  # s2: the train went on (R9)
    'D_s2': False,  # s2: detection is not relied on, inputs were lost or a train is called on
    'K_s2_out': True,  # s2_out: restart lock (R16)
    'L_s2_out_2': False,  # s2_out locked from s2|s2_out@PS.reverse to OUT
    'F_s2_out': False,  # s2_out firmly locked
    'U_s2_out': True,  # s2_out used by a train (R9)
    'P_s2_out': False,  # s2_out: the train went on (R9)
    'D_s2_out': False,  # s2_out: detection is not relied on, inputs were lost or a train is called on
    'K_s3': True,  # s3: restart lock (R16)
    'L_s3_1': False,  # s3 locked from s2|s3@PS.normal to s3|s4_xc1@P1.reverse
    'L_s3_2': False,  # s3 locked from s2|s3@PS.normal to s3|s6@P1.normal
    'L_s3_3': False,  # s3 locked from s3|s4_xc1@P1.reverse to s2|s3@PS.normal
    'L_s3_4': False,  # s3 locked from s3|s6@P1.normal to s2|s3@PS.normal
    'F_s3': False,  # s3 firmly locked
    'U_s3': True,  # s3 used by a train (R9)
    'P_s3': False,  # s3: the train went on (R9)
    'D_s3': False,  # s3: detection is not relied on, inputs were lost or a train is called on
    'K_s4_xc1': True,  # s4_xc1: restart lock (R16)
    'L_s4_xc1_2': False,  # s4_xc1 locked from s3|s4_xc1@P1.reverse to XC1
    'F_s4_xc1': False,  # s4_xc1 firmly locked
    'U_s4_xc1': True,  # s4_xc1 used by a train (R9)
    'P_s4_xc1': False,  # s4_xc1: the train went on (R9)
    'D_s4_xc1': False,  # s4_xc1: detection is not relied on, inputs were lost or a train is called on
    'K_s5_xc2': True,  # s5_xc2: restart lock (R16)
    'L_s5_xc2_2': False,  # s5_xc2 locked from s5_xc2|s6@P2.reverse to XC2
    'F_s5_xc2': False,  # s5_xc2 firmly locked
    'U_s5_xc2': True,  # s5_xc2 used by a train (R9)
    'P_s5_xc2': False,  # s5_xc2: the train went on (R9)
    'D_s5_xc2': False,  # s5_xc2: detection is not relied on, inputs were lost or a train is called on
    'K_s6': True,  # s6: restart lock (R16)
    'L_s6_1': False,  # s6 locked from s3|s6@P1.normal to s5_xc2|s6@P2.reverse
    'L_s6_2': False,  # s6 locked from s3|s6@P1.normal to s6|s7@P2.normal
    'L_s6_3': False,  # s6 locked from s5_xc2|s6@P2.reverse to s3|s6@P1.normal
    'L_s6_4': False,  # s6 locked from s6|s7@P2.normal to s3|s6@P1.normal
    'F_s6': False,  # s6 firmly locked
    'U_s6': True,  # s6 used by a train (R9)
    'P_s6': False,  # s6: the train went on (R9)
    'D_s6': False,  # s6: detection is not relied on, inputs were lost or a train is called on
    'K_s7': True,  # s7: restart lock (R16)
    'L_s7_1': False,  # s7 locked from s6|s7@P2.normal to s7|s8_xc3@P3.reverse
    'L_s7_2': False,  # s7 locked from s6|s7@P2.normal to s7|s9@P3.normal
    'L_s7_3': False,  # s7 locked from s7|s8_xc3@P3.reverse to s6|s7@P2.normal
    'L_s7_4': False,  # s7 locked from s7|s9@P3.normal to s6|s7@P2.normal
    'F_s7': False,  # s7 firmly locked
    'U_s7': True,  # s7 used by a train (R9)
    'P_s7': False,  # s7: the train went on (R9)
    'D_s7': False,  # s7: detection is not relied on, inputs were lost or a train is called on
    'K_s8_xc3': True,  # s8_xc3: restart lock (R16)
    'L_s8_xc3_2': False,  # s8_xc3 locked from s7|s8_xc3@P3.reverse to XC3
    'F_s8_xc3': False,  # s8_xc3 firmly locked
    'U_s8_xc3': True,  # s8_xc3 used by a train (R9)
    'P_s8_xc3': False,  # s8_xc3: the train went on (R9)
    'D_s8_xc3': False,  # s8_xc3: detection is not relied on, inputs were lost or a train is called on
    'K_s9': True,  # s9: restart lock (R16)
    'L_s9_1': False,  # s9 locked from s10_xc4|s9@P4.normal to s7|s9@P3.normal
    'L_s9_2': False,  # s9 locked from s11_xc5|s9@P4.reverse to s7|s9@P3.normal
    'L_s9_3': False,  # s9 locked from s7|s9@P3.normal to s10_xc4|s9@P4.normal
    'L_s9_4': False,  # s9 locked from s7|s9@P3.normal to s11_xc5|s9@P4.reverse
    'F_s9': False,  # s9 firmly locked
    'U_s9': True,  # s9 used by a train (R9)
    'P_s9': False,  # s9: the train went on (R9)
    'D_s9': False,  # s9: detection is not relied on, inputs were lost or a train is called on
    'ZF_INSIDE': True,  # zone INSIDE is full
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_XB': 60000,  # XB: approach locking delay (R8)
    'AT_XI7': 60000,  # XI7: approach locking delay (R8)
    'AT_XI9': 60000,  # XI9: approach locking delay (R8)
    'AT_XL1': 60000,  # XL1: approach locking delay (R8)
    'AT_XL2': 60000,  # XL2: approach locking delay (R8)
    'AT_XL3': 60000,  # XL3: approach locking delay (R8)
    'AT_XL4': 60000,  # XL4: approach locking delay (R8)
    'AT_XL5': 60000,  # XL5: approach locking delay (R8)
    'AT_XO': 60000,  # XO: approach locking delay (R8)
    'AT_XT3': 60000,  # XT3: approach locking delay (R8)
    'AT_XT7': 60000,  # XT7: approach locking delay (R8)
    'AT_XT9': 60000,  # XT9: approach locking delay (R8)
    'RT_s10_xc4': 3000,  # s10_xc4: release delay (R9)
    'RT_s11_xc5': 3000,  # s11_xc5: release delay (R9)
    'RT_s2': 3000,  # s2: release delay (R9)
    'RT_s2_out': 3000,  # s2_out: release delay (R9)
    'RT_s3': 3000,  # s3: release delay (R9)
    'RT_s4_xc1': 3000,  # s4_xc1: release delay (R9)
    'RT_s5_xc2': 3000,  # s5_xc2: release delay (R9)
    'RT_s6': 3000,  # s6: release delay (R9)
    'RT_s7': 3000,  # s7: release delay (R9)
    'RT_s8_xc3': 3000,  # s8_xc3: release delay (R9)
    'RT_s9': 3000,  # s9: release delay (R9)
    'ST_P1': 13000,  # machine P1: time-out
    'ST_P2': 13000,  # machine P2: time-out
    'ST_P3': 13000,  # machine P3: time-out
    'ST_P4': 13000,  # machine P4: time-out
    'ST_PS': 13000,  # machine PS: time-out
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
    'YN_PS': False,  # machine PS: normal
    'YR_PS': False,  # machine PS: reverse
    'YA_P1': False,  # alarm: machine P1 not detected in time
    'YA_P2': False,  # alarm: machine P2 not detected in time
    'YA_P3': False,  # alarm: machine P3 not detected in time
    'YA_P4': False,  # alarm: machine P4 not detected in time
    'YA_PS': False,  # alarm: machine PS not detected in time
    'YT_P1': False,  # alarm: machine P1 was trailed
    'YT_P2': False,  # alarm: machine P2 was trailed
    'YT_P3': False,  # alarm: machine P3 was trailed
    'YT_P4': False,  # alarm: machine P4 was trailed
    'YT_PS': False,  # alarm: machine PS was trailed
    'YL_s10_xc4': True,  # indication: s10_xc4 is locked
    'YL_s11_xc5': True,  # indication: s11_xc5 is locked
    'YL_s2': True,  # indication: s2 is locked
    'YL_s2_out': True,  # indication: s2_out is locked
    'YL_s3': True,  # indication: s3 is locked
    'YL_s4_xc1': True,  # indication: s4_xc1 is locked
    'YL_s5_xc2': True,  # indication: s5_xc2 is locked
    'YL_s6': True,  # indication: s6 is locked
    'YL_s7': True,  # indication: s7 is locked
    'YL_s8_xc3': True,  # indication: s8_xc3 is locked
    'YL_s9': True,  # indication: s9 is locked
    'YP_XB': False,  # signal XB: clear (green)
    'YS_XB': True,  # signal XB: stop
    'YP_XI7': False,  # signal XI7: clear (green)
    'YS_XI7': True,  # signal XI7: stop
    'YP_XI9': False,  # signal XI9: clear (green)
    'YS_XI9': True,  # signal XI9: stop
    'YP_XL1': False,  # signal XL1: clear (green)
    'YS_XL1': True,  # signal XL1: stop
    'YP_XL2': False,  # signal XL2: clear (green)
    'YS_XL2': True,  # signal XL2: stop
    'YP_XL3': False,  # signal XL3: clear (green)
    'YS_XL3': True,  # signal XL3: stop
    'YP_XL4': False,  # signal XL4: clear (green)
    'YS_XL4': True,  # signal XL4: stop
    'YP_XL5': False,  # signal XL5: clear (green)
    'YS_XL5': True,  # signal XL5: stop
    'YP_XO': False,  # signal XO: clear (green)
    'YS_XO': True,  # signal XO: stop
    'YP_XT3': False,  # signal XT3: clear (green)
    'YS_XT3': True,  # signal XT3: stop
    'YP_XT7': False,  # signal XT7: clear (green)
    'YS_XT7': True,  # signal XT7: stop
    'YP_XT9': False,  # signal XT9: clear (green)
    'YS_XT9': True,  # signal XT9: stop
    'YZ_INSIDE': True,  # indication: zone INSIDE is full
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
        CAN_XB = read['CAN_XB']
        CAN_XI7 = read['CAN_XI7']
        CAN_XI9 = read['CAN_XI9']
        CAN_XL1 = read['CAN_XL1']
        CAN_XL2 = read['CAN_XL2']
        CAN_XL3 = read['CAN_XL3']
        CAN_XL4 = read['CAN_XL4']
        CAN_XL5 = read['CAN_XL5']
        CAN_XO = read['CAN_XO']
        CAN_XT3 = read['CAN_XT3']
        CAN_XT7 = read['CAN_XT7']
        CAN_XT9 = read['CAN_XT9']
        REQ = read['REQ']
        LREQ = read['LREQ']
        CLR_s10_xc4 = read['CLR_s10_xc4']
        CLR_s11_xc5 = read['CLR_s11_xc5']
        CLR_s1_wait = read['CLR_s1_wait']
        CLR_s2 = read['CLR_s2']
        CLR_s2_out = read['CLR_s2_out']
        CLR_s3 = read['CLR_s3']
        CLR_s4_xc1 = read['CLR_s4_xc1']
        CLR_s5_xc2 = read['CLR_s5_xc2']
        CLR_s6 = read['CLR_s6']
        CLR_s7 = read['CLR_s7']
        CLR_s8_xc3 = read['CLR_s8_xc3']
        CLR_s9 = read['CLR_s9']
        REL_s10_xc4 = read['REL_s10_xc4']
        REL_s11_xc5 = read['REL_s11_xc5']
        REL_s2 = read['REL_s2']
        REL_s2_out = read['REL_s2_out']
        REL_s3 = read['REL_s3']
        REL_s4_xc1 = read['REL_s4_xc1']
        REL_s5_xc2 = read['REL_s5_xc2']
        REL_s6 = read['REL_s6']
        REL_s7 = read['REL_s7']
        REL_s8_xc3 = read['REL_s8_xc3']
        REL_s9 = read['REL_s9']
        BLK_s10_xc4 = read['BLK_s10_xc4']
        BLK_s11_xc5 = read['BLK_s11_xc5']
        BLK_s2 = read['BLK_s2']
        BLK_s2_out = read['BLK_s2_out']
        BLK_s3 = read['BLK_s3']
        BLK_s4_xc1 = read['BLK_s4_xc1']
        BLK_s5_xc2 = read['BLK_s5_xc2']
        BLK_s6 = read['BLK_s6']
        BLK_s7 = read['BLK_s7']
        BLK_s8_xc3 = read['BLK_s8_xc3']
        BLK_s9 = read['BLK_s9']
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
        DN_PS = read['DN_PS']
        DR_PS = read['DR_PS']
        MN_PS = read['MN_PS']
        MR_PS = read['MR_PS']
        TC_PS = read['TC_PS']
        CN_P1 = old['CN_P1']
        CR_P1 = old['CR_P1']
        CN_P2 = old['CN_P2']
        CR_P2 = old['CR_P2']
        CN_P3 = old['CN_P3']
        CR_P3 = old['CR_P3']
        CN_P4 = old['CN_P4']
        CR_P4 = old['CR_P4']
        CN_PS = old['CN_PS']
        CR_PS = old['CR_PS']
        AL_P1 = old['AL_P1']
        AL_P2 = old['AL_P2']
        AL_P3 = old['AL_P3']
        AL_P4 = old['AL_P4']
        AL_PS = old['AL_PS']
        TH_P1 = old['TH_P1']
        TR_P1 = old['TR_P1']
        TH_P2 = old['TH_P2']
        TR_P2 = old['TR_P2']
        TH_P3 = old['TH_P3']
        TR_P3 = old['TR_P3']
        TH_P4 = old['TH_P4']
        TR_P4 = old['TR_P4']
        TH_PS = old['TH_PS']
        TR_PS = old['TR_PS']
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
        A_R13 = old['A_R13']
        B_R13 = old['B_R13']
        W_R13 = old['W_R13']
        S_R13 = old['S_R13']
        H_R13 = old['H_R13']
        A_R14 = old['A_R14']
        B_R14 = old['B_R14']
        W_R14 = old['W_R14']
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
        S_R16 = old['S_R16']
        H_R16 = old['H_R16']
        A_R17 = old['A_R17']
        B_R17 = old['B_R17']
        W_R17 = old['W_R17']
        S_R17 = old['S_R17']
        H_R17 = old['H_R17']
        X_XB = old['X_XB']
        X_XI7 = old['X_XI7']
        X_XI9 = old['X_XI9']
        X_XL1 = old['X_XL1']
        X_XL2 = old['X_XL2']
        X_XL3 = old['X_XL3']
        X_XL4 = old['X_XL4']
        X_XL5 = old['X_XL5']
        X_XO = old['X_XO']
        X_XT3 = old['X_XT3']
        X_XT7 = old['X_XT7']
        X_XT9 = old['X_XT9']
        K_s10_xc4 = old['K_s10_xc4']
        L_s10_xc4_2 = old['L_s10_xc4_2']
        F_s10_xc4 = old['F_s10_xc4']
        U_s10_xc4 = old['U_s10_xc4']
        P_s10_xc4 = old['P_s10_xc4']
        D_s10_xc4 = old['D_s10_xc4']
        K_s11_xc5 = old['K_s11_xc5']
        L_s11_xc5_2 = old['L_s11_xc5_2']
        F_s11_xc5 = old['F_s11_xc5']
        U_s11_xc5 = old['U_s11_xc5']
        P_s11_xc5 = old['P_s11_xc5']
        D_s11_xc5 = old['D_s11_xc5']
        K_s2 = old['K_s2']
        L_s2_1 = old['L_s2_1']
        L_s2_2 = old['L_s2_2']
        L_s2_3 = old['L_s2_3']
        L_s2_4 = old['L_s2_4']
        F_s2 = old['F_s2']
        U_s2 = old['U_s2']
        P_s2 = old['P_s2']
        D_s2 = old['D_s2']
        K_s2_out = old['K_s2_out']
        L_s2_out_2 = old['L_s2_out_2']
        F_s2_out = old['F_s2_out']
        U_s2_out = old['U_s2_out']
        P_s2_out = old['P_s2_out']
        D_s2_out = old['D_s2_out']
        K_s3 = old['K_s3']
        L_s3_1 = old['L_s3_1']
        L_s3_2 = old['L_s3_2']
        L_s3_3 = old['L_s3_3']
        L_s3_4 = old['L_s3_4']
        F_s3 = old['F_s3']
        U_s3 = old['U_s3']
        P_s3 = old['P_s3']
        D_s3 = old['D_s3']
        K_s4_xc1 = old['K_s4_xc1']
        L_s4_xc1_2 = old['L_s4_xc1_2']
        F_s4_xc1 = old['F_s4_xc1']
        U_s4_xc1 = old['U_s4_xc1']
        P_s4_xc1 = old['P_s4_xc1']
        D_s4_xc1 = old['D_s4_xc1']
        K_s5_xc2 = old['K_s5_xc2']
        L_s5_xc2_2 = old['L_s5_xc2_2']
        F_s5_xc2 = old['F_s5_xc2']
        U_s5_xc2 = old['U_s5_xc2']
        P_s5_xc2 = old['P_s5_xc2']
        D_s5_xc2 = old['D_s5_xc2']
        K_s6 = old['K_s6']
        L_s6_1 = old['L_s6_1']
        L_s6_2 = old['L_s6_2']
        L_s6_3 = old['L_s6_3']
        L_s6_4 = old['L_s6_4']
        F_s6 = old['F_s6']
        U_s6 = old['U_s6']
        P_s6 = old['P_s6']
        D_s6 = old['D_s6']
        K_s7 = old['K_s7']
        L_s7_1 = old['L_s7_1']
        L_s7_2 = old['L_s7_2']
        L_s7_3 = old['L_s7_3']
        L_s7_4 = old['L_s7_4']
        F_s7 = old['F_s7']
        U_s7 = old['U_s7']
        P_s7 = old['P_s7']
        D_s7 = old['D_s7']
        K_s8_xc3 = old['K_s8_xc3']
        L_s8_xc3_2 = old['L_s8_xc3_2']
        F_s8_xc3 = old['F_s8_xc3']
        U_s8_xc3 = old['U_s8_xc3']
        P_s8_xc3 = old['P_s8_xc3']
        D_s8_xc3 = old['D_s8_xc3']
        K_s9 = old['K_s9']
        L_s9_1 = old['L_s9_1']
        L_s9_2 = old['L_s9_2']
        L_s9_3 = old['L_s9_3']
        L_s9_4 = old['L_s9_4']
        F_s9 = old['F_s9']
        U_s9 = old['U_s9']
        P_s9 = old['P_s9']
        D_s9 = old['D_s9']
        ZF_INSIDE = old['ZF_INSIDE']
        OCC_s10_xc4 = (not CLR_s10_xc4) or (not VALID)  # s10_xc4 counts as occupied
        OCC_s11_xc5 = (not CLR_s11_xc5) or (not VALID)  # s11_xc5 counts as occupied
        OCC_s1_wait = (not CLR_s1_wait) or (not VALID)  # s1_wait counts as occupied
        OCC_s2 = (not CLR_s2) or (not VALID)  # s2 counts as occupied
        OCC_s2_out = (not CLR_s2_out) or (not VALID)  # s2_out counts as occupied
        OCC_s3 = (not CLR_s3) or (not VALID)  # s3 counts as occupied
        OCC_s4_xc1 = (not CLR_s4_xc1) or (not VALID)  # s4_xc1 counts as occupied
        OCC_s5_xc2 = (not CLR_s5_xc2) or (not VALID)  # s5_xc2 counts as occupied
        OCC_s6 = (not CLR_s6) or (not VALID)  # s6 counts as occupied
        OCC_s7 = (not CLR_s7) or (not VALID)  # s7 counts as occupied
        OCC_s8_xc3 = (not CLR_s8_xc3) or (not VALID)  # s8_xc3 counts as occupied
        OCC_s9 = (not CLR_s9) or (not VALID)  # s9 counts as occupied
        FREE_s10_xc4 = (not K_s10_xc4) and (not L_s10_xc4_2)  # s10_xc4 is not locked by anybody
        FREE_s11_xc5 = (not K_s11_xc5) and (not L_s11_xc5_2)  # s11_xc5 is not locked by anybody
        FREE_s2 = (not K_s2) and (not L_s2_1) and (not L_s2_2) and (not L_s2_3) and (not L_s2_4)  # s2 is not locked by anybody
        FREE_s2_out = (not K_s2_out) and (not L_s2_out_2)  # s2_out is not locked by anybody
        FREE_s3 = (not K_s3) and (not L_s3_1) and (not L_s3_2) and (not L_s3_3) and (not L_s3_4)  # s3 is not locked by anybody
        FREE_s4_xc1 = (not K_s4_xc1) and (not L_s4_xc1_2)  # s4_xc1 is not locked by anybody
        FREE_s5_xc2 = (not K_s5_xc2) and (not L_s5_xc2_2)  # s5_xc2 is not locked by anybody
        FREE_s6 = (not K_s6) and (not L_s6_1) and (not L_s6_2) and (not L_s6_3) and (not L_s6_4)  # s6 is not locked by anybody
        FREE_s7 = (not K_s7) and (not L_s7_1) and (not L_s7_2) and (not L_s7_3) and (not L_s7_4)  # s7 is not locked by anybody
        FREE_s8_xc3 = (not K_s8_xc3) and (not L_s8_xc3_2)  # s8_xc3 is not locked by anybody
        FREE_s9 = (not K_s9) and (not L_s9_1) and (not L_s9_2) and (not L_s9_3) and (not L_s9_4)  # s9 is not locked by anybody
        QN_P1 = VALID and DN_P1 and (not DR_P1)  # machine P1 lies N (R10)
        QR_P1 = VALID and DR_P1 and (not DN_P1)  # machine P1 lies R (R10)
        QN_P2 = VALID and DN_P2 and (not DR_P2)  # machine P2 lies N (R10)
        QR_P2 = VALID and DR_P2 and (not DN_P2)  # machine P2 lies R (R10)
        QN_P3 = VALID and DN_P3 and (not DR_P3)  # machine P3 lies N (R10)
        QR_P3 = VALID and DR_P3 and (not DN_P3)  # machine P3 lies R (R10)
        QN_P4 = VALID and DN_P4 and (not DR_P4)  # machine P4 lies N (R10)
        QR_P4 = VALID and DR_P4 and (not DN_P4)  # machine P4 lies R (R10)
        QN_PS = VALID and DN_PS and (not DR_PS)  # machine PS lies N (R10)
        QR_PS = VALID and DR_PS and (not DN_PS)  # machine PS lies R (R10)
        MOV_P1 = VALID and FREE_s3 and (not OCC_s3) and True and True  # machine P1 is free to move (R10)
        AVN_P1 = CN_P1 or MOV_P1 or (QN_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded N
        AVR_P1 = CR_P1 or MOV_P1 or (QR_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded R
        MOV_P2 = VALID and FREE_s6 and (not OCC_s6) and True and True  # machine P2 is free to move (R10)
        AVN_P2 = CN_P2 or MOV_P2 or (QN_P2 and (not CN_P2) and (not CR_P2))  # machine P2 can be demanded N
        AVR_P2 = CR_P2 or MOV_P2 or (QR_P2 and (not CN_P2) and (not CR_P2))  # machine P2 can be demanded R
        MOV_P3 = VALID and FREE_s7 and (not OCC_s7) and True and True  # machine P3 is free to move (R10)
        AVN_P3 = CN_P3 or MOV_P3 or (QN_P3 and (not CN_P3) and (not CR_P3))  # machine P3 can be demanded N
        AVR_P3 = CR_P3 or MOV_P3 or (QR_P3 and (not CN_P3) and (not CR_P3))  # machine P3 can be demanded R
        MOV_P4 = VALID and FREE_s9 and (not OCC_s9) and True and True  # machine P4 is free to move (R10)
        AVN_P4 = CN_P4 or MOV_P4 or (QN_P4 and (not CN_P4) and (not CR_P4))  # machine P4 can be demanded N
        AVR_P4 = CR_P4 or MOV_P4 or (QR_P4 and (not CN_P4) and (not CR_P4))  # machine P4 can be demanded R
        MOV_PS = VALID and FREE_s2 and (not OCC_s2) and True and True  # machine PS is free to move (R10)
        AVN_PS = CN_PS or MOV_PS or (QN_PS and (not CN_PS) and (not CR_PS))  # machine PS can be demanded N
        AVR_PS = CR_PS or MOV_PS or (QR_PS and (not CN_PS) and (not CR_PS))  # machine PS can be demanded R
        WF_s10_xc4_2 = FREE_s10_xc4 and (not OCC_s10_xc4) and (not BLK_s10_xc4)  # s10_xc4 from s10_xc4|s9@P4.normal to XC4: free for a route (R6)
        WF_s11_xc5_2 = FREE_s11_xc5 and (not OCC_s11_xc5) and (not BLK_s11_xc5)  # s11_xc5 from s11_xc5|s9@P4.reverse to XC5: free for a route (R6)
        WA_s2_1 = AVR_PS and (not TR_PS)  # s2 from W to s2|s2_out@PS.reverse: could be locked
        WF_s2_1 = FREE_s2 and (not OCC_s2) and (not BLK_s2) and WA_s2_1  # s2 from W to s2|s2_out@PS.reverse: free for a route (R6)
        WA_s2_2 = AVN_PS and (not TR_PS)  # s2 from W to s2|s3@PS.normal: could be locked
        WF_s2_2 = FREE_s2 and (not OCC_s2) and (not BLK_s2) and WA_s2_2  # s2 from W to s2|s3@PS.normal: free for a route (R6)
        WA_s2_3 = AVR_PS and (not TR_PS)  # s2 from s2|s2_out@PS.reverse to W: could be locked
        WF_s2_3 = FREE_s2 and (not OCC_s2) and (not BLK_s2) and WA_s2_3  # s2 from s2|s2_out@PS.reverse to W: free for a route (R6)
        WA_s2_4 = AVN_PS and (not TR_PS)  # s2 from s2|s3@PS.normal to W: could be locked
        WF_s2_4 = FREE_s2 and (not OCC_s2) and (not BLK_s2) and WA_s2_4  # s2 from s2|s3@PS.normal to W: free for a route (R6)
        WF_s2_out_2 = FREE_s2_out and (not OCC_s2_out) and (not BLK_s2_out)  # s2_out from s2|s2_out@PS.reverse to OUT: free for a route (R6)
        WA_s3_1 = AVR_P1 and (not TR_P1)  # s3 from s2|s3@PS.normal to s3|s4_xc1@P1.reverse: could be locked
        WF_s3_1 = FREE_s3 and (not OCC_s3) and (not BLK_s3) and WA_s3_1  # s3 from s2|s3@PS.normal to s3|s4_xc1@P1.reverse: free for a route (R6)
        WA_s3_2 = AVN_P1 and (not TR_P1)  # s3 from s2|s3@PS.normal to s3|s6@P1.normal: could be locked
        WF_s3_2 = FREE_s3 and (not OCC_s3) and (not BLK_s3) and WA_s3_2  # s3 from s2|s3@PS.normal to s3|s6@P1.normal: free for a route (R6)
        WA_s3_3 = AVR_P1 and (not TR_P1)  # s3 from s3|s4_xc1@P1.reverse to s2|s3@PS.normal: could be locked
        WF_s3_3 = FREE_s3 and (not OCC_s3) and (not BLK_s3) and WA_s3_3  # s3 from s3|s4_xc1@P1.reverse to s2|s3@PS.normal: free for a route (R6)
        WA_s3_4 = AVN_P1 and (not TR_P1)  # s3 from s3|s6@P1.normal to s2|s3@PS.normal: could be locked
        WF_s3_4 = FREE_s3 and (not OCC_s3) and (not BLK_s3) and WA_s3_4  # s3 from s3|s6@P1.normal to s2|s3@PS.normal: free for a route (R6)
        WF_s4_xc1_2 = FREE_s4_xc1 and (not OCC_s4_xc1) and (not BLK_s4_xc1)  # s4_xc1 from s3|s4_xc1@P1.reverse to XC1: free for a route (R6)
        WF_s5_xc2_2 = FREE_s5_xc2 and (not OCC_s5_xc2) and (not BLK_s5_xc2)  # s5_xc2 from s5_xc2|s6@P2.reverse to XC2: free for a route (R6)
        WA_s6_1 = AVR_P2 and (not TR_P2)  # s6 from s3|s6@P1.normal to s5_xc2|s6@P2.reverse: could be locked
        WF_s6_1 = FREE_s6 and (not OCC_s6) and (not BLK_s6) and WA_s6_1  # s6 from s3|s6@P1.normal to s5_xc2|s6@P2.reverse: free for a route (R6)
        WA_s6_2 = AVN_P2 and (not TR_P2)  # s6 from s3|s6@P1.normal to s6|s7@P2.normal: could be locked
        WF_s6_2 = FREE_s6 and (not OCC_s6) and (not BLK_s6) and WA_s6_2  # s6 from s3|s6@P1.normal to s6|s7@P2.normal: free for a route (R6)
        WA_s6_3 = AVR_P2 and (not TR_P2)  # s6 from s5_xc2|s6@P2.reverse to s3|s6@P1.normal: could be locked
        WF_s6_3 = FREE_s6 and (not OCC_s6) and (not BLK_s6) and WA_s6_3  # s6 from s5_xc2|s6@P2.reverse to s3|s6@P1.normal: free for a route (R6)
        WA_s6_4 = AVN_P2 and (not TR_P2)  # s6 from s6|s7@P2.normal to s3|s6@P1.normal: could be locked
        WF_s6_4 = FREE_s6 and (not OCC_s6) and (not BLK_s6) and WA_s6_4  # s6 from s6|s7@P2.normal to s3|s6@P1.normal: free for a route (R6)
        WA_s7_1 = AVR_P3 and (not TR_P3)  # s7 from s6|s7@P2.normal to s7|s8_xc3@P3.reverse: could be locked
        WF_s7_1 = FREE_s7 and (not OCC_s7) and (not BLK_s7) and WA_s7_1  # s7 from s6|s7@P2.normal to s7|s8_xc3@P3.reverse: free for a route (R6)
        WA_s7_2 = AVN_P3 and (not TR_P3)  # s7 from s6|s7@P2.normal to s7|s9@P3.normal: could be locked
        WF_s7_2 = FREE_s7 and (not OCC_s7) and (not BLK_s7) and WA_s7_2  # s7 from s6|s7@P2.normal to s7|s9@P3.normal: free for a route (R6)
        WA_s7_3 = AVR_P3 and (not TR_P3)  # s7 from s7|s8_xc3@P3.reverse to s6|s7@P2.normal: could be locked
        WF_s7_3 = FREE_s7 and (not OCC_s7) and (not BLK_s7) and WA_s7_3  # s7 from s7|s8_xc3@P3.reverse to s6|s7@P2.normal: free for a route (R6)
        WA_s7_4 = AVN_P3 and (not TR_P3)  # s7 from s7|s9@P3.normal to s6|s7@P2.normal: could be locked
        WF_s7_4 = FREE_s7 and (not OCC_s7) and (not BLK_s7) and WA_s7_4  # s7 from s7|s9@P3.normal to s6|s7@P2.normal: free for a route (R6)
        WF_s8_xc3_2 = FREE_s8_xc3 and (not OCC_s8_xc3) and (not BLK_s8_xc3)  # s8_xc3 from s7|s8_xc3@P3.reverse to XC3: free for a route (R6)
        WA_s9_1 = AVN_P4 and (not TR_P4)  # s9 from s10_xc4|s9@P4.normal to s7|s9@P3.normal: could be locked
        WF_s9_1 = FREE_s9 and (not OCC_s9) and (not BLK_s9) and WA_s9_1  # s9 from s10_xc4|s9@P4.normal to s7|s9@P3.normal: free for a route (R6)
        WA_s9_2 = AVR_P4 and (not TR_P4)  # s9 from s11_xc5|s9@P4.reverse to s7|s9@P3.normal: could be locked
        WF_s9_2 = FREE_s9 and (not OCC_s9) and (not BLK_s9) and WA_s9_2  # s9 from s11_xc5|s9@P4.reverse to s7|s9@P3.normal: free for a route (R6)
        WA_s9_3 = AVN_P4 and (not TR_P4)  # s9 from s7|s9@P3.normal to s10_xc4|s9@P4.normal: could be locked
        WF_s9_3 = FREE_s9 and (not OCC_s9) and (not BLK_s9) and WA_s9_3  # s9 from s7|s9@P3.normal to s10_xc4|s9@P4.normal: free for a route (R6)
        WA_s9_4 = AVR_P4 and (not TR_P4)  # s9 from s7|s9@P3.normal to s11_xc5|s9@P4.reverse: could be locked
        WF_s9_4 = FREE_s9 and (not OCC_s9) and (not BLK_s9) and WA_s9_4  # s9 from s7|s9@P3.normal to s11_xc5|s9@P4.reverse: free for a route (R6)
        WL_s10_xc4_2 = (not OCC_s10_xc4)  # s10_xc4 from s10_xc4|s9@P4.normal to XC4: lies and is clear
        WP_s10_xc4_2 = WL_s10_xc4_2 and (not BLK_s10_xc4)  # s10_xc4 from s10_xc4|s9@P4.normal to XC4: proceed may be shown over it (R3)
        WL_s11_xc5_2 = (not OCC_s11_xc5)  # s11_xc5 from s11_xc5|s9@P4.reverse to XC5: lies and is clear
        WP_s11_xc5_2 = WL_s11_xc5_2 and (not BLK_s11_xc5)  # s11_xc5 from s11_xc5|s9@P4.reverse to XC5: proceed may be shown over it (R3)
        WD_s2_1 = QR_PS and (not TR_PS)  # s2 from W to s2|s2_out@PS.reverse: its points lie, nothing is foul of it
        WL_s2_1 = (not OCC_s2) and WD_s2_1  # s2 from W to s2|s2_out@PS.reverse: lies and is clear
        WP_s2_1 = WL_s2_1 and (not BLK_s2)  # s2 from W to s2|s2_out@PS.reverse: proceed may be shown over it (R3)
        WD_s2_2 = QN_PS and (not TR_PS)  # s2 from W to s2|s3@PS.normal: its points lie, nothing is foul of it
        WL_s2_2 = (not OCC_s2) and WD_s2_2  # s2 from W to s2|s3@PS.normal: lies and is clear
        WP_s2_2 = WL_s2_2 and (not BLK_s2)  # s2 from W to s2|s3@PS.normal: proceed may be shown over it (R3)
        WD_s2_3 = QR_PS and (not TR_PS)  # s2 from s2|s2_out@PS.reverse to W: its points lie, nothing is foul of it
        WL_s2_3 = (not OCC_s2) and WD_s2_3  # s2 from s2|s2_out@PS.reverse to W: lies and is clear
        WP_s2_3 = WL_s2_3 and (not BLK_s2)  # s2 from s2|s2_out@PS.reverse to W: proceed may be shown over it (R3)
        WD_s2_4 = QN_PS and (not TR_PS)  # s2 from s2|s3@PS.normal to W: its points lie, nothing is foul of it
        WL_s2_4 = (not OCC_s2) and WD_s2_4  # s2 from s2|s3@PS.normal to W: lies and is clear
        WP_s2_4 = WL_s2_4 and (not BLK_s2)  # s2 from s2|s3@PS.normal to W: proceed may be shown over it (R3)
        WL_s2_out_2 = (not OCC_s2_out)  # s2_out from s2|s2_out@PS.reverse to OUT: lies and is clear
        WP_s2_out_2 = WL_s2_out_2 and (not BLK_s2_out)  # s2_out from s2|s2_out@PS.reverse to OUT: proceed may be shown over it (R3)
        WD_s3_1 = QR_P1 and (not TR_P1)  # s3 from s2|s3@PS.normal to s3|s4_xc1@P1.reverse: its points lie, nothing is foul of it
        WL_s3_1 = (not OCC_s3) and WD_s3_1  # s3 from s2|s3@PS.normal to s3|s4_xc1@P1.reverse: lies and is clear
        WP_s3_1 = WL_s3_1 and (not BLK_s3)  # s3 from s2|s3@PS.normal to s3|s4_xc1@P1.reverse: proceed may be shown over it (R3)
        WD_s3_2 = QN_P1 and (not TR_P1)  # s3 from s2|s3@PS.normal to s3|s6@P1.normal: its points lie, nothing is foul of it
        WL_s3_2 = (not OCC_s3) and WD_s3_2  # s3 from s2|s3@PS.normal to s3|s6@P1.normal: lies and is clear
        WP_s3_2 = WL_s3_2 and (not BLK_s3)  # s3 from s2|s3@PS.normal to s3|s6@P1.normal: proceed may be shown over it (R3)
        WD_s3_3 = QR_P1 and (not TR_P1)  # s3 from s3|s4_xc1@P1.reverse to s2|s3@PS.normal: its points lie, nothing is foul of it
        WL_s3_3 = (not OCC_s3) and WD_s3_3  # s3 from s3|s4_xc1@P1.reverse to s2|s3@PS.normal: lies and is clear
        WP_s3_3 = WL_s3_3 and (not BLK_s3)  # s3 from s3|s4_xc1@P1.reverse to s2|s3@PS.normal: proceed may be shown over it (R3)
        WD_s3_4 = QN_P1 and (not TR_P1)  # s3 from s3|s6@P1.normal to s2|s3@PS.normal: its points lie, nothing is foul of it
        WL_s3_4 = (not OCC_s3) and WD_s3_4  # s3 from s3|s6@P1.normal to s2|s3@PS.normal: lies and is clear
        WP_s3_4 = WL_s3_4 and (not BLK_s3)  # s3 from s3|s6@P1.normal to s2|s3@PS.normal: proceed may be shown over it (R3)
        WL_s4_xc1_2 = (not OCC_s4_xc1)  # s4_xc1 from s3|s4_xc1@P1.reverse to XC1: lies and is clear
        WP_s4_xc1_2 = WL_s4_xc1_2 and (not BLK_s4_xc1)  # s4_xc1 from s3|s4_xc1@P1.reverse to XC1: proceed may be shown over it (R3)
        WL_s5_xc2_2 = (not OCC_s5_xc2)  # s5_xc2 from s5_xc2|s6@P2.reverse to XC2: lies and is clear
        WP_s5_xc2_2 = WL_s5_xc2_2 and (not BLK_s5_xc2)  # s5_xc2 from s5_xc2|s6@P2.reverse to XC2: proceed may be shown over it (R3)
        WD_s6_1 = QR_P2 and (not TR_P2)  # s6 from s3|s6@P1.normal to s5_xc2|s6@P2.reverse: its points lie, nothing is foul of it
        WL_s6_1 = (not OCC_s6) and WD_s6_1  # s6 from s3|s6@P1.normal to s5_xc2|s6@P2.reverse: lies and is clear
        WP_s6_1 = WL_s6_1 and (not BLK_s6)  # s6 from s3|s6@P1.normal to s5_xc2|s6@P2.reverse: proceed may be shown over it (R3)
        WD_s6_2 = QN_P2 and (not TR_P2)  # s6 from s3|s6@P1.normal to s6|s7@P2.normal: its points lie, nothing is foul of it
        WL_s6_2 = (not OCC_s6) and WD_s6_2  # s6 from s3|s6@P1.normal to s6|s7@P2.normal: lies and is clear
        WP_s6_2 = WL_s6_2 and (not BLK_s6)  # s6 from s3|s6@P1.normal to s6|s7@P2.normal: proceed may be shown over it (R3)
        WD_s6_3 = QR_P2 and (not TR_P2)  # s6 from s5_xc2|s6@P2.reverse to s3|s6@P1.normal: its points lie, nothing is foul of it
        WL_s6_3 = (not OCC_s6) and WD_s6_3  # s6 from s5_xc2|s6@P2.reverse to s3|s6@P1.normal: lies and is clear
        WP_s6_3 = WL_s6_3 and (not BLK_s6)  # s6 from s5_xc2|s6@P2.reverse to s3|s6@P1.normal: proceed may be shown over it (R3)
        WD_s6_4 = QN_P2 and (not TR_P2)  # s6 from s6|s7@P2.normal to s3|s6@P1.normal: its points lie, nothing is foul of it
        WL_s6_4 = (not OCC_s6) and WD_s6_4  # s6 from s6|s7@P2.normal to s3|s6@P1.normal: lies and is clear
        WP_s6_4 = WL_s6_4 and (not BLK_s6)  # s6 from s6|s7@P2.normal to s3|s6@P1.normal: proceed may be shown over it (R3)
        WD_s7_1 = QR_P3 and (not TR_P3)  # s7 from s6|s7@P2.normal to s7|s8_xc3@P3.reverse: its points lie, nothing is foul of it
        WL_s7_1 = (not OCC_s7) and WD_s7_1  # s7 from s6|s7@P2.normal to s7|s8_xc3@P3.reverse: lies and is clear
        WP_s7_1 = WL_s7_1 and (not BLK_s7)  # s7 from s6|s7@P2.normal to s7|s8_xc3@P3.reverse: proceed may be shown over it (R3)
        WD_s7_2 = QN_P3 and (not TR_P3)  # s7 from s6|s7@P2.normal to s7|s9@P3.normal: its points lie, nothing is foul of it
        WL_s7_2 = (not OCC_s7) and WD_s7_2  # s7 from s6|s7@P2.normal to s7|s9@P3.normal: lies and is clear
        WP_s7_2 = WL_s7_2 and (not BLK_s7)  # s7 from s6|s7@P2.normal to s7|s9@P3.normal: proceed may be shown over it (R3)
        WD_s7_3 = QR_P3 and (not TR_P3)  # s7 from s7|s8_xc3@P3.reverse to s6|s7@P2.normal: its points lie, nothing is foul of it
        WL_s7_3 = (not OCC_s7) and WD_s7_3  # s7 from s7|s8_xc3@P3.reverse to s6|s7@P2.normal: lies and is clear
        WP_s7_3 = WL_s7_3 and (not BLK_s7)  # s7 from s7|s8_xc3@P3.reverse to s6|s7@P2.normal: proceed may be shown over it (R3)
        WD_s7_4 = QN_P3 and (not TR_P3)  # s7 from s7|s9@P3.normal to s6|s7@P2.normal: its points lie, nothing is foul of it
        WL_s7_4 = (not OCC_s7) and WD_s7_4  # s7 from s7|s9@P3.normal to s6|s7@P2.normal: lies and is clear
        WP_s7_4 = WL_s7_4 and (not BLK_s7)  # s7 from s7|s9@P3.normal to s6|s7@P2.normal: proceed may be shown over it (R3)
        WL_s8_xc3_2 = (not OCC_s8_xc3)  # s8_xc3 from s7|s8_xc3@P3.reverse to XC3: lies and is clear
        WP_s8_xc3_2 = WL_s8_xc3_2 and (not BLK_s8_xc3)  # s8_xc3 from s7|s8_xc3@P3.reverse to XC3: proceed may be shown over it (R3)
        WD_s9_1 = QN_P4 and (not TR_P4)  # s9 from s10_xc4|s9@P4.normal to s7|s9@P3.normal: its points lie, nothing is foul of it
        WL_s9_1 = (not OCC_s9) and WD_s9_1  # s9 from s10_xc4|s9@P4.normal to s7|s9@P3.normal: lies and is clear
        WP_s9_1 = WL_s9_1 and (not BLK_s9)  # s9 from s10_xc4|s9@P4.normal to s7|s9@P3.normal: proceed may be shown over it (R3)
        WD_s9_2 = QR_P4 and (not TR_P4)  # s9 from s11_xc5|s9@P4.reverse to s7|s9@P3.normal: its points lie, nothing is foul of it
        WL_s9_2 = (not OCC_s9) and WD_s9_2  # s9 from s11_xc5|s9@P4.reverse to s7|s9@P3.normal: lies and is clear
        WP_s9_2 = WL_s9_2 and (not BLK_s9)  # s9 from s11_xc5|s9@P4.reverse to s7|s9@P3.normal: proceed may be shown over it (R3)
        WD_s9_3 = QN_P4 and (not TR_P4)  # s9 from s7|s9@P3.normal to s10_xc4|s9@P4.normal: its points lie, nothing is foul of it
        WL_s9_3 = (not OCC_s9) and WD_s9_3  # s9 from s7|s9@P3.normal to s10_xc4|s9@P4.normal: lies and is clear
        WP_s9_3 = WL_s9_3 and (not BLK_s9)  # s9 from s7|s9@P3.normal to s10_xc4|s9@P4.normal: proceed may be shown over it (R3)
        WD_s9_4 = QR_P4 and (not TR_P4)  # s9 from s7|s9@P3.normal to s11_xc5|s9@P4.reverse: its points lie, nothing is foul of it
        WL_s9_4 = (not OCC_s9) and WD_s9_4  # s9 from s7|s9@P3.normal to s11_xc5|s9@P4.reverse: lies and is clear
        WP_s9_4 = WL_s9_4 and (not BLK_s9)  # s9 from s7|s9@P3.normal to s11_xc5|s9@P4.reverse: proceed may be shown over it (R3)
        ZB1_s10_xc4 = K_s10_xc4 or (L_s10_xc4_2 and (not (L_s9_3 and (not U_s10_xc4) and (not D_s10_xc4))))  # s10_xc4 counts in INSIDE
        ZN1_1_1 = ZB1_s10_xc4  # 
        ZB1_s11_xc5 = K_s11_xc5 or (L_s11_xc5_2 and (not (L_s9_4 and (not U_s11_xc5) and (not D_s11_xc5))))  # s11_xc5 counts in INSIDE
        ZN1_2_1 = ZB1_s11_xc5 or ZN1_1_1  # 
        ZN1_2_2 = (ZN1_1_1 and ZB1_s11_xc5)  # 
        ZB1_s3 = K_s3 or L_s3_1 or L_s3_2 or L_s3_3 or (L_s3_4 and (not ((L_s6_3 or L_s6_4) and (not U_s3) and (not D_s3))))  # s3 counts in INSIDE
        ZN1_3_1 = ZB1_s3 or ZN1_2_1  # 
        ZN1_3_2 = (ZN1_2_1 and ZB1_s3) or ZN1_2_2  # 
        ZN1_3_3 = (ZN1_2_2 and ZB1_s3)  # 
        ZB1_s4_xc1 = K_s4_xc1 or (L_s4_xc1_2 and (not (L_s3_1 and (not U_s4_xc1) and (not D_s4_xc1))))  # s4_xc1 counts in INSIDE
        ZN1_4_1 = ZB1_s4_xc1 or ZN1_3_1  # 
        ZN1_4_2 = (ZN1_3_1 and ZB1_s4_xc1) or ZN1_3_2  # 
        ZN1_4_3 = (ZN1_3_2 and ZB1_s4_xc1) or ZN1_3_3  # 
        ZN1_4_4 = (ZN1_3_3 and ZB1_s4_xc1)  # 
        ZB1_s5_xc2 = K_s5_xc2 or (L_s5_xc2_2 and (not (L_s6_1 and (not U_s5_xc2) and (not D_s5_xc2))))  # s5_xc2 counts in INSIDE
        ZN1_5_1 = ZB1_s5_xc2 or ZN1_4_1  # 
        ZN1_5_2 = (ZN1_4_1 and ZB1_s5_xc2) or ZN1_4_2  # 
        ZN1_5_3 = (ZN1_4_2 and ZB1_s5_xc2) or ZN1_4_3  # 
        ZN1_5_4 = (ZN1_4_3 and ZB1_s5_xc2) or ZN1_4_4  # 
        ZB1_s6 = K_s6 or (L_s6_1 and (not (L_s3_2 and (not U_s6) and (not D_s6)))) or (L_s6_2 and (not (L_s3_2 and (not U_s6) and (not D_s6)))) or L_s6_3 or (L_s6_4 and (not ((L_s7_3 or L_s7_4) and (not U_s6) and (not D_s6))))  # s6 counts in INSIDE
        ZN1_6_1 = ZB1_s6 or ZN1_5_1  # 
        ZN1_6_2 = (ZN1_5_1 and ZB1_s6) or ZN1_5_2  # 
        ZN1_6_3 = (ZN1_5_2 and ZB1_s6) or ZN1_5_3  # 
        ZN1_6_4 = (ZN1_5_3 and ZB1_s6) or ZN1_5_4  # 
        ZB1_s7 = K_s7 or (L_s7_1 and (not (L_s6_2 and (not U_s7) and (not D_s7)))) or (L_s7_2 and (not (L_s6_2 and (not U_s7) and (not D_s7)))) or L_s7_3 or (L_s7_4 and (not ((L_s9_1 or L_s9_2) and (not U_s7) and (not D_s7))))  # s7 counts in INSIDE
        ZN1_7_1 = ZB1_s7 or ZN1_6_1  # 
        ZN1_7_2 = (ZN1_6_1 and ZB1_s7) or ZN1_6_2  # 
        ZN1_7_3 = (ZN1_6_2 and ZB1_s7) or ZN1_6_3  # 
        ZN1_7_4 = (ZN1_6_3 and ZB1_s7) or ZN1_6_4  # 
        ZB1_s8_xc3 = K_s8_xc3 or (L_s8_xc3_2 and (not (L_s7_1 and (not U_s8_xc3) and (not D_s8_xc3))))  # s8_xc3 counts in INSIDE
        ZN1_8_1 = ZB1_s8_xc3 or ZN1_7_1  # 
        ZN1_8_2 = (ZN1_7_1 and ZB1_s8_xc3) or ZN1_7_2  # 
        ZN1_8_3 = (ZN1_7_2 and ZB1_s8_xc3) or ZN1_7_3  # 
        ZN1_8_4 = (ZN1_7_3 and ZB1_s8_xc3) or ZN1_7_4  # 
        ZB1_s9 = K_s9 or L_s9_1 or L_s9_2 or (L_s9_3 and (not (L_s7_2 and (not U_s9) and (not D_s9)))) or (L_s9_4 and (not (L_s7_2 and (not U_s9) and (not D_s9))))  # s9 counts in INSIDE
        ZN1_9_1 = ZB1_s9 or ZN1_8_1  # 
        ZN1_9_2 = (ZN1_8_1 and ZB1_s9) or ZN1_8_2  # 
        ZN1_9_3 = (ZN1_8_2 and ZB1_s9) or ZN1_8_3  # 
        ZN1_9_4 = (ZN1_8_3 and ZB1_s9) or ZN1_8_4  # 
        G_R1 = ((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and VALID and WF_s2_1 and WF_s2_out_2  # grant of route XB-OUT (R6)
        G_R2 = ((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) and VALID and WF_s2_2 and WF_s3_1 and WF_s4_xc1_2 and (not ZN1_9_4)  # grant of route XB-XC1 (R6)
        G_R3 = ((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and VALID and WF_s2_2 and WF_s3_2 and WF_s6_1 and WF_s5_xc2_2 and (not ZN1_9_4)  # grant of route XB-XC2 (R6)
        G_R4 = ((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and VALID and WF_s2_2 and WF_s3_2 and WF_s6_2 and (not ZN1_9_4)  # grant of route XB-XI7 (R6)
        G_R5 = ((LREQ == 5) or ((LREQ == 0) and (REQ == 5))) and VALID and WF_s7_1 and WF_s8_xc3_2  # grant of route XI7-XC3 (R6)
        G_R6 = ((LREQ == 6) or ((LREQ == 0) and (REQ == 6))) and VALID and WF_s7_2  # grant of route XI7-XI9 (R6)
        G_R7 = ((LREQ == 7) or ((LREQ == 0) and (REQ == 7))) and VALID and WF_s9_3 and WF_s10_xc4_2  # grant of route XI9-XC4 (R6)
        G_R8 = ((LREQ == 8) or ((LREQ == 0) and (REQ == 8))) and VALID and WF_s9_4 and WF_s11_xc5_2  # grant of route XI9-XC5 (R6)
        G_R9 = ((LREQ == 9) or ((LREQ == 0) and (REQ == 9))) and VALID and WF_s3_3  # grant of route XL1-XT3 (R6)
        G_R10 = ((LREQ == 10) or ((LREQ == 0) and (REQ == 10))) and VALID and WF_s6_3 and WF_s3_4  # grant of route XL2-XT3 (R6)
        G_R11 = ((LREQ == 11) or ((LREQ == 0) and (REQ == 11))) and VALID and WF_s7_3  # grant of route XL3-XT7 (R6)
        G_R12 = ((LREQ == 12) or ((LREQ == 0) and (REQ == 12))) and VALID and WF_s9_1  # grant of route XL4-XT9 (R6)
        G_R13 = ((LREQ == 13) or ((LREQ == 0) and (REQ == 13))) and VALID and WF_s9_2  # grant of route XL5-XT9 (R6)
        G_R14 = ((LREQ == 14) or ((LREQ == 0) and (REQ == 14))) and VALID and WF_s2_3  # grant of route XO-W (R6)
        G_R15 = ((LREQ == 15) or ((LREQ == 0) and (REQ == 15))) and VALID and WF_s2_4  # grant of route XT3-W (R6)
        G_R16 = ((LREQ == 16) or ((LREQ == 0) and (REQ == 16))) and VALID and WF_s6_4 and WF_s3_4  # grant of route XT7-XT3 (R6)
        G_R17 = ((LREQ == 17) or ((LREQ == 0) and (REQ == 17))) and VALID and WF_s7_4  # grant of route XT9-XT7 (R6)
        GW_s10_xc4_2 = G_R7  # s10_xc4 from s10_xc4|s9@P4.normal to XC4: granted
        GW_s11_xc5_2 = G_R8  # s11_xc5 from s11_xc5|s9@P4.reverse to XC5: granted
        GW_s2_1 = G_R1  # s2 from W to s2|s2_out@PS.reverse: granted
        GW_s2_2 = G_R2 or G_R3 or G_R4  # s2 from W to s2|s3@PS.normal: granted
        GW_s2_3 = G_R14  # s2 from s2|s2_out@PS.reverse to W: granted
        GW_s2_4 = G_R15  # s2 from s2|s3@PS.normal to W: granted
        GW_s2_out_2 = G_R1  # s2_out from s2|s2_out@PS.reverse to OUT: granted
        GW_s3_1 = G_R2  # s3 from s2|s3@PS.normal to s3|s4_xc1@P1.reverse: granted
        GW_s3_2 = G_R3 or G_R4  # s3 from s2|s3@PS.normal to s3|s6@P1.normal: granted
        GW_s3_3 = G_R9  # s3 from s3|s4_xc1@P1.reverse to s2|s3@PS.normal: granted
        GW_s3_4 = G_R10 or G_R16  # s3 from s3|s6@P1.normal to s2|s3@PS.normal: granted
        GW_s4_xc1_2 = G_R2  # s4_xc1 from s3|s4_xc1@P1.reverse to XC1: granted
        GW_s5_xc2_2 = G_R3  # s5_xc2 from s5_xc2|s6@P2.reverse to XC2: granted
        GW_s6_1 = G_R3  # s6 from s3|s6@P1.normal to s5_xc2|s6@P2.reverse: granted
        GW_s6_2 = G_R4  # s6 from s3|s6@P1.normal to s6|s7@P2.normal: granted
        GW_s6_3 = G_R10  # s6 from s5_xc2|s6@P2.reverse to s3|s6@P1.normal: granted
        GW_s6_4 = G_R16  # s6 from s6|s7@P2.normal to s3|s6@P1.normal: granted
        GW_s7_1 = G_R5  # s7 from s6|s7@P2.normal to s7|s8_xc3@P3.reverse: granted
        GW_s7_2 = G_R6  # s7 from s6|s7@P2.normal to s7|s9@P3.normal: granted
        GW_s7_3 = G_R11  # s7 from s7|s8_xc3@P3.reverse to s6|s7@P2.normal: granted
        GW_s7_4 = G_R17  # s7 from s7|s9@P3.normal to s6|s7@P2.normal: granted
        GW_s8_xc3_2 = G_R5  # s8_xc3 from s7|s8_xc3@P3.reverse to XC3: granted
        GW_s9_1 = G_R12  # s9 from s10_xc4|s9@P4.normal to s7|s9@P3.normal: granted
        GW_s9_2 = G_R13  # s9 from s11_xc5|s9@P4.reverse to s7|s9@P3.normal: granted
        GW_s9_3 = G_R7  # s9 from s7|s9@P3.normal to s10_xc4|s9@P4.normal: granted
        GW_s9_4 = G_R8  # s9 from s7|s9@P3.normal to s11_xc5|s9@P4.reverse: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_XB) and (not CAN_XB) and WL_s2_1 and WL_s2_out_2  # route XB-OUT becomes locked (R3)
        CO_R1 = VALID and WP_s2_1 and WP_s2_out_2 and (not D_s2)  # conditions of proceed for route XB-OUT (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_XB) and (not CAN_XB) and WL_s2_2 and WL_s3_1 and WL_s4_xc1_2  # route XB-XC1 becomes locked (R3)
        CO_R2 = VALID and WP_s2_2 and WP_s3_1 and WP_s4_xc1_2 and (not D_s2)  # conditions of proceed for route XB-XC1 (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_XB) and (not CAN_XB) and WL_s2_2 and WL_s3_2 and WL_s6_1 and WL_s5_xc2_2  # route XB-XC2 becomes locked (R3)
        CO_R3 = VALID and WP_s2_2 and WP_s3_2 and WP_s6_1 and WP_s5_xc2_2 and (not D_s2)  # conditions of proceed for route XB-XC2 (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_XB) and (not CAN_XB) and WL_s2_2 and WL_s3_2 and WL_s6_2  # route XB-XI7 becomes locked (R3)
        CO_R4 = VALID and WP_s2_2 and WP_s3_2 and WP_s6_2 and (not D_s2)  # conditions of proceed for route XB-XI7 (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_XI7) and (not CAN_XI7) and WL_s7_1 and WL_s8_xc3_2  # route XI7-XC3 becomes locked (R3)
        CO_R5 = VALID and WP_s7_1 and WP_s8_xc3_2 and (not D_s7)  # conditions of proceed for route XI7-XC3 (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_XI7) and (not CAN_XI7) and WL_s7_2  # route XI7-XI9 becomes locked (R3)
        CO_R6 = VALID and WP_s7_2 and (not D_s7)  # conditions of proceed for route XI7-XI9 (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_XI9) and (not CAN_XI9) and WL_s9_3 and WL_s10_xc4_2  # route XI9-XC4 becomes locked (R3)
        CO_R7 = VALID and WP_s9_3 and WP_s10_xc4_2 and (not D_s9)  # conditions of proceed for route XI9-XC4 (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_XI9) and (not CAN_XI9) and WL_s9_4 and WL_s11_xc5_2  # route XI9-XC5 becomes locked (R3)
        CO_R8 = VALID and WP_s9_4 and WP_s11_xc5_2 and (not D_s9)  # conditions of proceed for route XI9-XC5 (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_XL1) and (not CAN_XL1) and WL_s3_3  # route XL1-XT3 becomes locked (R3)
        CO_R9 = VALID and WP_s3_3 and (not D_s3)  # conditions of proceed for route XL1-XT3 (R3)
        LK_R10 = A_R10 and (not B_R10) and VALID and (not X_XL2) and (not CAN_XL2) and WL_s6_3 and WL_s3_4  # route XL2-XT3 becomes locked (R3)
        CO_R10 = VALID and WP_s6_3 and WP_s3_4 and (not D_s6)  # conditions of proceed for route XL2-XT3 (R3)
        LK_R11 = A_R11 and (not B_R11) and VALID and (not X_XL3) and (not CAN_XL3) and WL_s7_3  # route XL3-XT7 becomes locked (R3)
        CO_R11 = VALID and WP_s7_3 and (not D_s7)  # conditions of proceed for route XL3-XT7 (R3)
        LK_R12 = A_R12 and (not B_R12) and VALID and (not X_XL4) and (not CAN_XL4) and WL_s9_1  # route XL4-XT9 becomes locked (R3)
        CO_R12 = VALID and WP_s9_1 and (not D_s9)  # conditions of proceed for route XL4-XT9 (R3)
        LK_R13 = A_R13 and (not B_R13) and VALID and (not X_XL5) and (not CAN_XL5) and WL_s9_2  # route XL5-XT9 becomes locked (R3)
        CO_R13 = VALID and WP_s9_2 and (not D_s9)  # conditions of proceed for route XL5-XT9 (R3)
        LK_R14 = A_R14 and (not B_R14) and VALID and (not X_XO) and (not CAN_XO) and WL_s2_3  # route XO-W becomes locked (R3)
        CO_R14 = VALID and WP_s2_3 and (not OCC_s1_wait) and (not D_s2)  # conditions of proceed for route XO-W (R3)
        LK_R15 = A_R15 and (not B_R15) and VALID and (not X_XT3) and (not CAN_XT3) and WL_s2_4  # route XT3-W becomes locked (R3)
        CO_R15 = VALID and WP_s2_4 and (not OCC_s1_wait) and (not D_s2)  # conditions of proceed for route XT3-W (R3)
        LK_R16 = A_R16 and (not B_R16) and VALID and (not X_XT7) and (not CAN_XT7) and WL_s6_4 and WL_s3_4  # route XT7-XT3 becomes locked (R3)
        CO_R16 = VALID and WP_s6_4 and WP_s3_4 and (not D_s6)  # conditions of proceed for route XT7-XT3 (R3)
        LK_R17 = A_R17 and (not B_R17) and VALID and (not X_XT9) and (not CAN_XT9) and WL_s7_4  # route XT9-XT7 becomes locked (R3)
        CO_R17 = VALID and WP_s7_4 and (not D_s7)  # conditions of proceed for route XT9-XT7 (R3)
        NU_s10_xc4_2 = VALID and F_s10_xc4 and (not D_s10_xc4) and (not U_s10_xc4) and L_s10_xc4_2 and OCC_s10_xc4 and OCC_s9 and U_s9 and L_s9_3  # a train comes into s10_xc4 at s10_xc4|s9@P4.normal (R9)
        NU_s11_xc5_2 = VALID and F_s11_xc5 and (not D_s11_xc5) and (not U_s11_xc5) and L_s11_xc5_2 and OCC_s11_xc5 and OCC_s9 and U_s9 and L_s9_4  # a train comes into s11_xc5 at s11_xc5|s9@P4.reverse (R9)
        NU_s2_1 = VALID and F_s2 and (not D_s2) and (not U_s2) and (L_s2_1 or L_s2_2) and OCC_s2 and OCC_s1_wait  # a train comes into s2 at W (R9)
        NU_s2_2 = VALID and F_s2 and (not D_s2) and (not U_s2) and L_s2_3 and OCC_s2 and OCC_s2_out  # a train comes into s2 at s2|s2_out@PS.reverse (R9)
        NU_s2_3 = VALID and F_s2 and (not D_s2) and (not U_s2) and L_s2_4 and OCC_s2 and OCC_s3  # a train comes into s2 at s2|s3@PS.normal (R9)
        NU_s2_out_2 = VALID and F_s2_out and (not D_s2_out) and (not U_s2_out) and L_s2_out_2 and OCC_s2_out and OCC_s2 and U_s2 and L_s2_1  # a train comes into s2_out at s2|s2_out@PS.reverse (R9)
        NU_s3_1 = VALID and F_s3 and (not D_s3) and (not U_s3) and (L_s3_1 or L_s3_2) and OCC_s3 and OCC_s2 and U_s2 and L_s2_2  # a train comes into s3 at s2|s3@PS.normal (R9)
        NU_s3_2 = VALID and F_s3 and (not D_s3) and (not U_s3) and L_s3_3 and OCC_s3 and OCC_s4_xc1  # a train comes into s3 at s3|s4_xc1@P1.reverse (R9)
        NU_s3_3 = VALID and F_s3 and (not D_s3) and (not U_s3) and L_s3_4 and OCC_s3 and OCC_s6 and U_s6 and (L_s6_3 or L_s6_4)  # a train comes into s3 at s3|s6@P1.normal (R9)
        NU_s4_xc1_2 = VALID and F_s4_xc1 and (not D_s4_xc1) and (not U_s4_xc1) and L_s4_xc1_2 and OCC_s4_xc1 and OCC_s3 and U_s3 and L_s3_1  # a train comes into s4_xc1 at s3|s4_xc1@P1.reverse (R9)
        NU_s5_xc2_2 = VALID and F_s5_xc2 and (not D_s5_xc2) and (not U_s5_xc2) and L_s5_xc2_2 and OCC_s5_xc2 and OCC_s6 and U_s6 and L_s6_1  # a train comes into s5_xc2 at s5_xc2|s6@P2.reverse (R9)
        NU_s6_1 = VALID and F_s6 and (not D_s6) and (not U_s6) and (L_s6_1 or L_s6_2) and OCC_s6 and OCC_s3 and U_s3 and L_s3_2  # a train comes into s6 at s3|s6@P1.normal (R9)
        NU_s6_2 = VALID and F_s6 and (not D_s6) and (not U_s6) and L_s6_3 and OCC_s6 and OCC_s5_xc2  # a train comes into s6 at s5_xc2|s6@P2.reverse (R9)
        NU_s6_3 = VALID and F_s6 and (not D_s6) and (not U_s6) and L_s6_4 and OCC_s6 and OCC_s7  # a train comes into s6 at s6|s7@P2.normal (R9)
        NU_s7_1 = VALID and F_s7 and (not D_s7) and (not U_s7) and (L_s7_1 or L_s7_2) and OCC_s7 and OCC_s6  # a train comes into s7 at s6|s7@P2.normal (R9)
        NU_s7_2 = VALID and F_s7 and (not D_s7) and (not U_s7) and L_s7_3 and OCC_s7 and OCC_s8_xc3  # a train comes into s7 at s7|s8_xc3@P3.reverse (R9)
        NU_s7_3 = VALID and F_s7 and (not D_s7) and (not U_s7) and L_s7_4 and OCC_s7 and OCC_s9  # a train comes into s7 at s7|s9@P3.normal (R9)
        NU_s8_xc3_2 = VALID and F_s8_xc3 and (not D_s8_xc3) and (not U_s8_xc3) and L_s8_xc3_2 and OCC_s8_xc3 and OCC_s7 and U_s7 and L_s7_1  # a train comes into s8_xc3 at s7|s8_xc3@P3.reverse (R9)
        NU_s9_1 = VALID and F_s9 and (not D_s9) and (not U_s9) and L_s9_1 and OCC_s9 and OCC_s10_xc4  # a train comes into s9 at s10_xc4|s9@P4.normal (R9)
        NU_s9_2 = VALID and F_s9 and (not D_s9) and (not U_s9) and L_s9_2 and OCC_s9 and OCC_s11_xc5  # a train comes into s9 at s11_xc5|s9@P4.reverse (R9)
        NU_s9_3 = VALID and F_s9 and (not D_s9) and (not U_s9) and (L_s9_3 or L_s9_4) and OCC_s9 and OCC_s7  # a train comes into s9 at s7|s9@P3.normal (R9)
        ATI_XB = X_XB or ((not (A_R1 or A_R2 or A_R3 or A_R4)) and (L_s2_1 or L_s2_2) and REL_s2)  # XB at stop, waiting for a train that may still come (R8)
        ATI_XI7 = X_XI7 or ((not (A_R5 or A_R6)) and (L_s7_1 or L_s7_2) and REL_s7)  # XI7 at stop, waiting for a train that may still come (R8)
        ATI_XI9 = X_XI9 or ((not (A_R7 or A_R8)) and (L_s9_3 or L_s9_4) and REL_s9)  # XI9 at stop, waiting for a train that may still come (R8)
        ATI_XL1 = X_XL1 or ((not A_R9) and L_s3_3 and REL_s3)  # XL1 at stop, waiting for a train that may still come (R8)
        ATI_XL2 = X_XL2 or ((not A_R10) and L_s6_3 and REL_s6)  # XL2 at stop, waiting for a train that may still come (R8)
        ATI_XL3 = X_XL3 or ((not A_R11) and L_s7_3 and REL_s7)  # XL3 at stop, waiting for a train that may still come (R8)
        ATI_XL4 = X_XL4 or ((not A_R12) and L_s9_1 and REL_s9)  # XL4 at stop, waiting for a train that may still come (R8)
        ATI_XL5 = X_XL5 or ((not A_R13) and L_s9_2 and REL_s9)  # XL5 at stop, waiting for a train that may still come (R8)
        ATI_XO = X_XO or ((not A_R14) and L_s2_3 and (REL_s2 or (L_s2_3 and U_s2 and (not OCC_s2))))  # XO at stop, waiting for a train that may still come (R8)
        ATI_XT3 = X_XT3 or ((not A_R15) and L_s2_4 and (REL_s2 or (L_s2_4 and U_s2 and (not OCC_s2))))  # XT3 at stop, waiting for a train that may still come (R8)
        ATI_XT7 = X_XT7 or ((not A_R16) and L_s6_4 and REL_s6)  # XT7 at stop, waiting for a train that may still come (R8)
        ATI_XT9 = X_XT9 or ((not A_R17) and L_s7_4 and REL_s7)  # XT9 at stop, waiting for a train that may still come (R8)
        AT_XB = self._timer('AT_XB', ATI_XB, dt_ms)  # XB: approach locking delay (R8)
        AT_XI7 = self._timer('AT_XI7', ATI_XI7, dt_ms)  # XI7: approach locking delay (R8)
        AT_XI9 = self._timer('AT_XI9', ATI_XI9, dt_ms)  # XI9: approach locking delay (R8)
        AT_XL1 = self._timer('AT_XL1', ATI_XL1, dt_ms)  # XL1: approach locking delay (R8)
        AT_XL2 = self._timer('AT_XL2', ATI_XL2, dt_ms)  # XL2: approach locking delay (R8)
        AT_XL3 = self._timer('AT_XL3', ATI_XL3, dt_ms)  # XL3: approach locking delay (R8)
        AT_XL4 = self._timer('AT_XL4', ATI_XL4, dt_ms)  # XL4: approach locking delay (R8)
        AT_XL5 = self._timer('AT_XL5', ATI_XL5, dt_ms)  # XL5: approach locking delay (R8)
        AT_XO = self._timer('AT_XO', ATI_XO, dt_ms)  # XO: approach locking delay (R8)
        AT_XT3 = self._timer('AT_XT3', ATI_XT3, dt_ms)  # XT3: approach locking delay (R8)
        AT_XT7 = self._timer('AT_XT7', ATI_XT7, dt_ms)  # XT7: approach locking delay (R8)
        AT_XT9 = self._timer('AT_XT9', ATI_XT9, dt_ms)  # XT9: approach locking delay (R8)
        CD_XB = X_XB and (A_R1 or A_R2 or A_R3 or A_R4) and VALID and (not OCC_s2) and ((not OCC_s1_wait) or AT_XB or (not (H_R1 or H_R2 or H_R3 or H_R4)))  # the route from XB is cancelled (R8)
        CD_XI7 = X_XI7 and (A_R5 or A_R6) and VALID and (not OCC_s7) and ((not OCC_s6) or AT_XI7 or (not (H_R5 or H_R6)))  # the route from XI7 is cancelled (R8)
        CD_XI9 = X_XI9 and (A_R7 or A_R8) and VALID and (not OCC_s9) and ((not OCC_s7) or AT_XI9 or (not (H_R7 or H_R8)))  # the route from XI9 is cancelled (R8)
        CD_XL1 = X_XL1 and A_R9 and VALID and (not OCC_s3) and ((not OCC_s4_xc1) or AT_XL1 or (not H_R9))  # the route from XL1 is cancelled (R8)
        CD_XL2 = X_XL2 and A_R10 and VALID and (not OCC_s6) and ((not OCC_s5_xc2) or AT_XL2 or (not H_R10))  # the route from XL2 is cancelled (R8)
        CD_XL3 = X_XL3 and A_R11 and VALID and (not OCC_s7) and ((not OCC_s8_xc3) or AT_XL3 or (not H_R11))  # the route from XL3 is cancelled (R8)
        CD_XL4 = X_XL4 and A_R12 and VALID and (not OCC_s9) and ((not OCC_s10_xc4) or AT_XL4 or (not H_R12))  # the route from XL4 is cancelled (R8)
        CD_XL5 = X_XL5 and A_R13 and VALID and (not OCC_s9) and ((not OCC_s11_xc5) or AT_XL5 or (not H_R13))  # the route from XL5 is cancelled (R8)
        CD_XO = X_XO and A_R14 and VALID and (not OCC_s2) and ((not OCC_s2_out) or AT_XO or (not H_R14))  # the route from XO is cancelled (R8)
        CD_XT3 = X_XT3 and A_R15 and VALID and (not OCC_s2) and ((not OCC_s3) or AT_XT3 or (not H_R15))  # the route from XT3 is cancelled (R8)
        CD_XT7 = X_XT7 and A_R16 and VALID and (not OCC_s6) and ((not OCC_s7) or AT_XT7 or (not H_R16))  # the route from XT7 is cancelled (R8)
        CD_XT9 = X_XT9 and A_R17 and VALID and (not OCC_s7) and ((not OCC_s9) or AT_XT9 or (not H_R17))  # the route from XT9 is cancelled (R8)
        EX_s10_xc4 = P_s10_xc4  # a train in s10_xc4 leaves over a boundary, or has passed on
        RTI_s10_xc4 = VALID and U_s10_xc4 and (not OCC_s10_xc4) and (not (L_s10_xc4_2 and L_s9_3)) and EX_s10_xc4  # s10_xc4 may be released behind the train (R9)
        EX_s11_xc5 = P_s11_xc5  # a train in s11_xc5 leaves over a boundary, or has passed on
        RTI_s11_xc5 = VALID and U_s11_xc5 and (not OCC_s11_xc5) and (not (L_s11_xc5_2 and L_s9_4)) and EX_s11_xc5  # s11_xc5 may be released behind the train (R9)
        EX_s2 = P_s2 or (L_s2_3 and ((not OCC_s2_out) or AT_XO)) or (L_s2_4 and ((not OCC_s3) or AT_XT3))  # a train in s2 leaves over a boundary, or has passed on
        RTI_s2 = VALID and U_s2 and (not OCC_s2) and EX_s2  # s2 may be released behind the train (R9)
        EX_s2_out = P_s2_out or L_s2_out_2  # a train in s2_out leaves over a boundary, or has passed on
        RTI_s2_out = VALID and U_s2_out and (not OCC_s2_out) and (not (L_s2_out_2 and L_s2_1)) and EX_s2_out  # s2_out may be released behind the train (R9)
        EX_s3 = P_s3  # a train in s3 leaves over a boundary, or has passed on
        RTI_s3 = VALID and U_s3 and (not OCC_s3) and (not ((L_s3_1 or L_s3_2) and L_s2_2)) and (not (L_s3_4 and (L_s6_3 or L_s6_4))) and EX_s3  # s3 may be released behind the train (R9)
        EX_s4_xc1 = P_s4_xc1  # a train in s4_xc1 leaves over a boundary, or has passed on
        RTI_s4_xc1 = VALID and U_s4_xc1 and (not OCC_s4_xc1) and (not (L_s4_xc1_2 and L_s3_1)) and EX_s4_xc1  # s4_xc1 may be released behind the train (R9)
        EX_s5_xc2 = P_s5_xc2  # a train in s5_xc2 leaves over a boundary, or has passed on
        RTI_s5_xc2 = VALID and U_s5_xc2 and (not OCC_s5_xc2) and (not (L_s5_xc2_2 and L_s6_1)) and EX_s5_xc2  # s5_xc2 may be released behind the train (R9)
        EX_s6 = P_s6  # a train in s6 leaves over a boundary, or has passed on
        RTI_s6 = VALID and U_s6 and (not OCC_s6) and (not ((L_s6_1 or L_s6_2) and L_s3_2)) and EX_s6  # s6 may be released behind the train (R9)
        EX_s7 = P_s7  # a train in s7 leaves over a boundary, or has passed on
        RTI_s7 = VALID and U_s7 and (not OCC_s7) and EX_s7  # s7 may be released behind the train (R9)
        EX_s8_xc3 = P_s8_xc3  # a train in s8_xc3 leaves over a boundary, or has passed on
        RTI_s8_xc3 = VALID and U_s8_xc3 and (not OCC_s8_xc3) and (not (L_s8_xc3_2 and L_s7_1)) and EX_s8_xc3  # s8_xc3 may be released behind the train (R9)
        EX_s9 = P_s9  # a train in s9 leaves over a boundary, or has passed on
        RTI_s9 = VALID and U_s9 and (not OCC_s9) and EX_s9  # s9 may be released behind the train (R9)
        RT_s10_xc4 = self._timer('RT_s10_xc4', RTI_s10_xc4, dt_ms)  # s10_xc4: release delay (R9)
        RT_s11_xc5 = self._timer('RT_s11_xc5', RTI_s11_xc5, dt_ms)  # s11_xc5: release delay (R9)
        RT_s2 = self._timer('RT_s2', RTI_s2, dt_ms)  # s2: release delay (R9)
        RT_s2_out = self._timer('RT_s2_out', RTI_s2_out, dt_ms)  # s2_out: release delay (R9)
        RT_s3 = self._timer('RT_s3', RTI_s3, dt_ms)  # s3: release delay (R9)
        RT_s4_xc1 = self._timer('RT_s4_xc1', RTI_s4_xc1, dt_ms)  # s4_xc1: release delay (R9)
        RT_s5_xc2 = self._timer('RT_s5_xc2', RTI_s5_xc2, dt_ms)  # s5_xc2: release delay (R9)
        RT_s6 = self._timer('RT_s6', RTI_s6, dt_ms)  # s6: release delay (R9)
        RT_s7 = self._timer('RT_s7', RTI_s7, dt_ms)  # s7: release delay (R9)
        RT_s8_xc3 = self._timer('RT_s8_xc3', RTI_s8_xc3, dt_ms)  # s8_xc3: release delay (R9)
        RT_s9 = self._timer('RT_s9', RTI_s9, dt_ms)  # s9: release delay (R9)
        CA_s10_xc4 = VALID and (not OCC_s10_xc4) and (not U_s10_xc4) and L_s10_xc4_2 and (not (L_s10_xc4_2 and L_s9_3))  # the lock before s10_xc4 was withdrawn (R8)
        HR_s10_xc4 = VALID and (not OCC_s10_xc4) and (not (L_s10_xc4_2 and L_s9_3)) and REL_s10_xc4 and L_s10_xc4_2  # s10_xc4 released by hand (R8, section fault release)
        SR_s10_xc4 = VALID and (not OCC_s10_xc4) and K_s10_xc4 and (REL_s10_xc4 or RELALL)  # s10_xc4 released after a restart (R16)
        RLS_s10_xc4 = RT_s10_xc4 or CA_s10_xc4 or HR_s10_xc4 or SR_s10_xc4  # s10_xc4 is released
        CA_s11_xc5 = VALID and (not OCC_s11_xc5) and (not U_s11_xc5) and L_s11_xc5_2 and (not (L_s11_xc5_2 and L_s9_4))  # the lock before s11_xc5 was withdrawn (R8)
        HR_s11_xc5 = VALID and (not OCC_s11_xc5) and (not (L_s11_xc5_2 and L_s9_4)) and REL_s11_xc5 and L_s11_xc5_2  # s11_xc5 released by hand (R8, section fault release)
        SR_s11_xc5 = VALID and (not OCC_s11_xc5) and K_s11_xc5 and (REL_s11_xc5 or RELALL)  # s11_xc5 released after a restart (R16)
        RLS_s11_xc5 = RT_s11_xc5 or CA_s11_xc5 or HR_s11_xc5 or SR_s11_xc5  # s11_xc5 is released
        CA_s2 = VALID and (not OCC_s2) and (not U_s2) and False  # the lock before s2 was withdrawn (R8)
        HR_s2 = VALID and (not OCC_s2) and REL_s2 and (L_s2_1 or L_s2_2 or L_s2_3 or L_s2_4) and ((not (L_s2_1 or L_s2_2)) or ((not (A_R1 or A_R2 or A_R3 or A_R4)) and ((not OCC_s1_wait) or AT_XB))) and ((not L_s2_3) or ((not A_R14) and ((not OCC_s2_out) or AT_XO))) and ((not L_s2_4) or ((not A_R15) and ((not OCC_s3) or AT_XT3)))  # s2 released by hand (R8, section fault release)
        SR_s2 = VALID and (not OCC_s2) and K_s2 and (REL_s2 or RELALL)  # s2 released after a restart (R16)
        RLS_s2 = RT_s2 or CA_s2 or CD_XB or CD_XO or CD_XT3 or HR_s2 or SR_s2  # s2 is released
        CA_s2_out = VALID and (not OCC_s2_out) and (not U_s2_out) and L_s2_out_2 and (not (L_s2_out_2 and L_s2_1))  # the lock before s2_out was withdrawn (R8)
        HR_s2_out = VALID and (not OCC_s2_out) and (not (L_s2_out_2 and L_s2_1)) and REL_s2_out and L_s2_out_2  # s2_out released by hand (R8, section fault release)
        SR_s2_out = VALID and (not OCC_s2_out) and K_s2_out and (REL_s2_out or RELALL)  # s2_out released after a restart (R16)
        RLS_s2_out = RT_s2_out or CA_s2_out or HR_s2_out or SR_s2_out  # s2_out is released
        CA_s3 = VALID and (not OCC_s3) and (not U_s3) and (L_s3_1 or L_s3_2 or L_s3_4) and (not ((L_s3_1 or L_s3_2) and L_s2_2)) and (not (L_s3_4 and (L_s6_3 or L_s6_4)))  # the lock before s3 was withdrawn (R8)
        HR_s3 = VALID and (not OCC_s3) and (not ((L_s3_1 or L_s3_2) and L_s2_2)) and (not (L_s3_4 and (L_s6_3 or L_s6_4))) and REL_s3 and (L_s3_1 or L_s3_2 or L_s3_3 or L_s3_4) and ((not L_s3_3) or ((not A_R9) and ((not OCC_s4_xc1) or AT_XL1)))  # s3 released by hand (R8, section fault release)
        SR_s3 = VALID and (not OCC_s3) and K_s3 and (REL_s3 or RELALL)  # s3 released after a restart (R16)
        RLS_s3 = RT_s3 or CA_s3 or CD_XL1 or HR_s3 or SR_s3  # s3 is released
        CA_s4_xc1 = VALID and (not OCC_s4_xc1) and (not U_s4_xc1) and L_s4_xc1_2 and (not (L_s4_xc1_2 and L_s3_1))  # the lock before s4_xc1 was withdrawn (R8)
        HR_s4_xc1 = VALID and (not OCC_s4_xc1) and (not (L_s4_xc1_2 and L_s3_1)) and REL_s4_xc1 and L_s4_xc1_2  # s4_xc1 released by hand (R8, section fault release)
        SR_s4_xc1 = VALID and (not OCC_s4_xc1) and K_s4_xc1 and (REL_s4_xc1 or RELALL)  # s4_xc1 released after a restart (R16)
        RLS_s4_xc1 = RT_s4_xc1 or CA_s4_xc1 or HR_s4_xc1 or SR_s4_xc1  # s4_xc1 is released
        CA_s5_xc2 = VALID and (not OCC_s5_xc2) and (not U_s5_xc2) and L_s5_xc2_2 and (not (L_s5_xc2_2 and L_s6_1))  # the lock before s5_xc2 was withdrawn (R8)
        HR_s5_xc2 = VALID and (not OCC_s5_xc2) and (not (L_s5_xc2_2 and L_s6_1)) and REL_s5_xc2 and L_s5_xc2_2  # s5_xc2 released by hand (R8, section fault release)
        SR_s5_xc2 = VALID and (not OCC_s5_xc2) and K_s5_xc2 and (REL_s5_xc2 or RELALL)  # s5_xc2 released after a restart (R16)
        RLS_s5_xc2 = RT_s5_xc2 or CA_s5_xc2 or HR_s5_xc2 or SR_s5_xc2  # s5_xc2 is released
        CA_s6 = VALID and (not OCC_s6) and (not U_s6) and (L_s6_1 or L_s6_2) and (not ((L_s6_1 or L_s6_2) and L_s3_2))  # the lock before s6 was withdrawn (R8)
        HR_s6 = VALID and (not OCC_s6) and (not ((L_s6_1 or L_s6_2) and L_s3_2)) and REL_s6 and (L_s6_1 or L_s6_2 or L_s6_3 or L_s6_4) and ((not L_s6_3) or ((not A_R10) and ((not OCC_s5_xc2) or AT_XL2))) and ((not L_s6_4) or ((not A_R16) and ((not OCC_s7) or AT_XT7)))  # s6 released by hand (R8, section fault release)
        SR_s6 = VALID and (not OCC_s6) and K_s6 and (REL_s6 or RELALL)  # s6 released after a restart (R16)
        RLS_s6 = RT_s6 or CA_s6 or CD_XL2 or CD_XT7 or HR_s6 or SR_s6  # s6 is released
        CA_s7 = VALID and (not OCC_s7) and (not U_s7) and False  # the lock before s7 was withdrawn (R8)
        HR_s7 = VALID and (not OCC_s7) and REL_s7 and (L_s7_1 or L_s7_2 or L_s7_3 or L_s7_4) and ((not (L_s7_1 or L_s7_2)) or ((not (A_R5 or A_R6)) and ((not OCC_s6) or AT_XI7))) and ((not L_s7_3) or ((not A_R11) and ((not OCC_s8_xc3) or AT_XL3))) and ((not L_s7_4) or ((not A_R17) and ((not OCC_s9) or AT_XT9)))  # s7 released by hand (R8, section fault release)
        SR_s7 = VALID and (not OCC_s7) and K_s7 and (REL_s7 or RELALL)  # s7 released after a restart (R16)
        RLS_s7 = RT_s7 or CA_s7 or CD_XI7 or CD_XL3 or CD_XT9 or HR_s7 or SR_s7  # s7 is released
        CA_s8_xc3 = VALID and (not OCC_s8_xc3) and (not U_s8_xc3) and L_s8_xc3_2 and (not (L_s8_xc3_2 and L_s7_1))  # the lock before s8_xc3 was withdrawn (R8)
        HR_s8_xc3 = VALID and (not OCC_s8_xc3) and (not (L_s8_xc3_2 and L_s7_1)) and REL_s8_xc3 and L_s8_xc3_2  # s8_xc3 released by hand (R8, section fault release)
        SR_s8_xc3 = VALID and (not OCC_s8_xc3) and K_s8_xc3 and (REL_s8_xc3 or RELALL)  # s8_xc3 released after a restart (R16)
        RLS_s8_xc3 = RT_s8_xc3 or CA_s8_xc3 or HR_s8_xc3 or SR_s8_xc3  # s8_xc3 is released
        CA_s9 = VALID and (not OCC_s9) and (not U_s9) and False  # the lock before s9 was withdrawn (R8)
        HR_s9 = VALID and (not OCC_s9) and REL_s9 and (L_s9_1 or L_s9_2 or L_s9_3 or L_s9_4) and ((not L_s9_1) or ((not A_R12) and ((not OCC_s10_xc4) or AT_XL4))) and ((not L_s9_2) or ((not A_R13) and ((not OCC_s11_xc5) or AT_XL5))) and ((not (L_s9_3 or L_s9_4)) or ((not (A_R7 or A_R8)) and ((not OCC_s7) or AT_XI9)))  # s9 released by hand (R8, section fault release)
        SR_s9 = VALID and (not OCC_s9) and K_s9 and (REL_s9 or RELALL)  # s9 released after a restart (R16)
        RLS_s9 = RT_s9 or CA_s9 or CD_XL4 or CD_XL5 or CD_XI9 or HR_s9 or SR_s9  # s9 is released
        TG_P1 = (GW_s3_1 or GW_s3_2 or GW_s3_3 or GW_s3_4)  # a grant touches machine P1 in this scan
        GPN_P1 = (GW_s3_2 or GW_s3_4)  # a grant needs P1 N
        MAN_P1 = MN_P1 and (not MR_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved N by hand
        GPR_P1 = (GW_s3_1 or GW_s3_3)  # a grant needs P1 R
        MAR_P1 = MR_P1 and (not MN_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved R by hand
        HDN_P1 = CN_P1 and (not GPR_P1) and (not MAR_P1)  # the command N stays
        HDR_P1 = CR_P1 and (not GPN_P1) and (not MAN_P1)  # the command R stays
        TG_P2 = (GW_s6_1 or GW_s6_2 or GW_s6_3 or GW_s6_4)  # a grant touches machine P2 in this scan
        GPN_P2 = (GW_s6_2 or GW_s6_4)  # a grant needs P2 N
        MAN_P2 = MN_P2 and (not MR_P2) and MOV_P2 and (not TG_P2)  # machine P2 moved N by hand
        GPR_P2 = (GW_s6_1 or GW_s6_3)  # a grant needs P2 R
        MAR_P2 = MR_P2 and (not MN_P2) and MOV_P2 and (not TG_P2)  # machine P2 moved R by hand
        HDN_P2 = CN_P2 and (not GPR_P2) and (not MAR_P2)  # the command N stays
        HDR_P2 = CR_P2 and (not GPN_P2) and (not MAN_P2)  # the command R stays
        TG_P3 = (GW_s7_1 or GW_s7_2 or GW_s7_3 or GW_s7_4)  # a grant touches machine P3 in this scan
        GPN_P3 = (GW_s7_2 or GW_s7_4)  # a grant needs P3 N
        MAN_P3 = MN_P3 and (not MR_P3) and MOV_P3 and (not TG_P3)  # machine P3 moved N by hand
        GPR_P3 = (GW_s7_1 or GW_s7_3)  # a grant needs P3 R
        MAR_P3 = MR_P3 and (not MN_P3) and MOV_P3 and (not TG_P3)  # machine P3 moved R by hand
        HDN_P3 = CN_P3 and (not GPR_P3) and (not MAR_P3)  # the command N stays
        HDR_P3 = CR_P3 and (not GPN_P3) and (not MAN_P3)  # the command R stays
        TG_P4 = (GW_s9_1 or GW_s9_2 or GW_s9_3 or GW_s9_4)  # a grant touches machine P4 in this scan
        GPN_P4 = (GW_s9_1 or GW_s9_3)  # a grant needs P4 N
        MAN_P4 = MN_P4 and (not MR_P4) and MOV_P4 and (not TG_P4)  # machine P4 moved N by hand
        GPR_P4 = (GW_s9_2 or GW_s9_4)  # a grant needs P4 R
        MAR_P4 = MR_P4 and (not MN_P4) and MOV_P4 and (not TG_P4)  # machine P4 moved R by hand
        HDN_P4 = CN_P4 and (not GPR_P4) and (not MAR_P4)  # the command N stays
        HDR_P4 = CR_P4 and (not GPN_P4) and (not MAN_P4)  # the command R stays
        TG_PS = (GW_s2_1 or GW_s2_2 or GW_s2_3 or GW_s2_4)  # a grant touches machine PS in this scan
        GPN_PS = (GW_s2_2 or GW_s2_4)  # a grant needs PS N
        MAN_PS = MN_PS and (not MR_PS) and MOV_PS and (not TG_PS)  # machine PS moved N by hand
        GPR_PS = (GW_s2_1 or GW_s2_3)  # a grant needs PS R
        MAR_PS = MR_PS and (not MN_PS) and MOV_PS and (not TG_PS)  # machine PS moved R by hand
        HDN_PS = CN_PS and (not GPR_PS) and (not MAR_PS)  # the command N stays
        HDR_PS = CR_PS and (not GPN_PS) and (not MAN_PS)  # the command R stays
        STI_P1 = (CN_P1 and (not QN_P1)) or (CR_P1 and (not QR_P1))  # machine P1 is not where it was commanded
        STI_P2 = (CN_P2 and (not QN_P2)) or (CR_P2 and (not QR_P2))  # machine P2 is not where it was commanded
        STI_P3 = (CN_P3 and (not QN_P3)) or (CR_P3 and (not QR_P3))  # machine P3 is not where it was commanded
        STI_P4 = (CN_P4 and (not QN_P4)) or (CR_P4 and (not QR_P4))  # machine P4 is not where it was commanded
        STI_PS = (CN_PS and (not QN_PS)) or (CR_PS and (not QR_PS))  # machine PS is not where it was commanded
        ST_P1 = self._timer('ST_P1', STI_P1, dt_ms)  # machine P1: time-out
        ST_P2 = self._timer('ST_P2', STI_P2, dt_ms)  # machine P2: time-out
        ST_P3 = self._timer('ST_P3', STI_P3, dt_ms)  # machine P3: time-out
        ST_P4 = self._timer('ST_P4', STI_P4, dt_ms)  # machine P4: time-out
        ST_PS = self._timer('ST_PS', STI_PS, dt_ms)  # machine PS: time-out
        KP_R1 = (not NU_s2_1) and (not CD_XB)  # route XB-OUT stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_XB) and (not CAN_XB)  # proceed for route XB-OUT (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route XB-OUT: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_s2_1) and (not CD_XB)  # route XB-XC1 stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_XB) and (not CAN_XB)  # proceed for route XB-XC1 (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route XB-XC1: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_s2_1) and (not CD_XB)  # route XB-XC2 stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_XB) and (not CAN_XB)  # proceed for route XB-XC2 (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route XB-XC2: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_s2_1) and (not CD_XB)  # route XB-XI7 stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_XB) and (not CAN_XB)  # proceed for route XB-XI7 (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route XB-XI7: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_s7_1) and (not CD_XI7)  # route XI7-XC3 stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_XI7) and (not CAN_XI7)  # proceed for route XI7-XC3 (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route XI7-XC3: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_s7_1) and (not CD_XI7)  # route XI7-XI9 stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_XI7) and (not CAN_XI7)  # proceed for route XI7-XI9 (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route XI7-XI9: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_s9_3) and (not CD_XI9)  # route XI9-XC4 stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_XI9) and (not CAN_XI9)  # proceed for route XI9-XC4 (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route XI9-XC4: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_s9_3) and (not CD_XI9)  # route XI9-XC5 stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_XI9) and (not CAN_XI9)  # proceed for route XI9-XC5 (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route XI9-XC5: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_s3_2) and (not CD_XL1)  # route XL1-XT3 stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_XL1) and (not CAN_XL1)  # proceed for route XL1-XT3 (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route XL1-XT3: a condition was lost; no reopening by itself (R14)
        KP_R10 = (not NU_s6_2) and (not CD_XL2)  # route XL2-XT3 stays set
        PR_R10 = A_R10 and B_R10 and W_R10 and CO_R10 and KP_R10 and (not X_XL2) and (not CAN_XL2)  # proceed for route XL2-XT3 (R3, R11)
        LS_R10 = S_R10 and (not CO_R10)  # route XL2-XT3: a condition was lost; no reopening by itself (R14)
        KP_R11 = (not NU_s7_2) and (not CD_XL3)  # route XL3-XT7 stays set
        PR_R11 = A_R11 and B_R11 and W_R11 and CO_R11 and KP_R11 and (not X_XL3) and (not CAN_XL3)  # proceed for route XL3-XT7 (R3, R11)
        LS_R11 = S_R11 and (not CO_R11)  # route XL3-XT7: a condition was lost; no reopening by itself (R14)
        KP_R12 = (not NU_s9_1) and (not CD_XL4)  # route XL4-XT9 stays set
        PR_R12 = A_R12 and B_R12 and W_R12 and CO_R12 and KP_R12 and (not X_XL4) and (not CAN_XL4)  # proceed for route XL4-XT9 (R3, R11)
        LS_R12 = S_R12 and (not CO_R12)  # route XL4-XT9: a condition was lost; no reopening by itself (R14)
        KP_R13 = (not NU_s9_2) and (not CD_XL5)  # route XL5-XT9 stays set
        PR_R13 = A_R13 and B_R13 and W_R13 and CO_R13 and KP_R13 and (not X_XL5) and (not CAN_XL5)  # proceed for route XL5-XT9 (R3, R11)
        LS_R13 = S_R13 and (not CO_R13)  # route XL5-XT9: a condition was lost; no reopening by itself (R14)
        KP_R14 = (not NU_s2_2) and (not CD_XO)  # route XO-W stays set
        PR_R14 = A_R14 and B_R14 and W_R14 and CO_R14 and KP_R14 and (not X_XO) and (not CAN_XO)  # proceed for route XO-W (R3, R11)
        LS_R14 = S_R14 and (not CO_R14)  # route XO-W: a condition was lost; no reopening by itself (R14)
        KP_R15 = (not NU_s2_3) and (not CD_XT3)  # route XT3-W stays set
        PR_R15 = A_R15 and B_R15 and W_R15 and CO_R15 and KP_R15 and (not X_XT3) and (not CAN_XT3)  # proceed for route XT3-W (R3, R11)
        LS_R15 = S_R15 and (not CO_R15)  # route XT3-W: a condition was lost; no reopening by itself (R14)
        KP_R16 = (not NU_s6_3) and (not CD_XT7)  # route XT7-XT3 stays set
        PR_R16 = A_R16 and B_R16 and W_R16 and CO_R16 and KP_R16 and (not X_XT7) and (not CAN_XT7)  # proceed for route XT7-XT3 (R3, R11)
        LS_R16 = S_R16 and (not CO_R16)  # route XT7-XT3: a condition was lost; no reopening by itself (R14)
        KP_R17 = (not NU_s7_3) and (not CD_XT9)  # route XT9-XT7 stays set
        PR_R17 = A_R17 and B_R17 and W_R17 and CO_R17 and KP_R17 and (not X_XT9) and (not CAN_XT9)  # proceed for route XT9-XT7 (R3, R11)
        LS_R17 = S_R17 and (not CO_R17)  # route XT9-XT7: a condition was lost; no reopening by itself (R14)
        N_CN_P1 = GPN_P1 or MAN_P1 or HDN_P1  # machine P1 commanded N
        N_CR_P1 = GPR_P1 or MAR_P1 or HDR_P1  # machine P1 commanded R
        N_CN_P2 = GPN_P2 or MAN_P2 or HDN_P2  # machine P2 commanded N
        N_CR_P2 = GPR_P2 or MAR_P2 or HDR_P2  # machine P2 commanded R
        N_CN_P3 = GPN_P3 or MAN_P3 or HDN_P3  # machine P3 commanded N
        N_CR_P3 = GPR_P3 or MAR_P3 or HDR_P3  # machine P3 commanded R
        N_CN_P4 = GPN_P4 or MAN_P4 or HDN_P4  # machine P4 commanded N
        N_CR_P4 = GPR_P4 or MAR_P4 or HDR_P4  # machine P4 commanded R
        N_CN_PS = GPN_PS or MAN_PS or HDN_PS  # machine PS commanded N
        N_CR_PS = GPR_PS or MAR_PS or HDR_PS  # machine PS commanded R
        N_AL_P1 = ST_P1  # alarm: machine P1 not detected
        N_AL_P2 = ST_P2  # alarm: machine P2 not detected
        N_AL_P3 = ST_P3  # alarm: machine P3 not detected
        N_AL_P4 = ST_P4  # alarm: machine P4 not detected
        N_AL_PS = ST_PS  # alarm: machine PS not detected
        N_TH_P1 = ((CN_P1 and QN_P1) or (CR_P1 and QR_P1)) and (not (GPN_P1 or GPR_P1 or MAN_P1 or MAR_P1))  # machine P1 was detected where it is commanded
        N_TR_P1 = (TH_P1 and VALID and ((CN_P1 and (not QN_P1) and (not GPR_P1) and (not MAR_P1)) or (CR_P1 and (not QR_P1) and (not GPN_P1) and (not MAN_P1)))) or (TR_P1 and (not (TC_P1 and VALID and (not OCC_s3))))  # machine P1 was trailed
        N_TH_P2 = ((CN_P2 and QN_P2) or (CR_P2 and QR_P2)) and (not (GPN_P2 or GPR_P2 or MAN_P2 or MAR_P2))  # machine P2 was detected where it is commanded
        N_TR_P2 = (TH_P2 and VALID and ((CN_P2 and (not QN_P2) and (not GPR_P2) and (not MAR_P2)) or (CR_P2 and (not QR_P2) and (not GPN_P2) and (not MAN_P2)))) or (TR_P2 and (not (TC_P2 and VALID and (not OCC_s6))))  # machine P2 was trailed
        N_TH_P3 = ((CN_P3 and QN_P3) or (CR_P3 and QR_P3)) and (not (GPN_P3 or GPR_P3 or MAN_P3 or MAR_P3))  # machine P3 was detected where it is commanded
        N_TR_P3 = (TH_P3 and VALID and ((CN_P3 and (not QN_P3) and (not GPR_P3) and (not MAR_P3)) or (CR_P3 and (not QR_P3) and (not GPN_P3) and (not MAN_P3)))) or (TR_P3 and (not (TC_P3 and VALID and (not OCC_s7))))  # machine P3 was trailed
        N_TH_P4 = ((CN_P4 and QN_P4) or (CR_P4 and QR_P4)) and (not (GPN_P4 or GPR_P4 or MAN_P4 or MAR_P4))  # machine P4 was detected where it is commanded
        N_TR_P4 = (TH_P4 and VALID and ((CN_P4 and (not QN_P4) and (not GPR_P4) and (not MAR_P4)) or (CR_P4 and (not QR_P4) and (not GPN_P4) and (not MAN_P4)))) or (TR_P4 and (not (TC_P4 and VALID and (not OCC_s9))))  # machine P4 was trailed
        N_TH_PS = ((CN_PS and QN_PS) or (CR_PS and QR_PS)) and (not (GPN_PS or GPR_PS or MAN_PS or MAR_PS))  # machine PS was detected where it is commanded
        N_TR_PS = (TH_PS and VALID and ((CN_PS and (not QN_PS) and (not GPR_PS) and (not MAR_PS)) or (CR_PS and (not QR_PS) and (not GPN_PS) and (not MAN_PS)))) or (TR_PS and (not (TC_PS and VALID and (not OCC_s2))))  # machine PS was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route XB-OUT active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route XB-OUT locked
        N_W_R1 = (W_R1 or LK_R1 or (((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and B_R1)) and (not LS_R1) and KP_R1 and (not X_XB) and (not CAN_XB)  # route XB-OUT: proceed wanted
        N_S_R1 = PR_R1  # route XB-OUT: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route XB-OUT: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route XB-XC1 active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route XB-XC1 locked
        N_W_R2 = (W_R2 or LK_R2 or (((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) and B_R2)) and (not LS_R2) and KP_R2 and (not X_XB) and (not CAN_XB)  # route XB-XC1: proceed wanted
        N_S_R2 = PR_R2  # route XB-XC1: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route XB-XC1: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route XB-XC2 active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route XB-XC2 locked
        N_W_R3 = (W_R3 or LK_R3 or (((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and B_R3)) and (not LS_R3) and KP_R3 and (not X_XB) and (not CAN_XB)  # route XB-XC2: proceed wanted
        N_S_R3 = PR_R3  # route XB-XC2: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route XB-XC2: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route XB-XI7 active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route XB-XI7 locked
        N_W_R4 = (W_R4 or LK_R4 or (((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and B_R4)) and (not LS_R4) and KP_R4 and (not X_XB) and (not CAN_XB)  # route XB-XI7: proceed wanted
        N_S_R4 = PR_R4  # route XB-XI7: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route XB-XI7: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route XI7-XC3 active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route XI7-XC3 locked
        N_W_R5 = (W_R5 or LK_R5 or (((LREQ == 5) or ((LREQ == 0) and (REQ == 5))) and B_R5)) and (not LS_R5) and KP_R5 and (not X_XI7) and (not CAN_XI7)  # route XI7-XC3: proceed wanted
        N_S_R5 = PR_R5  # route XI7-XC3: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route XI7-XC3: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route XI7-XI9 active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route XI7-XI9 locked
        N_W_R6 = (W_R6 or LK_R6 or (((LREQ == 6) or ((LREQ == 0) and (REQ == 6))) and B_R6)) and (not LS_R6) and KP_R6 and (not X_XI7) and (not CAN_XI7)  # route XI7-XI9: proceed wanted
        N_S_R6 = PR_R6  # route XI7-XI9: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route XI7-XI9: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route XI9-XC4 active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route XI9-XC4 locked
        N_W_R7 = (W_R7 or LK_R7 or (((LREQ == 7) or ((LREQ == 0) and (REQ == 7))) and B_R7)) and (not LS_R7) and KP_R7 and (not X_XI9) and (not CAN_XI9)  # route XI9-XC4: proceed wanted
        N_S_R7 = PR_R7  # route XI9-XC4: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route XI9-XC4: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route XI9-XC5 active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route XI9-XC5 locked
        N_W_R8 = (W_R8 or LK_R8 or (((LREQ == 8) or ((LREQ == 0) and (REQ == 8))) and B_R8)) and (not LS_R8) and KP_R8 and (not X_XI9) and (not CAN_XI9)  # route XI9-XC5: proceed wanted
        N_S_R8 = PR_R8  # route XI9-XC5: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route XI9-XC5: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route XL1-XT3 active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route XL1-XT3 locked
        N_W_R9 = (W_R9 or LK_R9 or (((LREQ == 9) or ((LREQ == 0) and (REQ == 9))) and B_R9)) and (not LS_R9) and KP_R9 and (not X_XL1) and (not CAN_XL1)  # route XL1-XT3: proceed wanted
        N_S_R9 = PR_R9  # route XL1-XT3: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route XL1-XT3: signal has been open
        N_A_R10 = (A_R10 or G_R10) and KP_R10  # route XL2-XT3 active
        N_B_R10 = (B_R10 or LK_R10) and KP_R10  # route XL2-XT3 locked
        N_W_R10 = (W_R10 or LK_R10 or (((LREQ == 10) or ((LREQ == 0) and (REQ == 10))) and B_R10)) and (not LS_R10) and KP_R10 and (not X_XL2) and (not CAN_XL2)  # route XL2-XT3: proceed wanted
        N_S_R10 = PR_R10  # route XL2-XT3: proceed
        N_H_R10 = (H_R10 or PR_R10) and KP_R10  # route XL2-XT3: signal has been open
        N_A_R11 = (A_R11 or G_R11) and KP_R11  # route XL3-XT7 active
        N_B_R11 = (B_R11 or LK_R11) and KP_R11  # route XL3-XT7 locked
        N_W_R11 = (W_R11 or LK_R11 or (((LREQ == 11) or ((LREQ == 0) and (REQ == 11))) and B_R11)) and (not LS_R11) and KP_R11 and (not X_XL3) and (not CAN_XL3)  # route XL3-XT7: proceed wanted
        N_S_R11 = PR_R11  # route XL3-XT7: proceed
        N_H_R11 = (H_R11 or PR_R11) and KP_R11  # route XL3-XT7: signal has been open
        N_A_R12 = (A_R12 or G_R12) and KP_R12  # route XL4-XT9 active
        N_B_R12 = (B_R12 or LK_R12) and KP_R12  # route XL4-XT9 locked
        N_W_R12 = (W_R12 or LK_R12 or (((LREQ == 12) or ((LREQ == 0) and (REQ == 12))) and B_R12)) and (not LS_R12) and KP_R12 and (not X_XL4) and (not CAN_XL4)  # route XL4-XT9: proceed wanted
        N_S_R12 = PR_R12  # route XL4-XT9: proceed
        N_H_R12 = (H_R12 or PR_R12) and KP_R12  # route XL4-XT9: signal has been open
        N_A_R13 = (A_R13 or G_R13) and KP_R13  # route XL5-XT9 active
        N_B_R13 = (B_R13 or LK_R13) and KP_R13  # route XL5-XT9 locked
        N_W_R13 = (W_R13 or LK_R13 or (((LREQ == 13) or ((LREQ == 0) and (REQ == 13))) and B_R13)) and (not LS_R13) and KP_R13 and (not X_XL5) and (not CAN_XL5)  # route XL5-XT9: proceed wanted
        N_S_R13 = PR_R13  # route XL5-XT9: proceed
        N_H_R13 = (H_R13 or PR_R13) and KP_R13  # route XL5-XT9: signal has been open
        N_A_R14 = (A_R14 or G_R14) and KP_R14  # route XO-W active
        N_B_R14 = (B_R14 or LK_R14) and KP_R14  # route XO-W locked
        N_W_R14 = (W_R14 or LK_R14 or (((LREQ == 14) or ((LREQ == 0) and (REQ == 14))) and B_R14)) and (not LS_R14) and KP_R14 and (not X_XO) and (not CAN_XO)  # route XO-W: proceed wanted
        N_S_R14 = PR_R14  # route XO-W: proceed
        N_H_R14 = (H_R14 or PR_R14) and KP_R14  # route XO-W: signal has been open
        N_A_R15 = (A_R15 or G_R15) and KP_R15  # route XT3-W active
        N_B_R15 = (B_R15 or LK_R15) and KP_R15  # route XT3-W locked
        N_W_R15 = (W_R15 or LK_R15 or (((LREQ == 15) or ((LREQ == 0) and (REQ == 15))) and B_R15)) and (not LS_R15) and KP_R15 and (not X_XT3) and (not CAN_XT3)  # route XT3-W: proceed wanted
        N_S_R15 = PR_R15  # route XT3-W: proceed
        N_H_R15 = (H_R15 or PR_R15) and KP_R15  # route XT3-W: signal has been open
        N_A_R16 = (A_R16 or G_R16) and KP_R16  # route XT7-XT3 active
        N_B_R16 = (B_R16 or LK_R16) and KP_R16  # route XT7-XT3 locked
        N_W_R16 = (W_R16 or LK_R16 or (((LREQ == 16) or ((LREQ == 0) and (REQ == 16))) and B_R16)) and (not LS_R16) and KP_R16 and (not X_XT7) and (not CAN_XT7)  # route XT7-XT3: proceed wanted
        N_S_R16 = PR_R16  # route XT7-XT3: proceed
        N_H_R16 = (H_R16 or PR_R16) and KP_R16  # route XT7-XT3: signal has been open
        N_A_R17 = (A_R17 or G_R17) and KP_R17  # route XT9-XT7 active
        N_B_R17 = (B_R17 or LK_R17) and KP_R17  # route XT9-XT7 locked
        N_W_R17 = (W_R17 or LK_R17 or (((LREQ == 17) or ((LREQ == 0) and (REQ == 17))) and B_R17)) and (not LS_R17) and KP_R17 and (not X_XT9) and (not CAN_XT9)  # route XT9-XT7: proceed wanted
        N_S_R17 = PR_R17  # route XT9-XT7: proceed
        N_H_R17 = (H_R17 or PR_R17) and KP_R17  # route XT9-XT7: signal has been open
        N_X_XB = (X_XB or CAN_XB) and (A_R1 or A_R2 or A_R3 or A_R4) and (not CD_XB)  # XB: cancelling
        N_X_XI7 = (X_XI7 or CAN_XI7) and (A_R5 or A_R6) and (not CD_XI7)  # XI7: cancelling
        N_X_XI9 = (X_XI9 or CAN_XI9) and (A_R7 or A_R8) and (not CD_XI9)  # XI9: cancelling
        N_X_XL1 = (X_XL1 or CAN_XL1) and A_R9 and (not CD_XL1)  # XL1: cancelling
        N_X_XL2 = (X_XL2 or CAN_XL2) and A_R10 and (not CD_XL2)  # XL2: cancelling
        N_X_XL3 = (X_XL3 or CAN_XL3) and A_R11 and (not CD_XL3)  # XL3: cancelling
        N_X_XL4 = (X_XL4 or CAN_XL4) and A_R12 and (not CD_XL4)  # XL4: cancelling
        N_X_XL5 = (X_XL5 or CAN_XL5) and A_R13 and (not CD_XL5)  # XL5: cancelling
        N_X_XO = (X_XO or CAN_XO) and A_R14 and (not CD_XO)  # XO: cancelling
        N_X_XT3 = (X_XT3 or CAN_XT3) and A_R15 and (not CD_XT3)  # XT3: cancelling
        N_X_XT7 = (X_XT7 or CAN_XT7) and A_R16 and (not CD_XT7)  # XT7: cancelling
        N_X_XT9 = (X_XT9 or CAN_XT9) and A_R17 and (not CD_XT9)  # XT9: cancelling
        N_K_s10_xc4 = K_s10_xc4 and (not RLS_s10_xc4)  # s10_xc4: restart lock (R16)
        N_L_s10_xc4_2 = (L_s10_xc4_2 or GW_s10_xc4_2) and (not RLS_s10_xc4)  # s10_xc4 locked from s10_xc4|s9@P4.normal to XC4
        N_F_s10_xc4 = (F_s10_xc4 or LK_R7) and (not RLS_s10_xc4)  # s10_xc4 firmly locked
        N_U_s10_xc4 = (U_s10_xc4 or NU_s10_xc4_2) and (not RLS_s10_xc4)  # s10_xc4 used by a train (R9)
        N_P_s10_xc4 = (P_s10_xc4 or (U_s10_xc4 and OCC_s10_xc4 and NU_s9_1)) and (not RLS_s10_xc4)  # s10_xc4: the train went on (R9)
        N_D_s10_xc4 = (D_s10_xc4 or ((not VALID) and L_s10_xc4_2)) and (not RLS_s10_xc4)  # s10_xc4: detection is not relied on, inputs were lost or a train is called on
        N_K_s11_xc5 = K_s11_xc5 and (not RLS_s11_xc5)  # s11_xc5: restart lock (R16)
        N_L_s11_xc5_2 = (L_s11_xc5_2 or GW_s11_xc5_2) and (not RLS_s11_xc5)  # s11_xc5 locked from s11_xc5|s9@P4.reverse to XC5
        N_F_s11_xc5 = (F_s11_xc5 or LK_R8) and (not RLS_s11_xc5)  # s11_xc5 firmly locked
        N_U_s11_xc5 = (U_s11_xc5 or NU_s11_xc5_2) and (not RLS_s11_xc5)  # s11_xc5 used by a train (R9)
        N_P_s11_xc5 = (P_s11_xc5 or (U_s11_xc5 and OCC_s11_xc5 and NU_s9_2)) and (not RLS_s11_xc5)  # s11_xc5: the train went on (R9)
        N_D_s11_xc5 = (D_s11_xc5 or ((not VALID) and L_s11_xc5_2)) and (not RLS_s11_xc5)  # s11_xc5: detection is not relied on, inputs were lost or a train is called on
        N_K_s2 = K_s2 and (not RLS_s2)  # s2: restart lock (R16)
        N_L_s2_1 = (L_s2_1 or GW_s2_1) and (not RLS_s2)  # s2 locked from W to s2|s2_out@PS.reverse
        N_L_s2_2 = (L_s2_2 or GW_s2_2) and (not RLS_s2)  # s2 locked from W to s2|s3@PS.normal
        N_L_s2_3 = (L_s2_3 or GW_s2_3) and (not RLS_s2)  # s2 locked from s2|s2_out@PS.reverse to W
        N_L_s2_4 = (L_s2_4 or GW_s2_4) and (not RLS_s2)  # s2 locked from s2|s3@PS.normal to W
        N_F_s2 = (F_s2 or LK_R1 or LK_R2 or LK_R3 or LK_R4 or LK_R14 or LK_R15) and (not RLS_s2)  # s2 firmly locked
        N_U_s2 = (U_s2 or NU_s2_1 or NU_s2_2 or NU_s2_3) and (not RLS_s2)  # s2 used by a train (R9)
        N_P_s2 = (P_s2 or (U_s2 and OCC_s2 and (NU_s2_out_2 or NU_s3_1))) and (not RLS_s2)  # s2: the train went on (R9)
        N_D_s2 = (D_s2 or ((not VALID) and (L_s2_1 or L_s2_2 or L_s2_3 or L_s2_4))) and (not RLS_s2)  # s2: detection is not relied on, inputs were lost or a train is called on
        N_K_s2_out = K_s2_out and (not RLS_s2_out)  # s2_out: restart lock (R16)
        N_L_s2_out_2 = (L_s2_out_2 or GW_s2_out_2) and (not RLS_s2_out)  # s2_out locked from s2|s2_out@PS.reverse to OUT
        N_F_s2_out = (F_s2_out or LK_R1) and (not RLS_s2_out)  # s2_out firmly locked
        N_U_s2_out = (U_s2_out or NU_s2_out_2) and (not RLS_s2_out)  # s2_out used by a train (R9)
        N_P_s2_out = (P_s2_out or (U_s2_out and OCC_s2_out and NU_s2_2)) and (not RLS_s2_out)  # s2_out: the train went on (R9)
        N_D_s2_out = (D_s2_out or ((not VALID) and L_s2_out_2)) and (not RLS_s2_out)  # s2_out: detection is not relied on, inputs were lost or a train is called on
        N_K_s3 = K_s3 and (not RLS_s3)  # s3: restart lock (R16)
        N_L_s3_1 = (L_s3_1 or GW_s3_1) and (not RLS_s3)  # s3 locked from s2|s3@PS.normal to s3|s4_xc1@P1.reverse
        N_L_s3_2 = (L_s3_2 or GW_s3_2) and (not RLS_s3)  # s3 locked from s2|s3@PS.normal to s3|s6@P1.normal
        N_L_s3_3 = (L_s3_3 or GW_s3_3) and (not RLS_s3)  # s3 locked from s3|s4_xc1@P1.reverse to s2|s3@PS.normal
        N_L_s3_4 = (L_s3_4 or GW_s3_4) and (not RLS_s3)  # s3 locked from s3|s6@P1.normal to s2|s3@PS.normal
        N_F_s3 = (F_s3 or LK_R2 or LK_R3 or LK_R4 or LK_R9 or LK_R10 or LK_R16) and (not RLS_s3)  # s3 firmly locked
        N_U_s3 = (U_s3 or NU_s3_1 or NU_s3_2 or NU_s3_3) and (not RLS_s3)  # s3 used by a train (R9)
        N_P_s3 = (P_s3 or (U_s3 and OCC_s3 and (NU_s2_3 or NU_s4_xc1_2 or NU_s6_1))) and (not RLS_s3)  # s3: the train went on (R9)
        N_D_s3 = (D_s3 or ((not VALID) and (L_s3_1 or L_s3_2 or L_s3_3 or L_s3_4))) and (not RLS_s3)  # s3: detection is not relied on, inputs were lost or a train is called on
        N_K_s4_xc1 = K_s4_xc1 and (not RLS_s4_xc1)  # s4_xc1: restart lock (R16)
        N_L_s4_xc1_2 = (L_s4_xc1_2 or GW_s4_xc1_2) and (not RLS_s4_xc1)  # s4_xc1 locked from s3|s4_xc1@P1.reverse to XC1
        N_F_s4_xc1 = (F_s4_xc1 or LK_R2) and (not RLS_s4_xc1)  # s4_xc1 firmly locked
        N_U_s4_xc1 = (U_s4_xc1 or NU_s4_xc1_2) and (not RLS_s4_xc1)  # s4_xc1 used by a train (R9)
        N_P_s4_xc1 = (P_s4_xc1 or (U_s4_xc1 and OCC_s4_xc1 and NU_s3_2)) and (not RLS_s4_xc1)  # s4_xc1: the train went on (R9)
        N_D_s4_xc1 = (D_s4_xc1 or ((not VALID) and L_s4_xc1_2)) and (not RLS_s4_xc1)  # s4_xc1: detection is not relied on, inputs were lost or a train is called on
        N_K_s5_xc2 = K_s5_xc2 and (not RLS_s5_xc2)  # s5_xc2: restart lock (R16)
        N_L_s5_xc2_2 = (L_s5_xc2_2 or GW_s5_xc2_2) and (not RLS_s5_xc2)  # s5_xc2 locked from s5_xc2|s6@P2.reverse to XC2
        N_F_s5_xc2 = (F_s5_xc2 or LK_R3) and (not RLS_s5_xc2)  # s5_xc2 firmly locked
        N_U_s5_xc2 = (U_s5_xc2 or NU_s5_xc2_2) and (not RLS_s5_xc2)  # s5_xc2 used by a train (R9)
        N_P_s5_xc2 = (P_s5_xc2 or (U_s5_xc2 and OCC_s5_xc2 and NU_s6_2)) and (not RLS_s5_xc2)  # s5_xc2: the train went on (R9)
        N_D_s5_xc2 = (D_s5_xc2 or ((not VALID) and L_s5_xc2_2)) and (not RLS_s5_xc2)  # s5_xc2: detection is not relied on, inputs were lost or a train is called on
        N_K_s6 = K_s6 and (not RLS_s6)  # s6: restart lock (R16)
        N_L_s6_1 = (L_s6_1 or GW_s6_1) and (not RLS_s6)  # s6 locked from s3|s6@P1.normal to s5_xc2|s6@P2.reverse
        N_L_s6_2 = (L_s6_2 or GW_s6_2) and (not RLS_s6)  # s6 locked from s3|s6@P1.normal to s6|s7@P2.normal
        N_L_s6_3 = (L_s6_3 or GW_s6_3) and (not RLS_s6)  # s6 locked from s5_xc2|s6@P2.reverse to s3|s6@P1.normal
        N_L_s6_4 = (L_s6_4 or GW_s6_4) and (not RLS_s6)  # s6 locked from s6|s7@P2.normal to s3|s6@P1.normal
        N_F_s6 = (F_s6 or LK_R3 or LK_R4 or LK_R10 or LK_R16) and (not RLS_s6)  # s6 firmly locked
        N_U_s6 = (U_s6 or NU_s6_1 or NU_s6_2 or NU_s6_3) and (not RLS_s6)  # s6 used by a train (R9)
        N_P_s6 = (P_s6 or (U_s6 and OCC_s6 and (NU_s3_3 or NU_s5_xc2_2 or NU_s7_1))) and (not RLS_s6)  # s6: the train went on (R9)
        N_D_s6 = (D_s6 or ((not VALID) and (L_s6_1 or L_s6_2 or L_s6_3 or L_s6_4))) and (not RLS_s6)  # s6: detection is not relied on, inputs were lost or a train is called on
        N_K_s7 = K_s7 and (not RLS_s7)  # s7: restart lock (R16)
        N_L_s7_1 = (L_s7_1 or GW_s7_1) and (not RLS_s7)  # s7 locked from s6|s7@P2.normal to s7|s8_xc3@P3.reverse
        N_L_s7_2 = (L_s7_2 or GW_s7_2) and (not RLS_s7)  # s7 locked from s6|s7@P2.normal to s7|s9@P3.normal
        N_L_s7_3 = (L_s7_3 or GW_s7_3) and (not RLS_s7)  # s7 locked from s7|s8_xc3@P3.reverse to s6|s7@P2.normal
        N_L_s7_4 = (L_s7_4 or GW_s7_4) and (not RLS_s7)  # s7 locked from s7|s9@P3.normal to s6|s7@P2.normal
        N_F_s7 = (F_s7 or LK_R5 or LK_R6 or LK_R11 or LK_R17) and (not RLS_s7)  # s7 firmly locked
        N_U_s7 = (U_s7 or NU_s7_1 or NU_s7_2 or NU_s7_3) and (not RLS_s7)  # s7 used by a train (R9)
        N_P_s7 = (P_s7 or (U_s7 and OCC_s7 and (NU_s6_3 or NU_s8_xc3_2 or NU_s9_3))) and (not RLS_s7)  # s7: the train went on (R9)
        N_D_s7 = (D_s7 or ((not VALID) and (L_s7_1 or L_s7_2 or L_s7_3 or L_s7_4))) and (not RLS_s7)  # s7: detection is not relied on, inputs were lost or a train is called on
        N_K_s8_xc3 = K_s8_xc3 and (not RLS_s8_xc3)  # s8_xc3: restart lock (R16)
        N_L_s8_xc3_2 = (L_s8_xc3_2 or GW_s8_xc3_2) and (not RLS_s8_xc3)  # s8_xc3 locked from s7|s8_xc3@P3.reverse to XC3
        N_F_s8_xc3 = (F_s8_xc3 or LK_R5) and (not RLS_s8_xc3)  # s8_xc3 firmly locked
        N_U_s8_xc3 = (U_s8_xc3 or NU_s8_xc3_2) and (not RLS_s8_xc3)  # s8_xc3 used by a train (R9)
        N_P_s8_xc3 = (P_s8_xc3 or (U_s8_xc3 and OCC_s8_xc3 and NU_s7_2)) and (not RLS_s8_xc3)  # s8_xc3: the train went on (R9)
        N_D_s8_xc3 = (D_s8_xc3 or ((not VALID) and L_s8_xc3_2)) and (not RLS_s8_xc3)  # s8_xc3: detection is not relied on, inputs were lost or a train is called on
        N_K_s9 = K_s9 and (not RLS_s9)  # s9: restart lock (R16)
        N_L_s9_1 = (L_s9_1 or GW_s9_1) and (not RLS_s9)  # s9 locked from s10_xc4|s9@P4.normal to s7|s9@P3.normal
        N_L_s9_2 = (L_s9_2 or GW_s9_2) and (not RLS_s9)  # s9 locked from s11_xc5|s9@P4.reverse to s7|s9@P3.normal
        N_L_s9_3 = (L_s9_3 or GW_s9_3) and (not RLS_s9)  # s9 locked from s7|s9@P3.normal to s10_xc4|s9@P4.normal
        N_L_s9_4 = (L_s9_4 or GW_s9_4) and (not RLS_s9)  # s9 locked from s7|s9@P3.normal to s11_xc5|s9@P4.reverse
        N_F_s9 = (F_s9 or LK_R12 or LK_R13 or LK_R7 or LK_R8) and (not RLS_s9)  # s9 firmly locked
        N_U_s9 = (U_s9 or NU_s9_1 or NU_s9_2 or NU_s9_3) and (not RLS_s9)  # s9 used by a train (R9)
        N_P_s9 = (P_s9 or (U_s9 and OCC_s9 and (NU_s10_xc4_2 or NU_s11_xc5_2 or NU_s7_3))) and (not RLS_s9)  # s9: the train went on (R9)
        N_D_s9 = (D_s9 or ((not VALID) and (L_s9_1 or L_s9_2 or L_s9_3 or L_s9_4))) and (not RLS_s9)  # s9: detection is not relied on, inputs were lost or a train is called on
        N_ZF_INSIDE = ZN1_9_4  # zone INSIDE is full
        self.state = {
            'CN_P1': bool(N_CN_P1),
            'CR_P1': bool(N_CR_P1),
            'CN_P2': bool(N_CN_P2),
            'CR_P2': bool(N_CR_P2),
            'CN_P3': bool(N_CN_P3),
            'CR_P3': bool(N_CR_P3),
            'CN_P4': bool(N_CN_P4),
            'CR_P4': bool(N_CR_P4),
            'CN_PS': bool(N_CN_PS),
            'CR_PS': bool(N_CR_PS),
            'AL_P1': bool(N_AL_P1),
            'AL_P2': bool(N_AL_P2),
            'AL_P3': bool(N_AL_P3),
            'AL_P4': bool(N_AL_P4),
            'AL_PS': bool(N_AL_PS),
            'TH_P1': bool(N_TH_P1),
            'TR_P1': bool(N_TR_P1),
            'TH_P2': bool(N_TH_P2),
            'TR_P2': bool(N_TR_P2),
            'TH_P3': bool(N_TH_P3),
            'TR_P3': bool(N_TR_P3),
            'TH_P4': bool(N_TH_P4),
            'TR_P4': bool(N_TR_P4),
            'TH_PS': bool(N_TH_PS),
            'TR_PS': bool(N_TR_PS),
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
            'A_R13': bool(N_A_R13),
            'B_R13': bool(N_B_R13),
            'W_R13': bool(N_W_R13),
            'S_R13': bool(N_S_R13),
            'H_R13': bool(N_H_R13),
            'A_R14': bool(N_A_R14),
            'B_R14': bool(N_B_R14),
            'W_R14': bool(N_W_R14),
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
            'S_R16': bool(N_S_R16),
            'H_R16': bool(N_H_R16),
            'A_R17': bool(N_A_R17),
            'B_R17': bool(N_B_R17),
            'W_R17': bool(N_W_R17),
            'S_R17': bool(N_S_R17),
            'H_R17': bool(N_H_R17),
            'X_XB': bool(N_X_XB),
            'X_XI7': bool(N_X_XI7),
            'X_XI9': bool(N_X_XI9),
            'X_XL1': bool(N_X_XL1),
            'X_XL2': bool(N_X_XL2),
            'X_XL3': bool(N_X_XL3),
            'X_XL4': bool(N_X_XL4),
            'X_XL5': bool(N_X_XL5),
            'X_XO': bool(N_X_XO),
            'X_XT3': bool(N_X_XT3),
            'X_XT7': bool(N_X_XT7),
            'X_XT9': bool(N_X_XT9),
            'K_s10_xc4': bool(N_K_s10_xc4),
            'L_s10_xc4_2': bool(N_L_s10_xc4_2),
            'F_s10_xc4': bool(N_F_s10_xc4),
            'U_s10_xc4': bool(N_U_s10_xc4),
            'P_s10_xc4': bool(N_P_s10_xc4),
            'D_s10_xc4': bool(N_D_s10_xc4),
            'K_s11_xc5': bool(N_K_s11_xc5),
            'L_s11_xc5_2': bool(N_L_s11_xc5_2),
            'F_s11_xc5': bool(N_F_s11_xc5),
            'U_s11_xc5': bool(N_U_s11_xc5),
            'P_s11_xc5': bool(N_P_s11_xc5),
            'D_s11_xc5': bool(N_D_s11_xc5),
            'K_s2': bool(N_K_s2),
            'L_s2_1': bool(N_L_s2_1),
            'L_s2_2': bool(N_L_s2_2),
            'L_s2_3': bool(N_L_s2_3),
            'L_s2_4': bool(N_L_s2_4),
            'F_s2': bool(N_F_s2),
            'U_s2': bool(N_U_s2),
            'P_s2': bool(N_P_s2),
            'D_s2': bool(N_D_s2),
            'K_s2_out': bool(N_K_s2_out),
            'L_s2_out_2': bool(N_L_s2_out_2),
            'F_s2_out': bool(N_F_s2_out),
            'U_s2_out': bool(N_U_s2_out),
            'P_s2_out': bool(N_P_s2_out),
            'D_s2_out': bool(N_D_s2_out),
            'K_s3': bool(N_K_s3),
            'L_s3_1': bool(N_L_s3_1),
            'L_s3_2': bool(N_L_s3_2),
            'L_s3_3': bool(N_L_s3_3),
            'L_s3_4': bool(N_L_s3_4),
            'F_s3': bool(N_F_s3),
            'U_s3': bool(N_U_s3),
            'P_s3': bool(N_P_s3),
            'D_s3': bool(N_D_s3),
            'K_s4_xc1': bool(N_K_s4_xc1),
            'L_s4_xc1_2': bool(N_L_s4_xc1_2),
            'F_s4_xc1': bool(N_F_s4_xc1),
            'U_s4_xc1': bool(N_U_s4_xc1),
            'P_s4_xc1': bool(N_P_s4_xc1),
            'D_s4_xc1': bool(N_D_s4_xc1),
            'K_s5_xc2': bool(N_K_s5_xc2),
            'L_s5_xc2_2': bool(N_L_s5_xc2_2),
            'F_s5_xc2': bool(N_F_s5_xc2),
            'U_s5_xc2': bool(N_U_s5_xc2),
            'P_s5_xc2': bool(N_P_s5_xc2),
            'D_s5_xc2': bool(N_D_s5_xc2),
            'K_s6': bool(N_K_s6),
            'L_s6_1': bool(N_L_s6_1),
            'L_s6_2': bool(N_L_s6_2),
            'L_s6_3': bool(N_L_s6_3),
            'L_s6_4': bool(N_L_s6_4),
            'F_s6': bool(N_F_s6),
            'U_s6': bool(N_U_s6),
            'P_s6': bool(N_P_s6),
            'D_s6': bool(N_D_s6),
            'K_s7': bool(N_K_s7),
            'L_s7_1': bool(N_L_s7_1),
            'L_s7_2': bool(N_L_s7_2),
            'L_s7_3': bool(N_L_s7_3),
            'L_s7_4': bool(N_L_s7_4),
            'F_s7': bool(N_F_s7),
            'U_s7': bool(N_U_s7),
            'P_s7': bool(N_P_s7),
            'D_s7': bool(N_D_s7),
            'K_s8_xc3': bool(N_K_s8_xc3),
            'L_s8_xc3_2': bool(N_L_s8_xc3_2),
            'F_s8_xc3': bool(N_F_s8_xc3),
            'U_s8_xc3': bool(N_U_s8_xc3),
            'P_s8_xc3': bool(N_P_s8_xc3),
            'D_s8_xc3': bool(N_D_s8_xc3),
            'K_s9': bool(N_K_s9),
            'L_s9_1': bool(N_L_s9_1),
            'L_s9_2': bool(N_L_s9_2),
            'L_s9_3': bool(N_L_s9_3),
            'L_s9_4': bool(N_L_s9_4),
            'F_s9': bool(N_F_s9),
            'U_s9': bool(N_U_s9),
            'P_s9': bool(N_P_s9),
            'D_s9': bool(N_D_s9),
            'ZF_INSIDE': bool(N_ZF_INSIDE),
        }
        CN_P1 = self.state['CN_P1']
        CR_P1 = self.state['CR_P1']
        CN_P2 = self.state['CN_P2']
        CR_P2 = self.state['CR_P2']
        CN_P3 = self.state['CN_P3']
        CR_P3 = self.state['CR_P3']
        CN_P4 = self.state['CN_P4']
        CR_P4 = self.state['CR_P4']
        CN_PS = self.state['CN_PS']
        CR_PS = self.state['CR_PS']
        AL_P1 = self.state['AL_P1']
        AL_P2 = self.state['AL_P2']
        AL_P3 = self.state['AL_P3']
        AL_P4 = self.state['AL_P4']
        AL_PS = self.state['AL_PS']
        TH_P1 = self.state['TH_P1']
        TR_P1 = self.state['TR_P1']
        TH_P2 = self.state['TH_P2']
        TR_P2 = self.state['TR_P2']
        TH_P3 = self.state['TH_P3']
        TR_P3 = self.state['TR_P3']
        TH_P4 = self.state['TH_P4']
        TR_P4 = self.state['TR_P4']
        TH_PS = self.state['TH_PS']
        TR_PS = self.state['TR_PS']
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
        A_R13 = self.state['A_R13']
        B_R13 = self.state['B_R13']
        W_R13 = self.state['W_R13']
        S_R13 = self.state['S_R13']
        H_R13 = self.state['H_R13']
        A_R14 = self.state['A_R14']
        B_R14 = self.state['B_R14']
        W_R14 = self.state['W_R14']
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
        S_R16 = self.state['S_R16']
        H_R16 = self.state['H_R16']
        A_R17 = self.state['A_R17']
        B_R17 = self.state['B_R17']
        W_R17 = self.state['W_R17']
        S_R17 = self.state['S_R17']
        H_R17 = self.state['H_R17']
        X_XB = self.state['X_XB']
        X_XI7 = self.state['X_XI7']
        X_XI9 = self.state['X_XI9']
        X_XL1 = self.state['X_XL1']
        X_XL2 = self.state['X_XL2']
        X_XL3 = self.state['X_XL3']
        X_XL4 = self.state['X_XL4']
        X_XL5 = self.state['X_XL5']
        X_XO = self.state['X_XO']
        X_XT3 = self.state['X_XT3']
        X_XT7 = self.state['X_XT7']
        X_XT9 = self.state['X_XT9']
        K_s10_xc4 = self.state['K_s10_xc4']
        L_s10_xc4_2 = self.state['L_s10_xc4_2']
        F_s10_xc4 = self.state['F_s10_xc4']
        U_s10_xc4 = self.state['U_s10_xc4']
        P_s10_xc4 = self.state['P_s10_xc4']
        D_s10_xc4 = self.state['D_s10_xc4']
        K_s11_xc5 = self.state['K_s11_xc5']
        L_s11_xc5_2 = self.state['L_s11_xc5_2']
        F_s11_xc5 = self.state['F_s11_xc5']
        U_s11_xc5 = self.state['U_s11_xc5']
        P_s11_xc5 = self.state['P_s11_xc5']
        D_s11_xc5 = self.state['D_s11_xc5']
        K_s2 = self.state['K_s2']
        L_s2_1 = self.state['L_s2_1']
        L_s2_2 = self.state['L_s2_2']
        L_s2_3 = self.state['L_s2_3']
        L_s2_4 = self.state['L_s2_4']
        F_s2 = self.state['F_s2']
        U_s2 = self.state['U_s2']
        P_s2 = self.state['P_s2']
        D_s2 = self.state['D_s2']
        K_s2_out = self.state['K_s2_out']
        L_s2_out_2 = self.state['L_s2_out_2']
        F_s2_out = self.state['F_s2_out']
        U_s2_out = self.state['U_s2_out']
        P_s2_out = self.state['P_s2_out']
        D_s2_out = self.state['D_s2_out']
        K_s3 = self.state['K_s3']
        L_s3_1 = self.state['L_s3_1']
        L_s3_2 = self.state['L_s3_2']
        L_s3_3 = self.state['L_s3_3']
        L_s3_4 = self.state['L_s3_4']
        F_s3 = self.state['F_s3']
        U_s3 = self.state['U_s3']
        P_s3 = self.state['P_s3']
        D_s3 = self.state['D_s3']
        K_s4_xc1 = self.state['K_s4_xc1']
        L_s4_xc1_2 = self.state['L_s4_xc1_2']
        F_s4_xc1 = self.state['F_s4_xc1']
        U_s4_xc1 = self.state['U_s4_xc1']
        P_s4_xc1 = self.state['P_s4_xc1']
        D_s4_xc1 = self.state['D_s4_xc1']
        K_s5_xc2 = self.state['K_s5_xc2']
        L_s5_xc2_2 = self.state['L_s5_xc2_2']
        F_s5_xc2 = self.state['F_s5_xc2']
        U_s5_xc2 = self.state['U_s5_xc2']
        P_s5_xc2 = self.state['P_s5_xc2']
        D_s5_xc2 = self.state['D_s5_xc2']
        K_s6 = self.state['K_s6']
        L_s6_1 = self.state['L_s6_1']
        L_s6_2 = self.state['L_s6_2']
        L_s6_3 = self.state['L_s6_3']
        L_s6_4 = self.state['L_s6_4']
        F_s6 = self.state['F_s6']
        U_s6 = self.state['U_s6']
        P_s6 = self.state['P_s6']
        D_s6 = self.state['D_s6']
        K_s7 = self.state['K_s7']
        L_s7_1 = self.state['L_s7_1']
        L_s7_2 = self.state['L_s7_2']
        L_s7_3 = self.state['L_s7_3']
        L_s7_4 = self.state['L_s7_4']
        F_s7 = self.state['F_s7']
        U_s7 = self.state['U_s7']
        P_s7 = self.state['P_s7']
        D_s7 = self.state['D_s7']
        K_s8_xc3 = self.state['K_s8_xc3']
        L_s8_xc3_2 = self.state['L_s8_xc3_2']
        F_s8_xc3 = self.state['F_s8_xc3']
        U_s8_xc3 = self.state['U_s8_xc3']
        P_s8_xc3 = self.state['P_s8_xc3']
        D_s8_xc3 = self.state['D_s8_xc3']
        K_s9 = self.state['K_s9']
        L_s9_1 = self.state['L_s9_1']
        L_s9_2 = self.state['L_s9_2']
        L_s9_3 = self.state['L_s9_3']
        L_s9_4 = self.state['L_s9_4']
        F_s9 = self.state['F_s9']
        U_s9 = self.state['U_s9']
        P_s9 = self.state['P_s9']
        D_s9 = self.state['D_s9']
        ZF_INSIDE = self.state['ZF_INSIDE']
        return {
            'YN_P1': bool(CN_P1),
            'YR_P1': bool(CR_P1),
            'YN_P2': bool(CN_P2),
            'YR_P2': bool(CR_P2),
            'YN_P3': bool(CN_P3),
            'YR_P3': bool(CR_P3),
            'YN_P4': bool(CN_P4),
            'YR_P4': bool(CR_P4),
            'YN_PS': bool(CN_PS),
            'YR_PS': bool(CR_PS),
            'YA_P1': bool(AL_P1),
            'YA_P2': bool(AL_P2),
            'YA_P3': bool(AL_P3),
            'YA_P4': bool(AL_P4),
            'YA_PS': bool(AL_PS),
            'YT_P1': bool(TR_P1),
            'YT_P2': bool(TR_P2),
            'YT_P3': bool(TR_P3),
            'YT_P4': bool(TR_P4),
            'YT_PS': bool(TR_PS),
            'YL_s10_xc4': bool(K_s10_xc4 or L_s10_xc4_2),
            'YL_s11_xc5': bool(K_s11_xc5 or L_s11_xc5_2),
            'YL_s2': bool(K_s2 or L_s2_1 or L_s2_2 or L_s2_3 or L_s2_4),
            'YL_s2_out': bool(K_s2_out or L_s2_out_2),
            'YL_s3': bool(K_s3 or L_s3_1 or L_s3_2 or L_s3_3 or L_s3_4),
            'YL_s4_xc1': bool(K_s4_xc1 or L_s4_xc1_2),
            'YL_s5_xc2': bool(K_s5_xc2 or L_s5_xc2_2),
            'YL_s6': bool(K_s6 or L_s6_1 or L_s6_2 or L_s6_3 or L_s6_4),
            'YL_s7': bool(K_s7 or L_s7_1 or L_s7_2 or L_s7_3 or L_s7_4),
            'YL_s8_xc3': bool(K_s8_xc3 or L_s8_xc3_2),
            'YL_s9': bool(K_s9 or L_s9_1 or L_s9_2 or L_s9_3 or L_s9_4),
            'YP_XB': bool(S_R1 or S_R2 or S_R3 or S_R4),
            'YS_XB': bool((not (S_R1 or S_R2 or S_R3 or S_R4))),
            'YP_XI7': bool(S_R5 or S_R6),
            'YS_XI7': bool((not (S_R5 or S_R6))),
            'YP_XI9': bool(S_R7 or S_R8),
            'YS_XI9': bool((not (S_R7 or S_R8))),
            'YP_XL1': bool(S_R9),
            'YS_XL1': bool((not S_R9)),
            'YP_XL2': bool(S_R10),
            'YS_XL2': bool((not S_R10)),
            'YP_XL3': bool(S_R11),
            'YS_XL3': bool((not S_R11)),
            'YP_XL4': bool(S_R12),
            'YS_XL4': bool((not S_R12)),
            'YP_XL5': bool(S_R13),
            'YS_XL5': bool((not S_R13)),
            'YP_XO': bool(S_R14),
            'YS_XO': bool((not S_R14)),
            'YP_XT3': bool(S_R15),
            'YS_XT3': bool((not S_R15)),
            'YP_XT7': bool(S_R16),
            'YS_XT7': bool((not S_R16)),
            'YP_XT9': bool(S_R17),
            'YS_XT9': bool((not S_R17)),
            'YZ_INSIDE': bool(ZF_INSIDE),
        }
