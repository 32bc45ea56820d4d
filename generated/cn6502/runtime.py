# Interlocking cn6502, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout 2871a70ede7940f50d0c9070b1415d0eab8ebc66b78c8bd5070447154b81b612
# claims 3df23f754f3a9fe0643131c9d6447a06df6873557b97fe8534e63167a1325d22
"""Interlocking cn6502: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_D1': (0, 2),  # operator: cancel the route from D1
    'CAN_D11': (0, 2),  # operator: cancel the route from D11
    'CAN_D13': (0, 2),  # operator: cancel the route from D13
    'CAN_D15': (0, 2),  # operator: cancel the route from D15
    'CAN_D17': (0, 2),  # operator: cancel the route from D17
    'CAN_D3': (0, 2),  # operator: cancel the route from D3
    'CAN_D5': (0, 2),  # operator: cancel the route from D5
    'CAN_D7': (0, 2),  # operator: cancel the route from D7
    'CAN_D9': (0, 2),  # operator: cancel the route from D9
    'CAN_S4': (0, 2),  # operator: cancel the route from S4
    'CAN_S5': (0, 2),  # operator: cancel the route from S5
    'CAN_SII': (0, 2),  # operator: cancel the route from SII
    'CAN_SIII': (0, 2),  # operator: cancel the route from SIII
    'CAN_X': (0, 2),  # operator: cancel the route from X
    'CAN_XD': (0, 2),  # operator: cancel the route from XD
    'RL_D1': (0, 2),  # stop lamp of D1 intact
    'RL_D11': (0, 2),  # stop lamp of D11 intact
    'RL_D13': (0, 2),  # stop lamp of D13 intact
    'RL_D15': (0, 2),  # stop lamp of D15 intact
    'RL_D17': (0, 2),  # stop lamp of D17 intact
    'RL_D3': (0, 2),  # stop lamp of D3 intact
    'RL_D5': (0, 2),  # stop lamp of D5 intact
    'RL_D7': (0, 2),  # stop lamp of D7 intact
    'RL_D9': (0, 2),  # stop lamp of D9 intact
    'RL_S4': (0, 2),  # stop lamp of S4 intact
    'RL_S5': (0, 2),  # stop lamp of S5 intact
    'RL_SII': (0, 2),  # stop lamp of SII intact
    'RL_SIII': (0, 2),  # stop lamp of SIII intact
    'RL_X': (0, 2),  # stop lamp of X intact
    'RL_XD': (0, 2),  # stop lamp of XD intact
    'GL_S4': (0, 2),  # clear lamp of S4 intact, or not lit
    'CL_S4': (0, 2),  # caution lamp of S4 intact, or not lit
    'GL_S5': (0, 2),  # clear lamp of S5 intact, or not lit
    'CL_S5': (0, 2),  # caution lamp of S5 intact, or not lit
    'GL_SII': (0, 2),  # clear lamp of SII intact, or not lit
    'CL_SII': (0, 2),  # caution lamp of SII intact, or not lit
    'GL_SIII': (0, 2),  # clear lamp of SIII intact, or not lit
    'CL_SIII': (0, 2),  # caution lamp of SIII intact, or not lit
    'GL_X': (0, 2),  # clear lamp of X intact, or not lit
    'CL_X': (0, 2),  # caution lamp of X intact, or not lit
    'GL_XD': (0, 2),  # clear lamp of XD intact, or not lit
    'CL_XD': (0, 2),  # caution lamp of XD intact, or not lit
    'E_BF_BS': (0, 2),  # external condition BF/BS: block towards BS free, direction ours
    'E_BF_DJ': (0, 2),  # external condition BF/DJ: block towards DJ free, direction ours
    'REQ': (0, 76),  # operator: set route number, 0 = none
    'VOY': (0, 2),  # operator: voyage number, 0 = none
    'CLR_1_19WG': (0, 2),  # section 1/19WG reported clear
    'CLR_11_13DG': (0, 2),  # section 11-13DG reported clear
    'CLR_17_23DG': (0, 2),  # section 17-23DG reported clear
    'CLR_19_27DG': (0, 2),  # section 19-27DG reported clear
    'CLR_1DG': (0, 2),  # section 1DG reported clear
    'CLR_21DG': (0, 2),  # section 21DG reported clear
    'CLR_25DG': (0, 2),  # section 25DG reported clear
    'CLR_3DG': (0, 2),  # section 3DG reported clear
    'CLR_4G': (0, 2),  # section 4G reported clear
    'CLR_5DG': (0, 2),  # section 5DG reported clear
    'CLR_5G': (0, 2),  # section 5G reported clear
    'CLR_7DG': (0, 2),  # section 7DG reported clear
    'CLR_9_15DG': (0, 2),  # section 9-15DG reported clear
    'CLR_IAG': (0, 2),  # section IAG reported clear
    'CLR_IG': (0, 2),  # section IG reported clear
    'CLR_IIAG': (0, 2),  # section IIAG reported clear
    'CLR_IIG': (0, 2),  # section IIG reported clear
    'CLR_IIIG': (0, 2),  # section IIIG reported clear
    'CLR_XDJG': (0, 2),  # section XDJG reported clear
    'CLR_XJG': (0, 2),  # section XJG reported clear
    'REL_1_19WG': (0, 2),  # operator: release section 1/19WG (hold until released)
    'REL_11_13DG': (0, 2),  # operator: release section 11-13DG (hold until released)
    'REL_17_23DG': (0, 2),  # operator: release section 17-23DG (hold until released)
    'REL_19_27DG': (0, 2),  # operator: release section 19-27DG (hold until released)
    'REL_1DG': (0, 2),  # operator: release section 1DG (hold until released)
    'REL_21DG': (0, 2),  # operator: release section 21DG (hold until released)
    'REL_25DG': (0, 2),  # operator: release section 25DG (hold until released)
    'REL_3DG': (0, 2),  # operator: release section 3DG (hold until released)
    'REL_4G': (0, 2),  # operator: release section 4G (hold until released)
    'REL_5DG': (0, 2),  # operator: release section 5DG (hold until released)
    'REL_5G': (0, 2),  # operator: release section 5G (hold until released)
    'REL_7DG': (0, 2),  # operator: release section 7DG (hold until released)
    'REL_9_15DG': (0, 2),  # operator: release section 9-15DG (hold until released)
    'REL_IAG': (0, 2),  # operator: release section IAG (hold until released)
    'REL_IG': (0, 2),  # operator: release section IG (hold until released)
    'REL_IIAG': (0, 2),  # operator: release section IIAG (hold until released)
    'REL_IIG': (0, 2),  # operator: release section IIG (hold until released)
    'REL_IIIG': (0, 2),  # operator: release section IIIG (hold until released)
    'BLK_1_19WG': (1, 2),  # operator: section 1/19WG is blocked
    'BLK_11_13DG': (1, 2),  # operator: section 11-13DG is blocked
    'BLK_17_23DG': (1, 2),  # operator: section 17-23DG is blocked
    'BLK_19_27DG': (1, 2),  # operator: section 19-27DG is blocked
    'BLK_1DG': (1, 2),  # operator: section 1DG is blocked
    'BLK_21DG': (1, 2),  # operator: section 21DG is blocked
    'BLK_25DG': (1, 2),  # operator: section 25DG is blocked
    'BLK_3DG': (1, 2),  # operator: section 3DG is blocked
    'BLK_4G': (1, 2),  # operator: section 4G is blocked
    'BLK_5DG': (1, 2),  # operator: section 5DG is blocked
    'BLK_5G': (1, 2),  # operator: section 5G is blocked
    'BLK_7DG': (1, 2),  # operator: section 7DG is blocked
    'BLK_9_15DG': (1, 2),  # operator: section 9-15DG is blocked
    'BLK_IAG': (1, 2),  # operator: section IAG is blocked
    'BLK_IG': (1, 2),  # operator: section IG is blocked
    'BLK_IIAG': (1, 2),  # operator: section IIAG is blocked
    'BLK_IIG': (1, 2),  # operator: section IIG is blocked
    'BLK_IIIG': (1, 2),  # operator: section IIIG is blocked
    'RELALL': (0, 2),  # operator: release all clear sections after a restart
    'DN_1_3': (0, 2),  # machine 1/3 detected normal
    'DR_1_3': (0, 2),  # machine 1/3 detected reverse
    'MN_1_3': (0, 2),  # operator: move machine 1/3 normal
    'MR_1_3': (0, 2),  # operator: move machine 1/3 reverse
    'TC_1_3': (0, 2),  # operator: machine 1/3 has been looked at after it was trailed
    'DN_13_15': (0, 2),  # machine 13/15 detected normal
    'DR_13_15': (0, 2),  # machine 13/15 detected reverse
    'MN_13_15': (0, 2),  # operator: move machine 13/15 normal
    'MR_13_15': (0, 2),  # operator: move machine 13/15 reverse
    'TC_13_15': (0, 2),  # operator: machine 13/15 has been looked at after it was trailed
    'DN_17_19': (0, 2),  # machine 17/19 detected normal
    'DR_17_19': (0, 2),  # machine 17/19 detected reverse
    'MN_17_19': (0, 2),  # operator: move machine 17/19 normal
    'MR_17_19': (0, 2),  # operator: move machine 17/19 reverse
    'TC_17_19': (0, 2),  # operator: machine 17/19 has been looked at after it was trailed
    'DN_21': (0, 2),  # machine 21 detected normal
    'DR_21': (0, 2),  # machine 21 detected reverse
    'MN_21': (0, 2),  # operator: move machine 21 normal
    'MR_21': (0, 2),  # operator: move machine 21 reverse
    'TC_21': (0, 2),  # operator: machine 21 has been looked at after it was trailed
    'DN_23_25': (0, 2),  # machine 23/25 detected normal
    'DR_23_25': (0, 2),  # machine 23/25 detected reverse
    'MN_23_25': (0, 2),  # operator: move machine 23/25 normal
    'MR_23_25': (0, 2),  # operator: move machine 23/25 reverse
    'TC_23_25': (0, 2),  # operator: machine 23/25 has been looked at after it was trailed
    'DN_27': (0, 2),  # machine 27 detected normal
    'DR_27': (0, 2),  # machine 27 detected reverse
    'MN_27': (0, 2),  # operator: move machine 27 normal
    'MR_27': (0, 2),  # operator: move machine 27 reverse
    'TC_27': (0, 2),  # operator: machine 27 has been looked at after it was trailed
    'DN_5_7': (0, 2),  # machine 5/7 detected normal
    'DR_5_7': (0, 2),  # machine 5/7 detected reverse
    'MN_5_7': (0, 2),  # operator: move machine 5/7 normal
    'MR_5_7': (0, 2),  # operator: move machine 5/7 reverse
    'TC_5_7': (0, 2),  # operator: machine 5/7 has been looked at after it was trailed
    'DN_9_11': (0, 2),  # machine 9/11 detected normal
    'DR_9_11': (0, 2),  # machine 9/11 detected reverse
    'MN_9_11': (0, 2),  # operator: move machine 9/11 normal
    'MR_9_11': (0, 2),  # operator: move machine 9/11 reverse
    'TC_9_11': (0, 2),  # operator: machine 9/11 has been looked at after it was trailed
}
# name: value at a restart, meaning
STATE = {
    'CN_1_3': False,  # machine 1/3 commanded N
    'CR_1_3': False,  # machine 1/3 commanded R
    'CN_13_15': False,  # machine 13/15 commanded N
    'CR_13_15': False,  # machine 13/15 commanded R
    'CN_17_19': False,  # machine 17/19 commanded N
    'CR_17_19': False,  # machine 17/19 commanded R
    'CN_21': False,  # machine 21 commanded N
    'CR_21': False,  # machine 21 commanded R
    'CN_23_25': False,  # machine 23/25 commanded N
    'CR_23_25': False,  # machine 23/25 commanded R
    'CN_27': False,  # machine 27 commanded N
    'CR_27': False,  # machine 27 commanded R
    'CN_5_7': False,  # machine 5/7 commanded N
    'CR_5_7': False,  # machine 5/7 commanded R
    'CN_9_11': False,  # machine 9/11 commanded N
    'CR_9_11': False,  # machine 9/11 commanded R
    'AL_1_3': False,  # alarm: machine 1/3 not detected
    'AL_13_15': False,  # alarm: machine 13/15 not detected
    'AL_17_19': False,  # alarm: machine 17/19 not detected
    'AL_21': False,  # alarm: machine 21 not detected
    'AL_23_25': False,  # alarm: machine 23/25 not detected
    'AL_27': False,  # alarm: machine 27 not detected
    'AL_5_7': False,  # alarm: machine 5/7 not detected
    'AL_9_11': False,  # alarm: machine 9/11 not detected
    'TH_1_3': False,  # machine 1/3 was detected where it is commanded
    'TR_1_3': False,  # machine 1/3 was trailed
    'TH_13_15': False,  # machine 13/15 was detected where it is commanded
    'TR_13_15': False,  # machine 13/15 was trailed
    'TH_17_19': False,  # machine 17/19 was detected where it is commanded
    'TR_17_19': False,  # machine 17/19 was trailed
    'TH_21': False,  # machine 21 was detected where it is commanded
    'TR_21': False,  # machine 21 was trailed
    'TH_23_25': False,  # machine 23/25 was detected where it is commanded
    'TR_23_25': False,  # machine 23/25 was trailed
    'TH_27': False,  # machine 27 was detected where it is commanded
    'TR_27': False,  # machine 27 was trailed
    'TH_5_7': False,  # machine 5/7 was detected where it is commanded
    'TR_5_7': False,  # machine 5/7 was trailed
    'TH_9_11': False,  # machine 9/11 was detected where it is commanded
    'TR_9_11': False,  # machine 9/11 was trailed
    'Z_1_3': False,  # machine 1/3 may run
    'Z_13_15': False,  # machine 13/15 may run
    'Z_17_19': False,  # machine 17/19 may run
    'Z_21': False,  # machine 21 may run
    'Z_23_25': False,  # machine 23/25 may run
    'Z_27': False,  # machine 27 may run
    'Z_5_7': False,  # machine 5/7 may run
    'Z_9_11': False,  # machine 9/11 may run
    'SG': False,  # a machine started in the last scan
    'A_R1': False,  # route D1-D15 active
    'B_R1': False,  # route D1-D15 locked
    'W_R1': False,  # route D1-D15: proceed wanted
    'S_R1': False,  # route D1-D15: proceed
    'H_R1': False,  # route D1-D15: signal has been open
    'A_R2': False,  # route D1-D9 active
    'B_R2': False,  # route D1-D9 locked
    'W_R2': False,  # route D1-D9: proceed wanted
    'S_R2': False,  # route D1-D9: proceed
    'H_R2': False,  # route D1-D9: signal has been open
    'A_R3': False,  # route D11-5G active
    'B_R3': False,  # route D11-5G locked
    'W_R3': False,  # route D11-5G: proceed wanted
    'PA_R3': False,  # route D11-5G: open for the movement that passes D11
    'S_R3': False,  # route D11-5G: proceed
    'H_R3': False,  # route D11-5G: signal has been open
    'A_R4': False,  # route D11-D13 active
    'B_R4': False,  # route D11-D13 locked
    'W_R4': False,  # route D11-D13: proceed wanted
    'PA_R4': False,  # route D11-D13: open for the movement that passes D11
    'S_R4': False,  # route D11-D13: proceed
    'H_R4': False,  # route D11-D13: signal has been open
    'A_R5': False,  # route D11-IIIG active
    'B_R5': False,  # route D11-IIIG locked
    'W_R5': False,  # route D11-IIIG: proceed wanted
    'PA_R5': False,  # route D11-IIIG: open for the movement that passes D11
    'S_R5': False,  # route D11-IIIG: proceed
    'H_R5': False,  # route D11-IIIG: signal has been open
    'A_R6': False,  # route D13-4G active
    'B_R6': False,  # route D13-4G locked
    'W_R6': False,  # route D13-4G: proceed wanted
    'PA_R6': False,  # route D13-4G: open for the movement that passes D13
    'S_R6': False,  # route D13-4G: proceed
    'H_R6': False,  # route D13-4G: signal has been open
    'A_R7': False,  # route D13-IG active
    'B_R7': False,  # route D13-IG locked
    'W_R7': False,  # route D13-IG: proceed wanted
    'PA_R7': False,  # route D13-IG: open for the movement that passes D13
    'S_R7': False,  # route D13-IG: proceed
    'H_R7': False,  # route D13-IG: signal has been open
    'A_R8': False,  # route D13-IIG active
    'B_R8': False,  # route D13-IIG locked
    'W_R8': False,  # route D13-IIG: proceed wanted
    'PA_R8': False,  # route D13-IIG: open for the movement that passes D13
    'S_R8': False,  # route D13-IIG: proceed
    'H_R8': False,  # route D13-IIG: signal has been open
    'A_R9': False,  # route D13-IIIG active
    'B_R9': False,  # route D13-IIIG locked
    'W_R9': False,  # route D13-IIIG: proceed wanted
    'PA_R9': False,  # route D13-IIIG: open for the movement that passes D13
    'S_R9': False,  # route D13-IIIG: proceed
    'H_R9': False,  # route D13-IIIG: signal has been open
    'A_R10': False,  # route D15-4G active
    'B_R10': False,  # route D15-4G locked
    'W_R10': False,  # route D15-4G: proceed wanted
    'S_R10': False,  # route D15-4G: proceed
    'H_R10': False,  # route D15-4G: signal has been open
    'A_R11': False,  # route D15-IIG active
    'B_R11': False,  # route D15-IIG locked
    'W_R11': False,  # route D15-IIG: proceed wanted
    'S_R11': False,  # route D15-IIG: proceed
    'H_R11': False,  # route D15-IIG: signal has been open
    'A_R12': False,  # route D17-D7 active
    'B_R12': False,  # route D17-D7 locked
    'W_R12': False,  # route D17-D7: proceed wanted
    'S_R12': False,  # route D17-D7: proceed
    'H_R12': False,  # route D17-D7: signal has been open
    'A_R13': False,  # route D17-IAG active
    'B_R13': False,  # route D17-IAG locked
    'W_R13': False,  # route D17-IAG: proceed wanted
    'S_R13': False,  # route D17-IAG: proceed
    'H_R13': False,  # route D17-IAG: signal has been open
    'A_R14': False,  # route D3-D11 active
    'B_R14': False,  # route D3-D11 locked
    'W_R14': False,  # route D3-D11: proceed wanted
    'S_R14': False,  # route D3-D11: proceed
    'H_R14': False,  # route D3-D11: signal has been open
    'A_R15': False,  # route D3-D9 active
    'B_R15': False,  # route D3-D9 locked
    'W_R15': False,  # route D3-D9: proceed wanted
    'S_R15': False,  # route D3-D9: proceed
    'H_R15': False,  # route D3-D9: signal has been open
    'A_R16': False,  # route D5-IIAG active
    'B_R16': False,  # route D5-IIAG locked
    'W_R16': False,  # route D5-IIAG: proceed wanted
    'S_R16': False,  # route D5-IIAG: proceed
    'H_R16': False,  # route D5-IIAG: signal has been open
    'A_R17': False,  # route D7-IAG active
    'B_R17': False,  # route D7-IAG locked
    'W_R17': False,  # route D7-IAG: proceed wanted
    'PA_R17': False,  # route D7-IAG: open for the movement that passes D7
    'S_R17': False,  # route D7-IAG: proceed
    'H_R17': False,  # route D7-IAG: signal has been open
    'A_R18': False,  # route D7-IIAG active
    'B_R18': False,  # route D7-IIAG locked
    'W_R18': False,  # route D7-IIAG: proceed wanted
    'PA_R18': False,  # route D7-IIAG: open for the movement that passes D7
    'S_R18': False,  # route D7-IIAG: proceed
    'H_R18': False,  # route D7-IIAG: signal has been open
    'A_R19': False,  # route D9-5G active
    'B_R19': False,  # route D9-5G locked
    'W_R19': False,  # route D9-5G: proceed wanted
    'PA_R19': False,  # route D9-5G: open for the movement that passes D9
    'S_R19': False,  # route D9-5G: proceed
    'H_R19': False,  # route D9-5G: signal has been open
    'A_R20': False,  # route D9-D13 active
    'B_R20': False,  # route D9-D13 locked
    'W_R20': False,  # route D9-D13: proceed wanted
    'PA_R20': False,  # route D9-D13: open for the movement that passes D9
    'S_R20': False,  # route D9-D13: proceed
    'H_R20': False,  # route D9-D13: signal has been open
    'A_R21': False,  # route D9-IIIG active
    'B_R21': False,  # route D9-IIIG locked
    'W_R21': False,  # route D9-IIIG: proceed wanted
    'PA_R21': False,  # route D9-IIIG: open for the movement that passes D9
    'S_R21': False,  # route D9-IIIG: proceed
    'H_R21': False,  # route D9-IIIG: signal has been open
    'A_R22': False,  # route S4-BS active
    'B_R22': False,  # route S4-BS locked
    'W_R22': False,  # route S4-BS: proceed wanted
    'S_R22': False,  # route S4-BS: proceed
    'H_R22': False,  # route S4-BS: signal has been open
    'A_R23': False,  # route S4-BS.2 active
    'B_R23': False,  # route S4-BS.2 locked
    'W_R23': False,  # route S4-BS.2: proceed wanted
    'S_R23': False,  # route S4-BS.2: proceed
    'H_R23': False,  # route S4-BS.2: signal has been open
    'A_R24': False,  # route S4-DJ active
    'B_R24': False,  # route S4-DJ locked
    'W_R24': False,  # route S4-DJ: proceed wanted
    'S_R24': False,  # route S4-DJ: proceed
    'H_R24': False,  # route S4-DJ: signal has been open
    'A_R25': False,  # route S4-D5.s active
    'B_R25': False,  # route S4-D5.s locked
    'W_R25': False,  # route S4-D5.s: proceed wanted
    'S_R25': False,  # route S4-D5.s: proceed
    'H_R25': False,  # route S4-D5.s: signal has been open
    'A_R26': False,  # route S4-D7.s active
    'B_R26': False,  # route S4-D7.s locked
    'W_R26': False,  # route S4-D7.s: proceed wanted
    'S_R26': False,  # route S4-D7.s: proceed
    'H_R26': False,  # route S4-D7.s: signal has been open
    'A_R27': False,  # route S4-IAG.s active
    'B_R27': False,  # route S4-IAG.s locked
    'W_R27': False,  # route S4-IAG.s: proceed wanted
    'S_R27': False,  # route S4-IAG.s: proceed
    'H_R27': False,  # route S4-IAG.s: signal has been open
    'A_R28': False,  # route S5-BS active
    'B_R28': False,  # route S5-BS locked
    'W_R28': False,  # route S5-BS: proceed wanted
    'S_R28': False,  # route S5-BS: proceed
    'H_R28': False,  # route S5-BS: signal has been open
    'A_R29': False,  # route S5-DJ active
    'B_R29': False,  # route S5-DJ locked
    'W_R29': False,  # route S5-DJ: proceed wanted
    'S_R29': False,  # route S5-DJ: proceed
    'H_R29': False,  # route S5-DJ: signal has been open
    'A_R30': False,  # route S5-D7.s active
    'B_R30': False,  # route S5-D7.s locked
    'W_R30': False,  # route S5-D7.s: proceed wanted
    'S_R30': False,  # route S5-D7.s: proceed
    'H_R30': False,  # route S5-D7.s: signal has been open
    'A_R31': False,  # route S5-IAG.s active
    'B_R31': False,  # route S5-IAG.s locked
    'W_R31': False,  # route S5-IAG.s: proceed wanted
    'S_R31': False,  # route S5-IAG.s: proceed
    'H_R31': False,  # route S5-IAG.s: signal has been open
    'A_R32': False,  # route SII-BS active
    'B_R32': False,  # route SII-BS locked
    'W_R32': False,  # route SII-BS: proceed wanted
    'S_R32': False,  # route SII-BS: proceed
    'H_R32': False,  # route SII-BS: signal has been open
    'A_R33': False,  # route SII-BS.2 active
    'B_R33': False,  # route SII-BS.2 locked
    'W_R33': False,  # route SII-BS.2: proceed wanted
    'S_R33': False,  # route SII-BS.2: proceed
    'H_R33': False,  # route SII-BS.2: signal has been open
    'A_R34': False,  # route SII-DJ active
    'B_R34': False,  # route SII-DJ locked
    'W_R34': False,  # route SII-DJ: proceed wanted
    'S_R34': False,  # route SII-DJ: proceed
    'H_R34': False,  # route SII-DJ: signal has been open
    'A_R35': False,  # route SII-D5.s active
    'B_R35': False,  # route SII-D5.s locked
    'W_R35': False,  # route SII-D5.s: proceed wanted
    'S_R35': False,  # route SII-D5.s: proceed
    'H_R35': False,  # route SII-D5.s: signal has been open
    'A_R36': False,  # route SII-D7.s active
    'B_R36': False,  # route SII-D7.s locked
    'W_R36': False,  # route SII-D7.s: proceed wanted
    'S_R36': False,  # route SII-D7.s: proceed
    'H_R36': False,  # route SII-D7.s: signal has been open
    'A_R37': False,  # route SII-IAG.s active
    'B_R37': False,  # route SII-IAG.s locked
    'W_R37': False,  # route SII-IAG.s: proceed wanted
    'S_R37': False,  # route SII-IAG.s: proceed
    'H_R37': False,  # route SII-IAG.s: signal has been open
    'A_R38': False,  # route SIII-BS active
    'B_R38': False,  # route SIII-BS locked
    'W_R38': False,  # route SIII-BS: proceed wanted
    'S_R38': False,  # route SIII-BS: proceed
    'H_R38': False,  # route SIII-BS: signal has been open
    'A_R39': False,  # route SIII-BS.2 active
    'B_R39': False,  # route SIII-BS.2 locked
    'W_R39': False,  # route SIII-BS.2: proceed wanted
    'S_R39': False,  # route SIII-BS.2: proceed
    'H_R39': False,  # route SIII-BS.2: signal has been open
    'A_R40': False,  # route SIII-DJ active
    'B_R40': False,  # route SIII-DJ locked
    'W_R40': False,  # route SIII-DJ: proceed wanted
    'S_R40': False,  # route SIII-DJ: proceed
    'H_R40': False,  # route SIII-DJ: signal has been open
    'A_R41': False,  # route SIII-DJ.2 active
    'B_R41': False,  # route SIII-DJ.2 locked
    'W_R41': False,  # route SIII-DJ.2: proceed wanted
    'S_R41': False,  # route SIII-DJ.2: proceed
    'H_R41': False,  # route SIII-DJ.2: signal has been open
    'A_R42': False,  # route SIII-D7.s active
    'B_R42': False,  # route SIII-D7.s locked
    'W_R42': False,  # route SIII-D7.s: proceed wanted
    'S_R42': False,  # route SIII-D7.s: proceed
    'H_R42': False,  # route SIII-D7.s: signal has been open
    'A_R43': False,  # route SIII-D7.s.2 active
    'B_R43': False,  # route SIII-D7.s.2 locked
    'W_R43': False,  # route SIII-D7.s.2: proceed wanted
    'S_R43': False,  # route SIII-D7.s.2: proceed
    'H_R43': False,  # route SIII-D7.s.2: signal has been open
    'A_R44': False,  # route SIII-IAG.s active
    'B_R44': False,  # route SIII-IAG.s locked
    'W_R44': False,  # route SIII-IAG.s: proceed wanted
    'S_R44': False,  # route SIII-IAG.s: proceed
    'H_R44': False,  # route SIII-IAG.s: signal has been open
    'A_R45': False,  # route SIII-IAG.s.2 active
    'B_R45': False,  # route SIII-IAG.s.2 locked
    'W_R45': False,  # route SIII-IAG.s.2: proceed wanted
    'S_R45': False,  # route SIII-IAG.s.2: proceed
    'H_R45': False,  # route SIII-IAG.s.2: signal has been open
    'A_R46': False,  # route X-E1 active
    'B_R46': False,  # route X-E1 locked
    'W_R46': False,  # route X-E1: proceed wanted
    'S_R46': False,  # route X-E1: proceed
    'H_R46': False,  # route X-E1: signal has been open
    'A_R47': False,  # route X-E1.2 active
    'B_R47': False,  # route X-E1.2 locked
    'W_R47': False,  # route X-E1.2: proceed wanted
    'S_R47': False,  # route X-E1.2: proceed
    'H_R47': False,  # route X-E1.2: signal has been open
    'A_R48': False,  # route X-E3 active
    'B_R48': False,  # route X-E3 locked
    'W_R48': False,  # route X-E3: proceed wanted
    'S_R48': False,  # route X-E3: proceed
    'H_R48': False,  # route X-E3: signal has been open
    'A_R49': False,  # route X-E3.2 active
    'B_R49': False,  # route X-E3.2 locked
    'W_R49': False,  # route X-E3.2: proceed wanted
    'S_R49': False,  # route X-E3.2: proceed
    'H_R49': False,  # route X-E3.2: signal has been open
    'A_R50': False,  # route X-E3.3 active
    'B_R50': False,  # route X-E3.3 locked
    'W_R50': False,  # route X-E3.3: proceed wanted
    'S_R50': False,  # route X-E3.3: proceed
    'H_R50': False,  # route X-E3.3: signal has been open
    'A_R51': False,  # route X-E3.4 active
    'B_R51': False,  # route X-E3.4 locked
    'W_R51': False,  # route X-E3.4: proceed wanted
    'S_R51': False,  # route X-E3.4: proceed
    'H_R51': False,  # route X-E3.4: signal has been open
    'A_R52': False,  # route X-E4 active
    'B_R52': False,  # route X-E4 locked
    'W_R52': False,  # route X-E4: proceed wanted
    'S_R52': False,  # route X-E4: proceed
    'H_R52': False,  # route X-E4: signal has been open
    'A_R53': False,  # route X-E4.2 active
    'B_R53': False,  # route X-E4.2 locked
    'W_R53': False,  # route X-E4.2: proceed wanted
    'S_R53': False,  # route X-E4.2: proceed
    'H_R53': False,  # route X-E4.2: signal has been open
    'A_R54': False,  # route X-E5 active
    'B_R54': False,  # route X-E5 locked
    'W_R54': False,  # route X-E5: proceed wanted
    'S_R54': False,  # route X-E5: proceed
    'H_R54': False,  # route X-E5: signal has been open
    'A_R55': False,  # route X-E5.2 active
    'B_R55': False,  # route X-E5.2 locked
    'W_R55': False,  # route X-E5.2: proceed wanted
    'S_R55': False,  # route X-E5.2: proceed
    'H_R55': False,  # route X-E5.2: signal has been open
    'A_R56': False,  # route X-E1.c active
    'B_R56': False,  # route X-E1.c locked
    'W_R56': False,  # route X-E1.c: proceed wanted
    'S_R56': False,  # route X-E1.c: proceed
    'H_R56': False,  # route X-E1.c: signal has been open
    'A_R57': False,  # route X-E1.c.2 active
    'B_R57': False,  # route X-E1.c.2 locked
    'W_R57': False,  # route X-E1.c.2: proceed wanted
    'S_R57': False,  # route X-E1.c.2: proceed
    'H_R57': False,  # route X-E1.c.2: signal has been open
    'A_R58': False,  # route X-E3.c active
    'B_R58': False,  # route X-E3.c locked
    'W_R58': False,  # route X-E3.c: proceed wanted
    'S_R58': False,  # route X-E3.c: proceed
    'H_R58': False,  # route X-E3.c: signal has been open
    'A_R59': False,  # route X-E3.c.2 active
    'B_R59': False,  # route X-E3.c.2 locked
    'W_R59': False,  # route X-E3.c.2: proceed wanted
    'S_R59': False,  # route X-E3.c.2: proceed
    'H_R59': False,  # route X-E3.c.2: signal has been open
    'A_R60': False,  # route X-E3.c.3 active
    'B_R60': False,  # route X-E3.c.3 locked
    'W_R60': False,  # route X-E3.c.3: proceed wanted
    'S_R60': False,  # route X-E3.c.3: proceed
    'H_R60': False,  # route X-E3.c.3: signal has been open
    'A_R61': False,  # route X-E3.c.4 active
    'B_R61': False,  # route X-E3.c.4 locked
    'W_R61': False,  # route X-E3.c.4: proceed wanted
    'S_R61': False,  # route X-E3.c.4: proceed
    'H_R61': False,  # route X-E3.c.4: signal has been open
    'A_R62': False,  # route X-E4.c active
    'B_R62': False,  # route X-E4.c locked
    'W_R62': False,  # route X-E4.c: proceed wanted
    'S_R62': False,  # route X-E4.c: proceed
    'H_R62': False,  # route X-E4.c: signal has been open
    'A_R63': False,  # route X-E4.c.2 active
    'B_R63': False,  # route X-E4.c.2 locked
    'W_R63': False,  # route X-E4.c.2: proceed wanted
    'S_R63': False,  # route X-E4.c.2: proceed
    'H_R63': False,  # route X-E4.c.2: signal has been open
    'A_R64': False,  # route X-E5.c active
    'B_R64': False,  # route X-E5.c locked
    'W_R64': False,  # route X-E5.c: proceed wanted
    'S_R64': False,  # route X-E5.c: proceed
    'H_R64': False,  # route X-E5.c: signal has been open
    'A_R65': False,  # route X-E5.c.2 active
    'B_R65': False,  # route X-E5.c.2 locked
    'W_R65': False,  # route X-E5.c.2: proceed wanted
    'S_R65': False,  # route X-E5.c.2: proceed
    'H_R65': False,  # route X-E5.c.2: signal has been open
    'A_R66': False,  # route XD-E1 active
    'B_R66': False,  # route XD-E1 locked
    'W_R66': False,  # route XD-E1: proceed wanted
    'S_R66': False,  # route XD-E1: proceed
    'H_R66': False,  # route XD-E1: signal has been open
    'A_R67': False,  # route XD-E3 active
    'B_R67': False,  # route XD-E3 locked
    'W_R67': False,  # route XD-E3: proceed wanted
    'S_R67': False,  # route XD-E3: proceed
    'H_R67': False,  # route XD-E3: signal has been open
    'A_R68': False,  # route XD-E3.2 active
    'B_R68': False,  # route XD-E3.2 locked
    'W_R68': False,  # route XD-E3.2: proceed wanted
    'S_R68': False,  # route XD-E3.2: proceed
    'H_R68': False,  # route XD-E3.2: signal has been open
    'A_R69': False,  # route XD-E4 active
    'B_R69': False,  # route XD-E4 locked
    'W_R69': False,  # route XD-E4: proceed wanted
    'S_R69': False,  # route XD-E4: proceed
    'H_R69': False,  # route XD-E4: signal has been open
    'A_R70': False,  # route XD-E5 active
    'B_R70': False,  # route XD-E5 locked
    'W_R70': False,  # route XD-E5: proceed wanted
    'S_R70': False,  # route XD-E5: proceed
    'H_R70': False,  # route XD-E5: signal has been open
    'A_R71': False,  # route XD-E1.c active
    'B_R71': False,  # route XD-E1.c locked
    'W_R71': False,  # route XD-E1.c: proceed wanted
    'S_R71': False,  # route XD-E1.c: proceed
    'H_R71': False,  # route XD-E1.c: signal has been open
    'A_R72': False,  # route XD-E3.c active
    'B_R72': False,  # route XD-E3.c locked
    'W_R72': False,  # route XD-E3.c: proceed wanted
    'S_R72': False,  # route XD-E3.c: proceed
    'H_R72': False,  # route XD-E3.c: signal has been open
    'A_R73': False,  # route XD-E3.c.2 active
    'B_R73': False,  # route XD-E3.c.2 locked
    'W_R73': False,  # route XD-E3.c.2: proceed wanted
    'S_R73': False,  # route XD-E3.c.2: proceed
    'H_R73': False,  # route XD-E3.c.2: signal has been open
    'A_R74': False,  # route XD-E4.c active
    'B_R74': False,  # route XD-E4.c locked
    'W_R74': False,  # route XD-E4.c: proceed wanted
    'S_R74': False,  # route XD-E4.c: proceed
    'H_R74': False,  # route XD-E4.c: signal has been open
    'A_R75': False,  # route XD-E5.c active
    'B_R75': False,  # route XD-E5.c locked
    'W_R75': False,  # route XD-E5.c: proceed wanted
    'S_R75': False,  # route XD-E5.c: proceed
    'H_R75': False,  # route XD-E5.c: signal has been open
    'X_D1': False,  # D1: cancelling
    'X_D11': False,  # D11: cancelling
    'X_D13': False,  # D13: cancelling
    'X_D15': False,  # D15: cancelling
    'X_D17': False,  # D17: cancelling
    'X_D3': False,  # D3: cancelling
    'X_D5': False,  # D5: cancelling
    'X_D7': False,  # D7: cancelling
    'X_D9': False,  # D9: cancelling
    'X_S4': False,  # S4: cancelling
    'X_S5': False,  # S5: cancelling
    'X_SII': False,  # SII: cancelling
    'X_SIII': False,  # SIII: cancelling
    'X_X': False,  # X: cancelling
    'X_XD': False,  # XD: cancelling
    'N_R2': False,  # route D1-D9 is noted
    'T_R2': True,  # it is the turn of route D1-D9
    'N_R7': False,  # route D13-IG is noted
    'T_R7': False,  # it is the turn of route D13-IG
    'N_R20': False,  # route D9-D13 is noted
    'T_R20': False,  # it is the turn of route D9-D13
    'K_1_19WG': True,  # 1/19WG: restart lock (R16)
    'L_1_19WG_1': False,  # 1/19WG locked from 1/19WG|19-27DG@19.normal to 1/19WG|1DG@WG.0
    'L_1_19WG_2': False,  # 1/19WG locked from 1/19WG|1DG@WG.0 to 1/19WG|19-27DG@19.normal
    'M_1_19WG': False,  # 1/19WG locked for a train movement
    'F_1_19WG': False,  # 1/19WG firmly locked
    'U_1_19WG': True,  # 1/19WG used by a train (R9)
    'P_1_19WG': False,  # 1/19WG: the train went on (R9)
    'D_1_19WG': False,  # 1/19WG: detection is not relied on, inputs were lost or a train is called on
    'K_11_13DG': True,  # 11-13DG: restart lock (R16)
    'L_11_13DG_1': False,  # 11-13DG locked from 11-13DG|21DG@11.toe to 11-13DG|7DG@13.toe
    'L_11_13DG_2': False,  # 11-13DG locked from 11-13DG|21DG@11.toe to 11-13DG|9-15DG@11.reverse
    'L_11_13DG_3': False,  # 11-13DG locked from 11-13DG|7DG@13.toe to 11-13DG|21DG@11.toe
    'L_11_13DG_4': False,  # 11-13DG locked from 11-13DG|7DG@13.toe to 11-13DG|9-15DG@15.reverse
    'L_11_13DG_5': False,  # 11-13DG locked from 11-13DG|9-15DG@11.reverse to 11-13DG|21DG@11.toe
    'L_11_13DG_6': False,  # 11-13DG locked from 11-13DG|9-15DG@15.reverse to 11-13DG|7DG@13.toe
    'M_11_13DG': False,  # 11-13DG locked for a train movement
    'F_11_13DG': False,  # 11-13DG firmly locked
    'U_11_13DG': True,  # 11-13DG used by a train (R9)
    'P_11_13DG': False,  # 11-13DG: the train went on (R9)
    'D_11_13DG': False,  # 11-13DG: detection is not relied on, inputs were lost or a train is called on
    'K_17_23DG': True,  # 17-23DG: restart lock (R16)
    'L_17_23DG_1': False,  # 17-23DG locked from 17-23DG|19-27DG@x17.0 to 17-23DG|9-15DG@15.toe
    'L_17_23DG_2': False,  # 17-23DG locked from 17-23DG|25DG@x23.0 to 17-23DG|9-15DG@15.toe
    'L_17_23DG_3': False,  # 17-23DG locked from 17-23DG|9-15DG@15.toe to 17-23DG|19-27DG@x17.0
    'L_17_23DG_4': False,  # 17-23DG locked from 17-23DG|9-15DG@15.toe to 17-23DG|25DG@x23.0
    'L_17_23DG_5': False,  # 17-23DG locked from 17-23DG|9-15DG@15.toe to 17-23DG|IG@tI.0
    'L_17_23DG_6': False,  # 17-23DG locked from 17-23DG|IG@tI.0 to 17-23DG|9-15DG@15.toe
    'M_17_23DG': False,  # 17-23DG locked for a train movement
    'F_17_23DG': False,  # 17-23DG firmly locked
    'U_17_23DG': True,  # 17-23DG used by a train (R9)
    'P_17_23DG': False,  # 17-23DG: the train went on (R9)
    'D_17_23DG': False,  # 17-23DG: detection is not relied on, inputs were lost or a train is called on
    'K_19_27DG': True,  # 19-27DG: restart lock (R16)
    'L_19_27DG_1': False,  # 19-27DG locked from 1/19WG|19-27DG@19.normal to 19-27DG|4G@t4.0
    'L_19_27DG_2': False,  # 19-27DG locked from 1/19WG|19-27DG@19.normal to 19-27DG|IIG@tII.0
    'L_19_27DG_3': False,  # 19-27DG locked from 17-23DG|19-27DG@x17.0 to 19-27DG|4G@t4.0
    'L_19_27DG_4': False,  # 19-27DG locked from 17-23DG|19-27DG@x17.0 to 19-27DG|IIG@tII.0
    'L_19_27DG_5': False,  # 19-27DG locked from 19-27DG|4G@t4.0 to 1/19WG|19-27DG@19.normal
    'L_19_27DG_6': False,  # 19-27DG locked from 19-27DG|4G@t4.0 to 17-23DG|19-27DG@x17.0
    'L_19_27DG_7': False,  # 19-27DG locked from 19-27DG|IIG@tII.0 to 1/19WG|19-27DG@19.normal
    'L_19_27DG_8': False,  # 19-27DG locked from 19-27DG|IIG@tII.0 to 17-23DG|19-27DG@x17.0
    'M_19_27DG': False,  # 19-27DG locked for a train movement
    'F_19_27DG': False,  # 19-27DG firmly locked
    'U_19_27DG': True,  # 19-27DG used by a train (R9)
    'P_19_27DG': False,  # 19-27DG: the train went on (R9)
    'D_19_27DG': False,  # 19-27DG: detection is not relied on, inputs were lost or a train is called on
    'K_1DG': True,  # 1DG: restart lock (R16)
    'L_1DG_1': False,  # 1DG locked from 1/19WG|1DG@WG.0 to 1DG|IIAG@1.toe
    'L_1DG_2': False,  # 1DG locked from 1DG|3DG@x1.0 to 1DG|IIAG@1.toe
    'L_1DG_3': False,  # 1DG locked from 1DG|IIAG@1.toe to 1/19WG|1DG@WG.0
    'L_1DG_4': False,  # 1DG locked from 1DG|IIAG@1.toe to 1DG|3DG@x1.0
    'M_1DG': False,  # 1DG locked for a train movement
    'F_1DG': False,  # 1DG firmly locked
    'U_1DG': True,  # 1DG used by a train (R9)
    'P_1DG': False,  # 1DG: the train went on (R9)
    'D_1DG': False,  # 1DG: detection is not relied on, inputs were lost or a train is called on
    'K_21DG': True,  # 21DG: restart lock (R16)
    'L_21DG_1': False,  # 21DG locked from 11-13DG|21DG@11.toe to 21DG|25DG@21.normal
    'L_21DG_2': False,  # 21DG locked from 11-13DG|21DG@11.toe to 21DG|5G@t5.0
    'L_21DG_3': False,  # 21DG locked from 21DG|25DG@21.normal to 11-13DG|21DG@11.toe
    'L_21DG_4': False,  # 21DG locked from 21DG|5G@t5.0 to 11-13DG|21DG@11.toe
    'M_21DG': False,  # 21DG locked for a train movement
    'F_21DG': False,  # 21DG firmly locked
    'U_21DG': True,  # 21DG used by a train (R9)
    'P_21DG': False,  # 21DG: the train went on (R9)
    'D_21DG': False,  # 21DG: detection is not relied on, inputs were lost or a train is called on
    'K_25DG': True,  # 25DG: restart lock (R16)
    'L_25DG_1': False,  # 25DG locked from 17-23DG|25DG@x23.0 to 25DG|IIIG@tIII.0
    'L_25DG_2': False,  # 25DG locked from 21DG|25DG@21.normal to 25DG|IIIG@tIII.0
    'L_25DG_3': False,  # 25DG locked from 25DG|IIIG@tIII.0 to 17-23DG|25DG@x23.0
    'L_25DG_4': False,  # 25DG locked from 25DG|IIIG@tIII.0 to 21DG|25DG@21.normal
    'M_25DG': False,  # 25DG locked for a train movement
    'F_25DG': False,  # 25DG firmly locked
    'U_25DG': True,  # 25DG used by a train (R9)
    'P_25DG': False,  # 25DG: the train went on (R9)
    'D_25DG': False,  # 25DG: detection is not relied on, inputs were lost or a train is called on
    'K_3DG': True,  # 3DG: restart lock (R16)
    'L_3DG_1': False,  # 3DG locked from 1DG|3DG@x1.0 to 3DG|9-15DG@3-9.end
    'L_3DG_2': False,  # 3DG locked from 3DG|5DG@3.normal to 3DG|9-15DG@3-9.end
    'L_3DG_3': False,  # 3DG locked from 3DG|9-15DG@3-9.end to 1DG|3DG@x1.0
    'L_3DG_4': False,  # 3DG locked from 3DG|9-15DG@3-9.end to 3DG|5DG@3.normal
    'M_3DG': False,  # 3DG locked for a train movement
    'F_3DG': False,  # 3DG firmly locked
    'U_3DG': True,  # 3DG used by a train (R9)
    'P_3DG': False,  # 3DG: the train went on (R9)
    'D_3DG': False,  # 3DG: detection is not relied on, inputs were lost or a train is called on
    'K_4G': True,  # 4G: restart lock (R16)
    'L_4G_1': False,  # 4G locked from 19-27DG|4G@t4.0 to E4
    'M_4G': False,  # 4G locked for a train movement
    'F_4G': False,  # 4G firmly locked
    'U_4G': True,  # 4G used by a train (R9)
    'P_4G': False,  # 4G: the train went on (R9)
    'D_4G': False,  # 4G: detection is not relied on, inputs were lost or a train is called on
    'K_5DG': True,  # 5DG: restart lock (R16)
    'L_5DG_1': False,  # 5DG locked from 3DG|5DG@3.normal to 5DG|IAG@5.toe
    'L_5DG_2': False,  # 5DG locked from 5DG|7DG@x5.0 to 5DG|IAG@5.toe
    'L_5DG_3': False,  # 5DG locked from 5DG|IAG@5.toe to 3DG|5DG@3.normal
    'L_5DG_4': False,  # 5DG locked from 5DG|IAG@5.toe to 5DG|7DG@x5.0
    'M_5DG': False,  # 5DG locked for a train movement
    'F_5DG': False,  # 5DG firmly locked
    'U_5DG': True,  # 5DG used by a train (R9)
    'P_5DG': False,  # 5DG: the train went on (R9)
    'D_5DG': False,  # 5DG: detection is not relied on, inputs were lost or a train is called on
    'K_5G': True,  # 5G: restart lock (R16)
    'L_5G_1': False,  # 5G locked from 21DG|5G@t5.0 to E5
    'M_5G': False,  # 5G locked for a train movement
    'F_5G': False,  # 5G firmly locked
    'U_5G': True,  # 5G used by a train (R9)
    'P_5G': False,  # 5G: the train went on (R9)
    'D_5G': False,  # 5G: detection is not relied on, inputs were lost or a train is called on
    'K_7DG': True,  # 7DG: restart lock (R16)
    'L_7DG_1': False,  # 7DG locked from 11-13DG|7DG@13.toe to 5DG|7DG@x5.0
    'L_7DG_2': False,  # 7DG locked from 11-13DG|7DG@13.toe to DJ
    'L_7DG_3': False,  # 7DG locked from 5DG|7DG@x5.0 to 11-13DG|7DG@13.toe
    'L_7DG_4': False,  # 7DG locked from DJ to 11-13DG|7DG@13.toe
    'M_7DG': False,  # 7DG locked for a train movement
    'F_7DG': False,  # 7DG firmly locked
    'U_7DG': True,  # 7DG used by a train (R9)
    'P_7DG': False,  # 7DG: the train went on (R9)
    'D_7DG': False,  # 7DG: detection is not relied on, inputs were lost or a train is called on
    'K_9_15DG': True,  # 9-15DG: restart lock (R16)
    'L_9_15DG_1': False,  # 9-15DG locked from 11-13DG|9-15DG@11.reverse to 3DG|9-15DG@3-9.end
    'L_9_15DG_2': False,  # 9-15DG locked from 11-13DG|9-15DG@15.reverse to 17-23DG|9-15DG@15.toe
    'L_9_15DG_3': False,  # 9-15DG locked from 17-23DG|9-15DG@15.toe to 11-13DG|9-15DG@15.reverse
    'L_9_15DG_4': False,  # 9-15DG locked from 17-23DG|9-15DG@15.toe to 3DG|9-15DG@3-9.end
    'L_9_15DG_5': False,  # 9-15DG locked from 3DG|9-15DG@3-9.end to 11-13DG|9-15DG@11.reverse
    'L_9_15DG_6': False,  # 9-15DG locked from 3DG|9-15DG@3-9.end to 17-23DG|9-15DG@15.toe
    'M_9_15DG': False,  # 9-15DG locked for a train movement
    'F_9_15DG': False,  # 9-15DG firmly locked
    'U_9_15DG': True,  # 9-15DG used by a train (R9)
    'P_9_15DG': False,  # 9-15DG: the train went on (R9)
    'D_9_15DG': False,  # 9-15DG: detection is not relied on, inputs were lost or a train is called on
    'K_IAG': True,  # IAG: restart lock (R16)
    'L_IAG_1': False,  # IAG locked from 5DG|IAG@5.toe to BX
    'L_IAG_2': False,  # IAG locked from BX to 5DG|IAG@5.toe
    'M_IAG': False,  # IAG locked for a train movement
    'F_IAG': False,  # IAG firmly locked
    'U_IAG': True,  # IAG used by a train (R9)
    'P_IAG': False,  # IAG: the train went on (R9)
    'D_IAG': False,  # IAG: detection is not relied on, inputs were lost or a train is called on
    'K_IG': True,  # IG: restart lock (R16)
    'L_IG_1': False,  # IG locked from 17-23DG|IG@tI.0 to E1
    'M_IG': False,  # IG locked for a train movement
    'F_IG': False,  # IG firmly locked
    'U_IG': True,  # IG used by a train (R9)
    'P_IG': False,  # IG: the train went on (R9)
    'D_IG': False,  # IG: detection is not relied on, inputs were lost or a train is called on
    'K_IIAG': True,  # IIAG: restart lock (R16)
    'L_IIAG_1': False,  # IIAG locked from 1DG|IIAG@1.toe to BS
    'M_IIAG': False,  # IIAG locked for a train movement
    'F_IIAG': False,  # IIAG firmly locked
    'U_IIAG': True,  # IIAG used by a train (R9)
    'P_IIAG': False,  # IIAG: the train went on (R9)
    'D_IIAG': False,  # IIAG: detection is not relied on, inputs were lost or a train is called on
    'K_IIG': True,  # IIG: restart lock (R16)
    'L_IIG_1': False,  # IIG locked from 19-27DG|IIG@tII.0 to E2
    'M_IIG': False,  # IIG locked for a train movement
    'F_IIG': False,  # IIG firmly locked
    'U_IIG': True,  # IIG used by a train (R9)
    'P_IIG': False,  # IIG: the train went on (R9)
    'D_IIG': False,  # IIG: detection is not relied on, inputs were lost or a train is called on
    'K_IIIG': True,  # IIIG: restart lock (R16)
    'L_IIIG_1': False,  # IIIG locked from 25DG|IIIG@tIII.0 to E3
    'M_IIIG': False,  # IIIG locked for a train movement
    'F_IIIG': False,  # IIIG firmly locked
    'U_IIIG': True,  # IIIG used by a train (R9)
    'P_IIIG': False,  # IIIG: the train went on (R9)
    'D_IIIG': False,  # IIIG: detection is not relied on, inputs were lost or a train is called on
    'C_S4': False,  # S4 shows clear
    'C_S5': False,  # S5 shows clear
    'C_SII': False,  # SII shows clear
    'C_SIII': False,  # SIII shows clear
    'C_X': False,  # X shows clear
    'C_XD': False,  # XD shows clear
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_D1': 30000,  # D1: approach locking delay (R8)
    'AT_D11': 30000,  # D11: approach locking delay (R8)
    'AT_D13': 30000,  # D13: approach locking delay (R8)
    'AT_D15': 30000,  # D15: approach locking delay (R8)
    'AT_D17': 30000,  # D17: approach locking delay (R8)
    'AT_D3': 30000,  # D3: approach locking delay (R8)
    'AT_D5': 30000,  # D5: approach locking delay (R8)
    'AT_D7': 30000,  # D7: approach locking delay (R8)
    'AT_D9': 30000,  # D9: approach locking delay (R8)
    'AT_S4': 180000,  # S4: approach locking delay (R8)
    'AT_S5': 180000,  # S5: approach locking delay (R8)
    'AT_SII': 180000,  # SII: approach locking delay (R8)
    'AT_SIII': 180000,  # SIII: approach locking delay (R8)
    'AT_X': 180000,  # X: approach locking delay (R8)
    'AT_XD': 180000,  # XD: approach locking delay (R8)
    'RT_1_19WG': 3000,  # 1/19WG: release delay (R9)
    'RT_11_13DG': 3000,  # 11-13DG: release delay (R9)
    'RT_17_23DG': 3000,  # 17-23DG: release delay (R9)
    'RT_19_27DG': 3000,  # 19-27DG: release delay (R9)
    'RT_1DG': 3000,  # 1DG: release delay (R9)
    'RT_21DG': 3000,  # 21DG: release delay (R9)
    'RT_25DG': 3000,  # 25DG: release delay (R9)
    'RT_3DG': 3000,  # 3DG: release delay (R9)
    'RT_4G': 3000,  # 4G: release delay (R9)
    'RT_5DG': 3000,  # 5DG: release delay (R9)
    'RT_5G': 3000,  # 5G: release delay (R9)
    'RT_7DG': 3000,  # 7DG: release delay (R9)
    'RT_9_15DG': 3000,  # 9-15DG: release delay (R9)
    'RT_IAG': 3000,  # IAG: release delay (R9)
    'RT_IG': 3000,  # IG: release delay (R9)
    'RT_IIAG': 3000,  # IIAG: release delay (R9)
    'RT_IIG': 3000,  # IIG: release delay (R9)
    'RT_IIIG': 3000,  # IIIG: release delay (R9)
    'ST_1_3': 13000,  # machine 1/3: time-out
    'ST_13_15': 13000,  # machine 13/15: time-out
    'ST_17_19': 13000,  # machine 17/19: time-out
    'ST_21': 13000,  # machine 21: time-out
    'ST_23_25': 13000,  # machine 23/25: time-out
    'ST_27': 13000,  # machine 27: time-out
    'ST_5_7': 13000,  # machine 5/7: time-out
    'ST_9_11': 13000,  # machine 9/11: time-out
    'SGT': 500,  # the gap since the last start is over (R10)
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_1_3': False,  # machine 1/3: normal
    'YR_1_3': False,  # machine 1/3: reverse
    'YN_13_15': False,  # machine 13/15: normal
    'YR_13_15': False,  # machine 13/15: reverse
    'YN_17_19': False,  # machine 17/19: normal
    'YR_17_19': False,  # machine 17/19: reverse
    'YN_21': False,  # machine 21: normal
    'YR_21': False,  # machine 21: reverse
    'YN_23_25': False,  # machine 23/25: normal
    'YR_23_25': False,  # machine 23/25: reverse
    'YN_27': False,  # machine 27: normal
    'YR_27': False,  # machine 27: reverse
    'YN_5_7': False,  # machine 5/7: normal
    'YR_5_7': False,  # machine 5/7: reverse
    'YN_9_11': False,  # machine 9/11: normal
    'YR_9_11': False,  # machine 9/11: reverse
    'YA_1_3': False,  # alarm: machine 1/3 not detected in time
    'YA_13_15': False,  # alarm: machine 13/15 not detected in time
    'YA_17_19': False,  # alarm: machine 17/19 not detected in time
    'YA_21': False,  # alarm: machine 21 not detected in time
    'YA_23_25': False,  # alarm: machine 23/25 not detected in time
    'YA_27': False,  # alarm: machine 27 not detected in time
    'YA_5_7': False,  # alarm: machine 5/7 not detected in time
    'YA_9_11': False,  # alarm: machine 9/11 not detected in time
    'YT_1_3': False,  # alarm: machine 1/3 was trailed
    'YT_13_15': False,  # alarm: machine 13/15 was trailed
    'YT_17_19': False,  # alarm: machine 17/19 was trailed
    'YT_21': False,  # alarm: machine 21 was trailed
    'YT_23_25': False,  # alarm: machine 23/25 was trailed
    'YT_27': False,  # alarm: machine 27 was trailed
    'YT_5_7': False,  # alarm: machine 5/7 was trailed
    'YT_9_11': False,  # alarm: machine 9/11 was trailed
    'YL_1_19WG': True,  # indication: 1/19WG is locked
    'YL_11_13DG': True,  # indication: 11-13DG is locked
    'YL_17_23DG': True,  # indication: 17-23DG is locked
    'YL_19_27DG': True,  # indication: 19-27DG is locked
    'YL_1DG': True,  # indication: 1DG is locked
    'YL_21DG': True,  # indication: 21DG is locked
    'YL_25DG': True,  # indication: 25DG is locked
    'YL_3DG': True,  # indication: 3DG is locked
    'YL_4G': True,  # indication: 4G is locked
    'YL_5DG': True,  # indication: 5DG is locked
    'YL_5G': True,  # indication: 5G is locked
    'YL_7DG': True,  # indication: 7DG is locked
    'YL_9_15DG': True,  # indication: 9-15DG is locked
    'YL_IAG': True,  # indication: IAG is locked
    'YL_IG': True,  # indication: IG is locked
    'YL_IIAG': True,  # indication: IIAG is locked
    'YL_IIG': True,  # indication: IIG is locked
    'YL_IIIG': True,  # indication: IIIG is locked
    'YW_D1': False,  # signal D1: shunt (white)
    'YS_D1': True,  # signal D1: stop
    'YW_D11': False,  # signal D11: shunt (white)
    'YS_D11': True,  # signal D11: stop
    'YW_D13': False,  # signal D13: shunt (white)
    'YS_D13': True,  # signal D13: stop
    'YW_D15': False,  # signal D15: shunt (white)
    'YS_D15': True,  # signal D15: stop
    'YW_D17': False,  # signal D17: shunt (white)
    'YS_D17': True,  # signal D17: stop
    'YW_D3': False,  # signal D3: shunt (white)
    'YS_D3': True,  # signal D3: stop
    'YW_D5': False,  # signal D5: shunt (white)
    'YS_D5': True,  # signal D5: stop
    'YW_D7': False,  # signal D7: shunt (white)
    'YS_D7': True,  # signal D7: stop
    'YW_D9': False,  # signal D9: shunt (white)
    'YS_D9': True,  # signal D9: stop
    'YP_S4': False,  # signal S4: clear (green)
    'YY_S4': False,  # signal S4: caution (yellow)
    'YW_S4': False,  # signal S4: shunt (white)
    'YS_S4': True,  # signal S4: stop
    'YP_S5': False,  # signal S5: clear (green)
    'YY_S5': False,  # signal S5: caution (yellow)
    'YW_S5': False,  # signal S5: shunt (white)
    'YS_S5': True,  # signal S5: stop
    'YP_SII': False,  # signal SII: clear (green)
    'YY_SII': False,  # signal SII: caution (yellow)
    'YW_SII': False,  # signal SII: shunt (white)
    'YS_SII': True,  # signal SII: stop
    'YP_SIII': False,  # signal SIII: clear (green)
    'YY_SIII': False,  # signal SIII: caution (yellow)
    'YW_SIII': False,  # signal SIII: shunt (white)
    'YS_SIII': True,  # signal SIII: stop
    'YP_X': False,  # signal X: clear (green)
    'YY_X': False,  # signal X: caution (yellow)
    'YO_X': False,  # signal X: call-on, beside stop
    'YS_X': True,  # signal X: stop
    'YP_XD': False,  # signal XD: clear (green)
    'YY_XD': False,  # signal XD: caution (yellow)
    'YO_XD': False,  # signal XD: call-on, beside stop
    'YS_XD': True,  # signal XD: stop
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
        CAN_D1 = read['CAN_D1']
        CAN_D11 = read['CAN_D11']
        CAN_D13 = read['CAN_D13']
        CAN_D15 = read['CAN_D15']
        CAN_D17 = read['CAN_D17']
        CAN_D3 = read['CAN_D3']
        CAN_D5 = read['CAN_D5']
        CAN_D7 = read['CAN_D7']
        CAN_D9 = read['CAN_D9']
        CAN_S4 = read['CAN_S4']
        CAN_S5 = read['CAN_S5']
        CAN_SII = read['CAN_SII']
        CAN_SIII = read['CAN_SIII']
        CAN_X = read['CAN_X']
        CAN_XD = read['CAN_XD']
        RL_D1 = read['RL_D1']
        RL_D11 = read['RL_D11']
        RL_D13 = read['RL_D13']
        RL_D15 = read['RL_D15']
        RL_D17 = read['RL_D17']
        RL_D3 = read['RL_D3']
        RL_D5 = read['RL_D5']
        RL_D7 = read['RL_D7']
        RL_D9 = read['RL_D9']
        RL_S4 = read['RL_S4']
        RL_S5 = read['RL_S5']
        RL_SII = read['RL_SII']
        RL_SIII = read['RL_SIII']
        RL_X = read['RL_X']
        RL_XD = read['RL_XD']
        GL_S4 = read['GL_S4']
        CL_S4 = read['CL_S4']
        GL_S5 = read['GL_S5']
        CL_S5 = read['CL_S5']
        GL_SII = read['GL_SII']
        CL_SII = read['CL_SII']
        GL_SIII = read['GL_SIII']
        CL_SIII = read['CL_SIII']
        GL_X = read['GL_X']
        CL_X = read['CL_X']
        GL_XD = read['GL_XD']
        CL_XD = read['CL_XD']
        E_BF_BS = read['E_BF_BS']
        E_BF_DJ = read['E_BF_DJ']
        REQ = read['REQ']
        VOY = read['VOY']
        CLR_1_19WG = read['CLR_1_19WG']
        CLR_11_13DG = read['CLR_11_13DG']
        CLR_17_23DG = read['CLR_17_23DG']
        CLR_19_27DG = read['CLR_19_27DG']
        CLR_1DG = read['CLR_1DG']
        CLR_21DG = read['CLR_21DG']
        CLR_25DG = read['CLR_25DG']
        CLR_3DG = read['CLR_3DG']
        CLR_4G = read['CLR_4G']
        CLR_5DG = read['CLR_5DG']
        CLR_5G = read['CLR_5G']
        CLR_7DG = read['CLR_7DG']
        CLR_9_15DG = read['CLR_9_15DG']
        CLR_IAG = read['CLR_IAG']
        CLR_IG = read['CLR_IG']
        CLR_IIAG = read['CLR_IIAG']
        CLR_IIG = read['CLR_IIG']
        CLR_IIIG = read['CLR_IIIG']
        CLR_XDJG = read['CLR_XDJG']
        CLR_XJG = read['CLR_XJG']
        REL_1_19WG = read['REL_1_19WG']
        REL_11_13DG = read['REL_11_13DG']
        REL_17_23DG = read['REL_17_23DG']
        REL_19_27DG = read['REL_19_27DG']
        REL_1DG = read['REL_1DG']
        REL_21DG = read['REL_21DG']
        REL_25DG = read['REL_25DG']
        REL_3DG = read['REL_3DG']
        REL_4G = read['REL_4G']
        REL_5DG = read['REL_5DG']
        REL_5G = read['REL_5G']
        REL_7DG = read['REL_7DG']
        REL_9_15DG = read['REL_9_15DG']
        REL_IAG = read['REL_IAG']
        REL_IG = read['REL_IG']
        REL_IIAG = read['REL_IIAG']
        REL_IIG = read['REL_IIG']
        REL_IIIG = read['REL_IIIG']
        BLK_1_19WG = read['BLK_1_19WG']
        BLK_11_13DG = read['BLK_11_13DG']
        BLK_17_23DG = read['BLK_17_23DG']
        BLK_19_27DG = read['BLK_19_27DG']
        BLK_1DG = read['BLK_1DG']
        BLK_21DG = read['BLK_21DG']
        BLK_25DG = read['BLK_25DG']
        BLK_3DG = read['BLK_3DG']
        BLK_4G = read['BLK_4G']
        BLK_5DG = read['BLK_5DG']
        BLK_5G = read['BLK_5G']
        BLK_7DG = read['BLK_7DG']
        BLK_9_15DG = read['BLK_9_15DG']
        BLK_IAG = read['BLK_IAG']
        BLK_IG = read['BLK_IG']
        BLK_IIAG = read['BLK_IIAG']
        BLK_IIG = read['BLK_IIG']
        BLK_IIIG = read['BLK_IIIG']
        RELALL = read['RELALL']
        DN_1_3 = read['DN_1_3']
        DR_1_3 = read['DR_1_3']
        MN_1_3 = read['MN_1_3']
        MR_1_3 = read['MR_1_3']
        TC_1_3 = read['TC_1_3']
        DN_13_15 = read['DN_13_15']
        DR_13_15 = read['DR_13_15']
        MN_13_15 = read['MN_13_15']
        MR_13_15 = read['MR_13_15']
        TC_13_15 = read['TC_13_15']
        DN_17_19 = read['DN_17_19']
        DR_17_19 = read['DR_17_19']
        MN_17_19 = read['MN_17_19']
        MR_17_19 = read['MR_17_19']
        TC_17_19 = read['TC_17_19']
        DN_21 = read['DN_21']
        DR_21 = read['DR_21']
        MN_21 = read['MN_21']
        MR_21 = read['MR_21']
        TC_21 = read['TC_21']
        DN_23_25 = read['DN_23_25']
        DR_23_25 = read['DR_23_25']
        MN_23_25 = read['MN_23_25']
        MR_23_25 = read['MR_23_25']
        TC_23_25 = read['TC_23_25']
        DN_27 = read['DN_27']
        DR_27 = read['DR_27']
        MN_27 = read['MN_27']
        MR_27 = read['MR_27']
        TC_27 = read['TC_27']
        DN_5_7 = read['DN_5_7']
        DR_5_7 = read['DR_5_7']
        MN_5_7 = read['MN_5_7']
        MR_5_7 = read['MR_5_7']
        TC_5_7 = read['TC_5_7']
        DN_9_11 = read['DN_9_11']
        DR_9_11 = read['DR_9_11']
        MN_9_11 = read['MN_9_11']
        MR_9_11 = read['MR_9_11']
        TC_9_11 = read['TC_9_11']
        CN_1_3 = old['CN_1_3']
        CR_1_3 = old['CR_1_3']
        CN_13_15 = old['CN_13_15']
        CR_13_15 = old['CR_13_15']
        CN_17_19 = old['CN_17_19']
        CR_17_19 = old['CR_17_19']
        CN_21 = old['CN_21']
        CR_21 = old['CR_21']
        CN_23_25 = old['CN_23_25']
        CR_23_25 = old['CR_23_25']
        CN_27 = old['CN_27']
        CR_27 = old['CR_27']
        CN_5_7 = old['CN_5_7']
        CR_5_7 = old['CR_5_7']
        CN_9_11 = old['CN_9_11']
        CR_9_11 = old['CR_9_11']
        AL_1_3 = old['AL_1_3']
        AL_13_15 = old['AL_13_15']
        AL_17_19 = old['AL_17_19']
        AL_21 = old['AL_21']
        AL_23_25 = old['AL_23_25']
        AL_27 = old['AL_27']
        AL_5_7 = old['AL_5_7']
        AL_9_11 = old['AL_9_11']
        TH_1_3 = old['TH_1_3']
        TR_1_3 = old['TR_1_3']
        TH_13_15 = old['TH_13_15']
        TR_13_15 = old['TR_13_15']
        TH_17_19 = old['TH_17_19']
        TR_17_19 = old['TR_17_19']
        TH_21 = old['TH_21']
        TR_21 = old['TR_21']
        TH_23_25 = old['TH_23_25']
        TR_23_25 = old['TR_23_25']
        TH_27 = old['TH_27']
        TR_27 = old['TR_27']
        TH_5_7 = old['TH_5_7']
        TR_5_7 = old['TR_5_7']
        TH_9_11 = old['TH_9_11']
        TR_9_11 = old['TR_9_11']
        Z_1_3 = old['Z_1_3']
        Z_13_15 = old['Z_13_15']
        Z_17_19 = old['Z_17_19']
        Z_21 = old['Z_21']
        Z_23_25 = old['Z_23_25']
        Z_27 = old['Z_27']
        Z_5_7 = old['Z_5_7']
        Z_9_11 = old['Z_9_11']
        SG = old['SG']
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
        PA_R17 = old['PA_R17']
        S_R17 = old['S_R17']
        H_R17 = old['H_R17']
        A_R18 = old['A_R18']
        B_R18 = old['B_R18']
        W_R18 = old['W_R18']
        PA_R18 = old['PA_R18']
        S_R18 = old['S_R18']
        H_R18 = old['H_R18']
        A_R19 = old['A_R19']
        B_R19 = old['B_R19']
        W_R19 = old['W_R19']
        PA_R19 = old['PA_R19']
        S_R19 = old['S_R19']
        H_R19 = old['H_R19']
        A_R20 = old['A_R20']
        B_R20 = old['B_R20']
        W_R20 = old['W_R20']
        PA_R20 = old['PA_R20']
        S_R20 = old['S_R20']
        H_R20 = old['H_R20']
        A_R21 = old['A_R21']
        B_R21 = old['B_R21']
        W_R21 = old['W_R21']
        PA_R21 = old['PA_R21']
        S_R21 = old['S_R21']
        H_R21 = old['H_R21']
        A_R22 = old['A_R22']
        B_R22 = old['B_R22']
        W_R22 = old['W_R22']
        S_R22 = old['S_R22']
        H_R22 = old['H_R22']
        A_R23 = old['A_R23']
        B_R23 = old['B_R23']
        W_R23 = old['W_R23']
        S_R23 = old['S_R23']
        H_R23 = old['H_R23']
        A_R24 = old['A_R24']
        B_R24 = old['B_R24']
        W_R24 = old['W_R24']
        S_R24 = old['S_R24']
        H_R24 = old['H_R24']
        A_R25 = old['A_R25']
        B_R25 = old['B_R25']
        W_R25 = old['W_R25']
        S_R25 = old['S_R25']
        H_R25 = old['H_R25']
        A_R26 = old['A_R26']
        B_R26 = old['B_R26']
        W_R26 = old['W_R26']
        S_R26 = old['S_R26']
        H_R26 = old['H_R26']
        A_R27 = old['A_R27']
        B_R27 = old['B_R27']
        W_R27 = old['W_R27']
        S_R27 = old['S_R27']
        H_R27 = old['H_R27']
        A_R28 = old['A_R28']
        B_R28 = old['B_R28']
        W_R28 = old['W_R28']
        S_R28 = old['S_R28']
        H_R28 = old['H_R28']
        A_R29 = old['A_R29']
        B_R29 = old['B_R29']
        W_R29 = old['W_R29']
        S_R29 = old['S_R29']
        H_R29 = old['H_R29']
        A_R30 = old['A_R30']
        B_R30 = old['B_R30']
        W_R30 = old['W_R30']
        S_R30 = old['S_R30']
        H_R30 = old['H_R30']
        A_R31 = old['A_R31']
        B_R31 = old['B_R31']
        W_R31 = old['W_R31']
        S_R31 = old['S_R31']
        H_R31 = old['H_R31']
        A_R32 = old['A_R32']
        B_R32 = old['B_R32']
        W_R32 = old['W_R32']
        S_R32 = old['S_R32']
        H_R32 = old['H_R32']
        A_R33 = old['A_R33']
        B_R33 = old['B_R33']
        W_R33 = old['W_R33']
        S_R33 = old['S_R33']
        H_R33 = old['H_R33']
        A_R34 = old['A_R34']
        B_R34 = old['B_R34']
        W_R34 = old['W_R34']
        S_R34 = old['S_R34']
        H_R34 = old['H_R34']
        A_R35 = old['A_R35']
        B_R35 = old['B_R35']
        W_R35 = old['W_R35']
        S_R35 = old['S_R35']
        H_R35 = old['H_R35']
        A_R36 = old['A_R36']
        B_R36 = old['B_R36']
        W_R36 = old['W_R36']
        S_R36 = old['S_R36']
        H_R36 = old['H_R36']
        A_R37 = old['A_R37']
        B_R37 = old['B_R37']
        W_R37 = old['W_R37']
        S_R37 = old['S_R37']
        H_R37 = old['H_R37']
        A_R38 = old['A_R38']
        B_R38 = old['B_R38']
        W_R38 = old['W_R38']
        S_R38 = old['S_R38']
        H_R38 = old['H_R38']
        A_R39 = old['A_R39']
        B_R39 = old['B_R39']
        W_R39 = old['W_R39']
        S_R39 = old['S_R39']
        H_R39 = old['H_R39']
        A_R40 = old['A_R40']
        B_R40 = old['B_R40']
        W_R40 = old['W_R40']
        S_R40 = old['S_R40']
        H_R40 = old['H_R40']
        A_R41 = old['A_R41']
        B_R41 = old['B_R41']
        W_R41 = old['W_R41']
        S_R41 = old['S_R41']
        H_R41 = old['H_R41']
        A_R42 = old['A_R42']
        B_R42 = old['B_R42']
        W_R42 = old['W_R42']
        S_R42 = old['S_R42']
        H_R42 = old['H_R42']
        A_R43 = old['A_R43']
        B_R43 = old['B_R43']
        W_R43 = old['W_R43']
        S_R43 = old['S_R43']
        H_R43 = old['H_R43']
        A_R44 = old['A_R44']
        B_R44 = old['B_R44']
        W_R44 = old['W_R44']
        S_R44 = old['S_R44']
        H_R44 = old['H_R44']
        A_R45 = old['A_R45']
        B_R45 = old['B_R45']
        W_R45 = old['W_R45']
        S_R45 = old['S_R45']
        H_R45 = old['H_R45']
        A_R46 = old['A_R46']
        B_R46 = old['B_R46']
        W_R46 = old['W_R46']
        S_R46 = old['S_R46']
        H_R46 = old['H_R46']
        A_R47 = old['A_R47']
        B_R47 = old['B_R47']
        W_R47 = old['W_R47']
        S_R47 = old['S_R47']
        H_R47 = old['H_R47']
        A_R48 = old['A_R48']
        B_R48 = old['B_R48']
        W_R48 = old['W_R48']
        S_R48 = old['S_R48']
        H_R48 = old['H_R48']
        A_R49 = old['A_R49']
        B_R49 = old['B_R49']
        W_R49 = old['W_R49']
        S_R49 = old['S_R49']
        H_R49 = old['H_R49']
        A_R50 = old['A_R50']
        B_R50 = old['B_R50']
        W_R50 = old['W_R50']
        S_R50 = old['S_R50']
        H_R50 = old['H_R50']
        A_R51 = old['A_R51']
        B_R51 = old['B_R51']
        W_R51 = old['W_R51']
        S_R51 = old['S_R51']
        H_R51 = old['H_R51']
        A_R52 = old['A_R52']
        B_R52 = old['B_R52']
        W_R52 = old['W_R52']
        S_R52 = old['S_R52']
        H_R52 = old['H_R52']
        A_R53 = old['A_R53']
        B_R53 = old['B_R53']
        W_R53 = old['W_R53']
        S_R53 = old['S_R53']
        H_R53 = old['H_R53']
        A_R54 = old['A_R54']
        B_R54 = old['B_R54']
        W_R54 = old['W_R54']
        S_R54 = old['S_R54']
        H_R54 = old['H_R54']
        A_R55 = old['A_R55']
        B_R55 = old['B_R55']
        W_R55 = old['W_R55']
        S_R55 = old['S_R55']
        H_R55 = old['H_R55']
        A_R56 = old['A_R56']
        B_R56 = old['B_R56']
        W_R56 = old['W_R56']
        S_R56 = old['S_R56']
        H_R56 = old['H_R56']
        A_R57 = old['A_R57']
        B_R57 = old['B_R57']
        W_R57 = old['W_R57']
        S_R57 = old['S_R57']
        H_R57 = old['H_R57']
        A_R58 = old['A_R58']
        B_R58 = old['B_R58']
        W_R58 = old['W_R58']
        S_R58 = old['S_R58']
        H_R58 = old['H_R58']
        A_R59 = old['A_R59']
        B_R59 = old['B_R59']
        W_R59 = old['W_R59']
        S_R59 = old['S_R59']
        H_R59 = old['H_R59']
        A_R60 = old['A_R60']
        B_R60 = old['B_R60']
        W_R60 = old['W_R60']
        S_R60 = old['S_R60']
        H_R60 = old['H_R60']
        A_R61 = old['A_R61']
        B_R61 = old['B_R61']
        W_R61 = old['W_R61']
        S_R61 = old['S_R61']
        H_R61 = old['H_R61']
        A_R62 = old['A_R62']
        B_R62 = old['B_R62']
        W_R62 = old['W_R62']
        S_R62 = old['S_R62']
        H_R62 = old['H_R62']
        A_R63 = old['A_R63']
        B_R63 = old['B_R63']
        W_R63 = old['W_R63']
        S_R63 = old['S_R63']
        H_R63 = old['H_R63']
        A_R64 = old['A_R64']
        B_R64 = old['B_R64']
        W_R64 = old['W_R64']
        S_R64 = old['S_R64']
        H_R64 = old['H_R64']
        A_R65 = old['A_R65']
        B_R65 = old['B_R65']
        W_R65 = old['W_R65']
        S_R65 = old['S_R65']
        H_R65 = old['H_R65']
        A_R66 = old['A_R66']
        B_R66 = old['B_R66']
        W_R66 = old['W_R66']
        S_R66 = old['S_R66']
        H_R66 = old['H_R66']
        A_R67 = old['A_R67']
        B_R67 = old['B_R67']
        W_R67 = old['W_R67']
        S_R67 = old['S_R67']
        H_R67 = old['H_R67']
        A_R68 = old['A_R68']
        B_R68 = old['B_R68']
        W_R68 = old['W_R68']
        S_R68 = old['S_R68']
        H_R68 = old['H_R68']
        A_R69 = old['A_R69']
        B_R69 = old['B_R69']
        W_R69 = old['W_R69']
        S_R69 = old['S_R69']
        H_R69 = old['H_R69']
        A_R70 = old['A_R70']
        B_R70 = old['B_R70']
        W_R70 = old['W_R70']
        S_R70 = old['S_R70']
        H_R70 = old['H_R70']
        A_R71 = old['A_R71']
        B_R71 = old['B_R71']
        W_R71 = old['W_R71']
        S_R71 = old['S_R71']
        H_R71 = old['H_R71']
        A_R72 = old['A_R72']
        B_R72 = old['B_R72']
        W_R72 = old['W_R72']
        S_R72 = old['S_R72']
        H_R72 = old['H_R72']
        A_R73 = old['A_R73']
        B_R73 = old['B_R73']
        W_R73 = old['W_R73']
        S_R73 = old['S_R73']
        H_R73 = old['H_R73']
        A_R74 = old['A_R74']
        B_R74 = old['B_R74']
        W_R74 = old['W_R74']
        S_R74 = old['S_R74']
        H_R74 = old['H_R74']
        A_R75 = old['A_R75']
        B_R75 = old['B_R75']
        W_R75 = old['W_R75']
        S_R75 = old['S_R75']
        H_R75 = old['H_R75']
        X_D1 = old['X_D1']
        X_D11 = old['X_D11']
        X_D13 = old['X_D13']
        X_D15 = old['X_D15']
        X_D17 = old['X_D17']
        X_D3 = old['X_D3']
        X_D5 = old['X_D5']
        X_D7 = old['X_D7']
        X_D9 = old['X_D9']
        X_S4 = old['X_S4']
        X_S5 = old['X_S5']
        X_SII = old['X_SII']
        X_SIII = old['X_SIII']
        X_X = old['X_X']
        X_XD = old['X_XD']
        N_R2 = old['N_R2']
        T_R2 = old['T_R2']
        N_R7 = old['N_R7']
        T_R7 = old['T_R7']
        N_R20 = old['N_R20']
        T_R20 = old['T_R20']
        K_1_19WG = old['K_1_19WG']
        L_1_19WG_1 = old['L_1_19WG_1']
        L_1_19WG_2 = old['L_1_19WG_2']
        M_1_19WG = old['M_1_19WG']
        F_1_19WG = old['F_1_19WG']
        U_1_19WG = old['U_1_19WG']
        P_1_19WG = old['P_1_19WG']
        D_1_19WG = old['D_1_19WG']
        K_11_13DG = old['K_11_13DG']
        L_11_13DG_1 = old['L_11_13DG_1']
        L_11_13DG_2 = old['L_11_13DG_2']
        L_11_13DG_3 = old['L_11_13DG_3']
        L_11_13DG_4 = old['L_11_13DG_4']
        L_11_13DG_5 = old['L_11_13DG_5']
        L_11_13DG_6 = old['L_11_13DG_6']
        M_11_13DG = old['M_11_13DG']
        F_11_13DG = old['F_11_13DG']
        U_11_13DG = old['U_11_13DG']
        P_11_13DG = old['P_11_13DG']
        D_11_13DG = old['D_11_13DG']
        K_17_23DG = old['K_17_23DG']
        L_17_23DG_1 = old['L_17_23DG_1']
        L_17_23DG_2 = old['L_17_23DG_2']
        L_17_23DG_3 = old['L_17_23DG_3']
        L_17_23DG_4 = old['L_17_23DG_4']
        L_17_23DG_5 = old['L_17_23DG_5']
        L_17_23DG_6 = old['L_17_23DG_6']
        M_17_23DG = old['M_17_23DG']
        F_17_23DG = old['F_17_23DG']
        U_17_23DG = old['U_17_23DG']
        P_17_23DG = old['P_17_23DG']
        D_17_23DG = old['D_17_23DG']
        K_19_27DG = old['K_19_27DG']
        L_19_27DG_1 = old['L_19_27DG_1']
        L_19_27DG_2 = old['L_19_27DG_2']
        L_19_27DG_3 = old['L_19_27DG_3']
        L_19_27DG_4 = old['L_19_27DG_4']
        L_19_27DG_5 = old['L_19_27DG_5']
        L_19_27DG_6 = old['L_19_27DG_6']
        L_19_27DG_7 = old['L_19_27DG_7']
        L_19_27DG_8 = old['L_19_27DG_8']
        M_19_27DG = old['M_19_27DG']
        F_19_27DG = old['F_19_27DG']
        U_19_27DG = old['U_19_27DG']
        P_19_27DG = old['P_19_27DG']
        D_19_27DG = old['D_19_27DG']
        K_1DG = old['K_1DG']
        L_1DG_1 = old['L_1DG_1']
        L_1DG_2 = old['L_1DG_2']
        L_1DG_3 = old['L_1DG_3']
        L_1DG_4 = old['L_1DG_4']
        M_1DG = old['M_1DG']
        F_1DG = old['F_1DG']
        U_1DG = old['U_1DG']
        P_1DG = old['P_1DG']
        D_1DG = old['D_1DG']
        K_21DG = old['K_21DG']
        L_21DG_1 = old['L_21DG_1']
        L_21DG_2 = old['L_21DG_2']
        L_21DG_3 = old['L_21DG_3']
        L_21DG_4 = old['L_21DG_4']
        M_21DG = old['M_21DG']
        F_21DG = old['F_21DG']
        U_21DG = old['U_21DG']
        P_21DG = old['P_21DG']
        D_21DG = old['D_21DG']
        K_25DG = old['K_25DG']
        L_25DG_1 = old['L_25DG_1']
        L_25DG_2 = old['L_25DG_2']
        L_25DG_3 = old['L_25DG_3']
        L_25DG_4 = old['L_25DG_4']
        M_25DG = old['M_25DG']
        F_25DG = old['F_25DG']
        U_25DG = old['U_25DG']
        P_25DG = old['P_25DG']
        D_25DG = old['D_25DG']
        K_3DG = old['K_3DG']
        L_3DG_1 = old['L_3DG_1']
        L_3DG_2 = old['L_3DG_2']
        L_3DG_3 = old['L_3DG_3']
        L_3DG_4 = old['L_3DG_4']
        M_3DG = old['M_3DG']
        F_3DG = old['F_3DG']
        U_3DG = old['U_3DG']
        P_3DG = old['P_3DG']
        D_3DG = old['D_3DG']
        K_4G = old['K_4G']
        L_4G_1 = old['L_4G_1']
        M_4G = old['M_4G']
        F_4G = old['F_4G']
        U_4G = old['U_4G']
        P_4G = old['P_4G']
        D_4G = old['D_4G']
        K_5DG = old['K_5DG']
        L_5DG_1 = old['L_5DG_1']
        L_5DG_2 = old['L_5DG_2']
        L_5DG_3 = old['L_5DG_3']
        L_5DG_4 = old['L_5DG_4']
        M_5DG = old['M_5DG']
        F_5DG = old['F_5DG']
        U_5DG = old['U_5DG']
        P_5DG = old['P_5DG']
        D_5DG = old['D_5DG']
        K_5G = old['K_5G']
        L_5G_1 = old['L_5G_1']
        M_5G = old['M_5G']
        F_5G = old['F_5G']
        U_5G = old['U_5G']
        P_5G = old['P_5G']
        D_5G = old['D_5G']
        K_7DG = old['K_7DG']
        L_7DG_1 = old['L_7DG_1']
        L_7DG_2 = old['L_7DG_2']
        L_7DG_3 = old['L_7DG_3']
        L_7DG_4 = old['L_7DG_4']
        M_7DG = old['M_7DG']
        F_7DG = old['F_7DG']
        U_7DG = old['U_7DG']
        P_7DG = old['P_7DG']
        D_7DG = old['D_7DG']
        K_9_15DG = old['K_9_15DG']
        L_9_15DG_1 = old['L_9_15DG_1']
        L_9_15DG_2 = old['L_9_15DG_2']
        L_9_15DG_3 = old['L_9_15DG_3']
        L_9_15DG_4 = old['L_9_15DG_4']
        L_9_15DG_5 = old['L_9_15DG_5']
        L_9_15DG_6 = old['L_9_15DG_6']
        M_9_15DG = old['M_9_15DG']
        F_9_15DG = old['F_9_15DG']
        U_9_15DG = old['U_9_15DG']
        P_9_15DG = old['P_9_15DG']
        D_9_15DG = old['D_9_15DG']
        K_IAG = old['K_IAG']
        L_IAG_1 = old['L_IAG_1']
        L_IAG_2 = old['L_IAG_2']
        M_IAG = old['M_IAG']
        F_IAG = old['F_IAG']
        U_IAG = old['U_IAG']
        P_IAG = old['P_IAG']
        D_IAG = old['D_IAG']
        K_IG = old['K_IG']
        L_IG_1 = old['L_IG_1']
        M_IG = old['M_IG']
        F_IG = old['F_IG']
        U_IG = old['U_IG']
        P_IG = old['P_IG']
        D_IG = old['D_IG']
        K_IIAG = old['K_IIAG']
        L_IIAG_1 = old['L_IIAG_1']
        M_IIAG = old['M_IIAG']
        F_IIAG = old['F_IIAG']
        U_IIAG = old['U_IIAG']
        P_IIAG = old['P_IIAG']
        D_IIAG = old['D_IIAG']
        K_IIG = old['K_IIG']
        L_IIG_1 = old['L_IIG_1']
        M_IIG = old['M_IIG']
        F_IIG = old['F_IIG']
        U_IIG = old['U_IIG']
        P_IIG = old['P_IIG']
        D_IIG = old['D_IIG']
        K_IIIG = old['K_IIIG']
        L_IIIG_1 = old['L_IIIG_1']
        M_IIIG = old['M_IIIG']
        F_IIIG = old['F_IIIG']
        U_IIIG = old['U_IIIG']
        P_IIIG = old['P_IIIG']
        D_IIIG = old['D_IIIG']
        C_S4 = old['C_S4']
        C_S5 = old['C_S5']
        C_SII = old['C_SII']
        C_SIII = old['C_SIII']
        C_X = old['C_X']
        C_XD = old['C_XD']
        OCC_1_19WG = (not CLR_1_19WG) or (not VALID)  # 1/19WG counts as occupied
        OCC_11_13DG = (not CLR_11_13DG) or (not VALID)  # 11-13DG counts as occupied
        OCC_17_23DG = (not CLR_17_23DG) or (not VALID)  # 17-23DG counts as occupied
        OCC_19_27DG = (not CLR_19_27DG) or (not VALID)  # 19-27DG counts as occupied
        OCC_1DG = (not CLR_1DG) or (not VALID)  # 1DG counts as occupied
        OCC_21DG = (not CLR_21DG) or (not VALID)  # 21DG counts as occupied
        OCC_25DG = (not CLR_25DG) or (not VALID)  # 25DG counts as occupied
        OCC_3DG = (not CLR_3DG) or (not VALID)  # 3DG counts as occupied
        OCC_4G = (not CLR_4G) or (not VALID)  # 4G counts as occupied
        OCC_5DG = (not CLR_5DG) or (not VALID)  # 5DG counts as occupied
        OCC_5G = (not CLR_5G) or (not VALID)  # 5G counts as occupied
        OCC_7DG = (not CLR_7DG) or (not VALID)  # 7DG counts as occupied
        OCC_9_15DG = (not CLR_9_15DG) or (not VALID)  # 9-15DG counts as occupied
        OCC_IAG = (not CLR_IAG) or (not VALID)  # IAG counts as occupied
        OCC_IG = (not CLR_IG) or (not VALID)  # IG counts as occupied
        OCC_IIAG = (not CLR_IIAG) or (not VALID)  # IIAG counts as occupied
        OCC_IIG = (not CLR_IIG) or (not VALID)  # IIG counts as occupied
        OCC_IIIG = (not CLR_IIIG) or (not VALID)  # IIIG counts as occupied
        OCC_XDJG = (not CLR_XDJG) or (not VALID)  # XDJG counts as occupied
        OCC_XJG = (not CLR_XJG) or (not VALID)  # XJG counts as occupied
        FREE_1_19WG = (not K_1_19WG) and (not L_1_19WG_1) and (not L_1_19WG_2)  # 1/19WG is not locked by anybody
        FREE_11_13DG = (not K_11_13DG) and (not L_11_13DG_1) and (not L_11_13DG_2) and (not L_11_13DG_3) and (not L_11_13DG_4) and (not L_11_13DG_5) and (not L_11_13DG_6)  # 11-13DG is not locked by anybody
        FREE_17_23DG = (not K_17_23DG) and (not L_17_23DG_1) and (not L_17_23DG_2) and (not L_17_23DG_3) and (not L_17_23DG_4) and (not L_17_23DG_5) and (not L_17_23DG_6)  # 17-23DG is not locked by anybody
        FREE_19_27DG = (not K_19_27DG) and (not L_19_27DG_1) and (not L_19_27DG_2) and (not L_19_27DG_3) and (not L_19_27DG_4) and (not L_19_27DG_5) and (not L_19_27DG_6) and (not L_19_27DG_7) and (not L_19_27DG_8)  # 19-27DG is not locked by anybody
        FREE_1DG = (not K_1DG) and (not L_1DG_1) and (not L_1DG_2) and (not L_1DG_3) and (not L_1DG_4)  # 1DG is not locked by anybody
        FREE_21DG = (not K_21DG) and (not L_21DG_1) and (not L_21DG_2) and (not L_21DG_3) and (not L_21DG_4)  # 21DG is not locked by anybody
        FREE_25DG = (not K_25DG) and (not L_25DG_1) and (not L_25DG_2) and (not L_25DG_3) and (not L_25DG_4)  # 25DG is not locked by anybody
        FREE_3DG = (not K_3DG) and (not L_3DG_1) and (not L_3DG_2) and (not L_3DG_3) and (not L_3DG_4)  # 3DG is not locked by anybody
        FREE_4G = (not K_4G) and (not L_4G_1)  # 4G is not locked by anybody
        FREE_5DG = (not K_5DG) and (not L_5DG_1) and (not L_5DG_2) and (not L_5DG_3) and (not L_5DG_4)  # 5DG is not locked by anybody
        FREE_5G = (not K_5G) and (not L_5G_1)  # 5G is not locked by anybody
        FREE_7DG = (not K_7DG) and (not L_7DG_1) and (not L_7DG_2) and (not L_7DG_3) and (not L_7DG_4)  # 7DG is not locked by anybody
        FREE_9_15DG = (not K_9_15DG) and (not L_9_15DG_1) and (not L_9_15DG_2) and (not L_9_15DG_3) and (not L_9_15DG_4) and (not L_9_15DG_5) and (not L_9_15DG_6)  # 9-15DG is not locked by anybody
        FREE_IAG = (not K_IAG) and (not L_IAG_1) and (not L_IAG_2)  # IAG is not locked by anybody
        FREE_IG = (not K_IG) and (not L_IG_1)  # IG is not locked by anybody
        FREE_IIAG = (not K_IIAG) and (not L_IIAG_1)  # IIAG is not locked by anybody
        FREE_IIG = (not K_IIG) and (not L_IIG_1)  # IIG is not locked by anybody
        FREE_IIIG = (not K_IIIG) and (not L_IIIG_1)  # IIIG is not locked by anybody
        QN_1_3 = VALID and DN_1_3 and (not DR_1_3)  # machine 1/3 lies N (R10)
        QR_1_3 = VALID and DR_1_3 and (not DN_1_3)  # machine 1/3 lies R (R10)
        QN_13_15 = VALID and DN_13_15 and (not DR_13_15)  # machine 13/15 lies N (R10)
        QR_13_15 = VALID and DR_13_15 and (not DN_13_15)  # machine 13/15 lies R (R10)
        QN_17_19 = VALID and DN_17_19 and (not DR_17_19)  # machine 17/19 lies N (R10)
        QR_17_19 = VALID and DR_17_19 and (not DN_17_19)  # machine 17/19 lies R (R10)
        QN_21 = VALID and DN_21 and (not DR_21)  # machine 21 lies N (R10)
        QR_21 = VALID and DR_21 and (not DN_21)  # machine 21 lies R (R10)
        QN_23_25 = VALID and DN_23_25 and (not DR_23_25)  # machine 23/25 lies N (R10)
        QR_23_25 = VALID and DR_23_25 and (not DN_23_25)  # machine 23/25 lies R (R10)
        QN_27 = VALID and DN_27 and (not DR_27)  # machine 27 lies N (R10)
        QR_27 = VALID and DR_27 and (not DN_27)  # machine 27 lies R (R10)
        QN_5_7 = VALID and DN_5_7 and (not DR_5_7)  # machine 5/7 lies N (R10)
        QR_5_7 = VALID and DR_5_7 and (not DN_5_7)  # machine 5/7 lies R (R10)
        QN_9_11 = VALID and DN_9_11 and (not DR_9_11)  # machine 9/11 lies N (R10)
        QR_9_11 = VALID and DR_9_11 and (not DN_9_11)  # machine 9/11 lies R (R10)
        MOV_1_3 = VALID and FREE_1DG and (not OCC_1DG) and FREE_3DG and (not OCC_3DG) and True and True  # machine 1/3 is free to move (R10)
        AVN_1_3 = CN_1_3 or MOV_1_3 or (QN_1_3 and (not CN_1_3) and (not CR_1_3))  # machine 1/3 can be demanded N
        AVR_1_3 = CR_1_3 or MOV_1_3 or (QR_1_3 and (not CN_1_3) and (not CR_1_3))  # machine 1/3 can be demanded R
        MOV_13_15 = VALID and FREE_11_13DG and (not OCC_11_13DG) and FREE_9_15DG and (not OCC_9_15DG) and (not (L_9_15DG_1 or L_9_15DG_5)) and True  # machine 13/15 is free to move (R10)
        AVN_13_15 = CN_13_15 or MOV_13_15 or (QN_13_15 and (not CN_13_15) and (not CR_13_15))  # machine 13/15 can be demanded N
        AVR_13_15 = CR_13_15 or MOV_13_15 or (QR_13_15 and (not CN_13_15) and (not CR_13_15))  # machine 13/15 can be demanded R
        MOV_17_19 = VALID and FREE_17_23DG and (not OCC_17_23DG) and FREE_19_27DG and (not OCC_19_27DG) and True and True  # machine 17/19 is free to move (R10)
        AVN_17_19 = CN_17_19 or MOV_17_19 or (QN_17_19 and (not CN_17_19) and (not CR_17_19))  # machine 17/19 can be demanded N
        AVR_17_19 = CR_17_19 or MOV_17_19 or (QR_17_19 and (not CN_17_19) and (not CR_17_19))  # machine 17/19 can be demanded R
        MOV_21 = VALID and FREE_21DG and (not OCC_21DG) and True and True  # machine 21 is free to move (R10)
        AVN_21 = CN_21 or MOV_21 or (QN_21 and (not CN_21) and (not CR_21))  # machine 21 can be demanded N
        AVR_21 = CR_21 or MOV_21 or (QR_21 and (not CN_21) and (not CR_21))  # machine 21 can be demanded R
        MOV_23_25 = VALID and FREE_17_23DG and (not OCC_17_23DG) and FREE_25DG and (not OCC_25DG) and True and True  # machine 23/25 is free to move (R10)
        AVN_23_25 = CN_23_25 or MOV_23_25 or (QN_23_25 and (not CN_23_25) and (not CR_23_25))  # machine 23/25 can be demanded N
        AVR_23_25 = CR_23_25 or MOV_23_25 or (QR_23_25 and (not CN_23_25) and (not CR_23_25))  # machine 23/25 can be demanded R
        MOV_27 = VALID and FREE_19_27DG and (not OCC_19_27DG) and True and True  # machine 27 is free to move (R10)
        AVN_27 = CN_27 or MOV_27 or (QN_27 and (not CN_27) and (not CR_27))  # machine 27 can be demanded N
        AVR_27 = CR_27 or MOV_27 or (QR_27 and (not CN_27) and (not CR_27))  # machine 27 can be demanded R
        MOV_5_7 = VALID and FREE_5DG and (not OCC_5DG) and FREE_7DG and (not OCC_7DG) and True and True  # machine 5/7 is free to move (R10)
        AVN_5_7 = CN_5_7 or MOV_5_7 or (QN_5_7 and (not CN_5_7) and (not CR_5_7))  # machine 5/7 can be demanded N
        AVR_5_7 = CR_5_7 or MOV_5_7 or (QR_5_7 and (not CN_5_7) and (not CR_5_7))  # machine 5/7 can be demanded R
        MOV_9_11 = VALID and FREE_11_13DG and (not OCC_11_13DG) and FREE_9_15DG and (not OCC_9_15DG) and (not (L_11_13DG_4 or L_11_13DG_6)) and True  # machine 9/11 is free to move (R10)
        AVN_9_11 = CN_9_11 or MOV_9_11 or (QN_9_11 and (not CN_9_11) and (not CR_9_11))  # machine 9/11 can be demanded N
        AVR_9_11 = CR_9_11 or MOV_9_11 or (QR_9_11 and (not CN_9_11) and (not CR_9_11))  # machine 9/11 can be demanded R
        WF_1_19WG_1 = FREE_1_19WG and (not OCC_1_19WG) and (not BLK_1_19WG)  # 1/19WG from 1/19WG|19-27DG@19.normal to 1/19WG|1DG@WG.0: free for a route (R6)
        WA_11_13DG_1 = AVN_9_11 and AVN_13_15 and (not TR_9_11) and (not TR_13_15)  # 11-13DG from 11-13DG|21DG@11.toe to 11-13DG|7DG@13.toe: could be locked
        WF_11_13DG_1 = FREE_11_13DG and (not OCC_11_13DG) and (not BLK_11_13DG) and WA_11_13DG_1  # 11-13DG from 11-13DG|21DG@11.toe to 11-13DG|7DG@13.toe: free for a route (R6)
        WA_11_13DG_2 = AVR_9_11 and (not TR_9_11)  # 11-13DG from 11-13DG|21DG@11.toe to 11-13DG|9-15DG@11.reverse: could be locked
        WF_11_13DG_2 = FREE_11_13DG and (not OCC_11_13DG) and (not BLK_11_13DG) and WA_11_13DG_2  # 11-13DG from 11-13DG|21DG@11.toe to 11-13DG|9-15DG@11.reverse: free for a route (R6)
        WA_11_13DG_3 = AVN_13_15 and AVN_9_11 and (not TR_13_15) and (not TR_9_11)  # 11-13DG from 11-13DG|7DG@13.toe to 11-13DG|21DG@11.toe: could be locked
        WF_11_13DG_3 = FREE_11_13DG and (not OCC_11_13DG) and (not BLK_11_13DG) and WA_11_13DG_3  # 11-13DG from 11-13DG|7DG@13.toe to 11-13DG|21DG@11.toe: free for a route (R6)
        WA_11_13DG_4 = (not (L_9_15DG_1 or L_9_15DG_5 or K_9_15DG)) and AVR_13_15 and AVN_9_11 and (not TR_13_15) and (not TR_9_11)  # 11-13DG from 11-13DG|7DG@13.toe to 11-13DG|9-15DG@15.reverse: could be locked
        WF_11_13DG_4 = FREE_11_13DG and (not OCC_11_13DG) and (not BLK_11_13DG) and WA_11_13DG_4  # 11-13DG from 11-13DG|7DG@13.toe to 11-13DG|9-15DG@15.reverse: free for a route (R6)
        WA_11_13DG_5 = AVR_9_11 and (not TR_9_11)  # 11-13DG from 11-13DG|9-15DG@11.reverse to 11-13DG|21DG@11.toe: could be locked
        WF_11_13DG_5 = FREE_11_13DG and (not OCC_11_13DG) and (not BLK_11_13DG) and WA_11_13DG_5  # 11-13DG from 11-13DG|9-15DG@11.reverse to 11-13DG|21DG@11.toe: free for a route (R6)
        WA_11_13DG_6 = (not (L_9_15DG_1 or L_9_15DG_5 or K_9_15DG)) and AVR_13_15 and AVN_9_11 and (not TR_13_15) and (not TR_9_11)  # 11-13DG from 11-13DG|9-15DG@15.reverse to 11-13DG|7DG@13.toe: could be locked
        WF_11_13DG_6 = FREE_11_13DG and (not OCC_11_13DG) and (not BLK_11_13DG) and WA_11_13DG_6  # 11-13DG from 11-13DG|9-15DG@15.reverse to 11-13DG|7DG@13.toe: free for a route (R6)
        WA_17_23DG_1 = AVR_17_19 and (not TR_17_19)  # 17-23DG from 17-23DG|19-27DG@x17.0 to 17-23DG|9-15DG@15.toe: could be locked
        WF_17_23DG_1 = FREE_17_23DG and (not OCC_17_23DG) and (not BLK_17_23DG) and WA_17_23DG_1  # 17-23DG from 17-23DG|19-27DG@x17.0 to 17-23DG|9-15DG@15.toe: free for a route (R6)
        WA_17_23DG_2 = AVR_23_25 and AVN_17_19 and (not TR_23_25) and (not TR_17_19)  # 17-23DG from 17-23DG|25DG@x23.0 to 17-23DG|9-15DG@15.toe: could be locked
        WF_17_23DG_2 = FREE_17_23DG and (not OCC_17_23DG) and (not BLK_17_23DG) and WA_17_23DG_2  # 17-23DG from 17-23DG|25DG@x23.0 to 17-23DG|9-15DG@15.toe: free for a route (R6)
        WA_17_23DG_3 = AVR_17_19 and (not TR_17_19)  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|19-27DG@x17.0: could be locked
        WF_17_23DG_3 = FREE_17_23DG and (not OCC_17_23DG) and (not BLK_17_23DG) and WA_17_23DG_3  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|19-27DG@x17.0: free for a route (R6)
        WA_17_23DG_4 = AVN_17_19 and AVR_23_25 and (not TR_17_19) and (not TR_23_25)  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|25DG@x23.0: could be locked
        WF_17_23DG_4 = FREE_17_23DG and (not OCC_17_23DG) and (not BLK_17_23DG) and WA_17_23DG_4  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|25DG@x23.0: free for a route (R6)
        WA_17_23DG_5 = AVN_17_19 and AVN_23_25 and (not TR_17_19) and (not TR_23_25)  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|IG@tI.0: could be locked
        WF_17_23DG_5 = FREE_17_23DG and (not OCC_17_23DG) and (not BLK_17_23DG) and WA_17_23DG_5  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|IG@tI.0: free for a route (R6)
        WA_17_23DG_6 = AVN_23_25 and AVN_17_19 and (not TR_23_25) and (not TR_17_19)  # 17-23DG from 17-23DG|IG@tI.0 to 17-23DG|9-15DG@15.toe: could be locked
        WF_17_23DG_6 = FREE_17_23DG and (not OCC_17_23DG) and (not BLK_17_23DG) and WA_17_23DG_6  # 17-23DG from 17-23DG|IG@tI.0 to 17-23DG|9-15DG@15.toe: free for a route (R6)
        WA_19_27DG_1 = AVN_17_19 and AVR_27 and (not TR_17_19) and (not TR_27)  # 19-27DG from 1/19WG|19-27DG@19.normal to 19-27DG|4G@t4.0: could be locked
        WF_19_27DG_1 = FREE_19_27DG and (not OCC_19_27DG) and (not BLK_19_27DG) and WA_19_27DG_1  # 19-27DG from 1/19WG|19-27DG@19.normal to 19-27DG|4G@t4.0: free for a route (R6)
        WA_19_27DG_2 = AVN_17_19 and AVN_27 and (not TR_17_19) and (not TR_27)  # 19-27DG from 1/19WG|19-27DG@19.normal to 19-27DG|IIG@tII.0: could be locked
        WF_19_27DG_2 = FREE_19_27DG and (not OCC_19_27DG) and (not BLK_19_27DG) and WA_19_27DG_2  # 19-27DG from 1/19WG|19-27DG@19.normal to 19-27DG|IIG@tII.0: free for a route (R6)
        WA_19_27DG_3 = AVR_17_19 and AVR_27 and (not TR_17_19) and (not TR_27)  # 19-27DG from 17-23DG|19-27DG@x17.0 to 19-27DG|4G@t4.0: could be locked
        WF_19_27DG_3 = FREE_19_27DG and (not OCC_19_27DG) and (not BLK_19_27DG) and WA_19_27DG_3  # 19-27DG from 17-23DG|19-27DG@x17.0 to 19-27DG|4G@t4.0: free for a route (R6)
        WA_19_27DG_4 = AVR_17_19 and AVN_27 and (not TR_17_19) and (not TR_27)  # 19-27DG from 17-23DG|19-27DG@x17.0 to 19-27DG|IIG@tII.0: could be locked
        WF_19_27DG_4 = FREE_19_27DG and (not OCC_19_27DG) and (not BLK_19_27DG) and WA_19_27DG_4  # 19-27DG from 17-23DG|19-27DG@x17.0 to 19-27DG|IIG@tII.0: free for a route (R6)
        WA_19_27DG_5 = AVR_27 and AVN_17_19 and (not TR_27) and (not TR_17_19)  # 19-27DG from 19-27DG|4G@t4.0 to 1/19WG|19-27DG@19.normal: could be locked
        WF_19_27DG_5 = FREE_19_27DG and (not OCC_19_27DG) and (not BLK_19_27DG) and WA_19_27DG_5  # 19-27DG from 19-27DG|4G@t4.0 to 1/19WG|19-27DG@19.normal: free for a route (R6)
        WA_19_27DG_6 = AVR_27 and AVR_17_19 and (not TR_27) and (not TR_17_19)  # 19-27DG from 19-27DG|4G@t4.0 to 17-23DG|19-27DG@x17.0: could be locked
        WF_19_27DG_6 = FREE_19_27DG and (not OCC_19_27DG) and (not BLK_19_27DG) and WA_19_27DG_6  # 19-27DG from 19-27DG|4G@t4.0 to 17-23DG|19-27DG@x17.0: free for a route (R6)
        WA_19_27DG_7 = AVN_27 and AVN_17_19 and (not TR_27) and (not TR_17_19)  # 19-27DG from 19-27DG|IIG@tII.0 to 1/19WG|19-27DG@19.normal: could be locked
        WF_19_27DG_7 = FREE_19_27DG and (not OCC_19_27DG) and (not BLK_19_27DG) and WA_19_27DG_7  # 19-27DG from 19-27DG|IIG@tII.0 to 1/19WG|19-27DG@19.normal: free for a route (R6)
        WA_19_27DG_8 = AVN_27 and AVR_17_19 and (not TR_27) and (not TR_17_19)  # 19-27DG from 19-27DG|IIG@tII.0 to 17-23DG|19-27DG@x17.0: could be locked
        WF_19_27DG_8 = FREE_19_27DG and (not OCC_19_27DG) and (not BLK_19_27DG) and WA_19_27DG_8  # 19-27DG from 19-27DG|IIG@tII.0 to 17-23DG|19-27DG@x17.0: free for a route (R6)
        WA_1DG_1 = AVN_1_3 and (not TR_1_3)  # 1DG from 1/19WG|1DG@WG.0 to 1DG|IIAG@1.toe: could be locked
        WF_1DG_1 = FREE_1DG and (not OCC_1DG) and (not BLK_1DG) and WA_1DG_1  # 1DG from 1/19WG|1DG@WG.0 to 1DG|IIAG@1.toe: free for a route (R6)
        WA_1DG_2 = AVR_1_3 and (not TR_1_3)  # 1DG from 1DG|3DG@x1.0 to 1DG|IIAG@1.toe: could be locked
        WF_1DG_2 = FREE_1DG and (not OCC_1DG) and (not BLK_1DG) and WA_1DG_2  # 1DG from 1DG|3DG@x1.0 to 1DG|IIAG@1.toe: free for a route (R6)
        WA_1DG_3 = AVN_1_3 and (not TR_1_3)  # 1DG from 1DG|IIAG@1.toe to 1/19WG|1DG@WG.0: could be locked
        WF_1DG_3 = FREE_1DG and (not OCC_1DG) and (not BLK_1DG) and WA_1DG_3  # 1DG from 1DG|IIAG@1.toe to 1/19WG|1DG@WG.0: free for a route (R6)
        WA_1DG_4 = AVR_1_3 and (not TR_1_3)  # 1DG from 1DG|IIAG@1.toe to 1DG|3DG@x1.0: could be locked
        WF_1DG_4 = FREE_1DG and (not OCC_1DG) and (not BLK_1DG) and WA_1DG_4  # 1DG from 1DG|IIAG@1.toe to 1DG|3DG@x1.0: free for a route (R6)
        WA_21DG_1 = (not (L_25DG_1 or L_25DG_3 or K_25DG)) and AVN_21 and (not TR_21)  # 21DG from 11-13DG|21DG@11.toe to 21DG|25DG@21.normal: could be locked
        WF_21DG_1 = FREE_21DG and (not OCC_21DG) and (not BLK_21DG) and WA_21DG_1  # 21DG from 11-13DG|21DG@11.toe to 21DG|25DG@21.normal: free for a route (R6)
        WA_21DG_2 = (not (L_25DG_2 or L_25DG_4 or K_25DG)) and AVR_21 and (not TR_21) and ((not OCC_25DG) or QR_23_25)  # 21DG from 11-13DG|21DG@11.toe to 21DG|5G@t5.0: could be locked
        WF_21DG_2 = FREE_21DG and (not OCC_21DG) and (not BLK_21DG) and WA_21DG_2  # 21DG from 11-13DG|21DG@11.toe to 21DG|5G@t5.0: free for a route (R6)
        WA_21DG_3 = (not (L_25DG_1 or L_25DG_3 or K_25DG)) and AVN_21 and (not TR_21)  # 21DG from 21DG|25DG@21.normal to 11-13DG|21DG@11.toe: could be locked
        WF_21DG_3 = FREE_21DG and (not OCC_21DG) and (not BLK_21DG) and WA_21DG_3  # 21DG from 21DG|25DG@21.normal to 11-13DG|21DG@11.toe: free for a route (R6)
        WA_21DG_4 = (not (L_25DG_2 or L_25DG_4 or K_25DG)) and AVR_21 and (not TR_21) and ((not OCC_25DG) or QR_23_25)  # 21DG from 21DG|5G@t5.0 to 11-13DG|21DG@11.toe: could be locked
        WF_21DG_4 = FREE_21DG and (not OCC_21DG) and (not BLK_21DG) and WA_21DG_4  # 21DG from 21DG|5G@t5.0 to 11-13DG|21DG@11.toe: free for a route (R6)
        WA_25DG_1 = (not (L_21DG_1 or L_21DG_3 or K_21DG)) and AVR_23_25 and (not TR_23_25) and ((not OCC_21DG) or QR_21)  # 25DG from 17-23DG|25DG@x23.0 to 25DG|IIIG@tIII.0: could be locked
        WF_25DG_1 = FREE_25DG and (not OCC_25DG) and (not BLK_25DG) and WA_25DG_1  # 25DG from 17-23DG|25DG@x23.0 to 25DG|IIIG@tIII.0: free for a route (R6)
        WA_25DG_2 = (not (L_21DG_2 or L_21DG_4 or K_21DG)) and AVN_23_25 and (not TR_23_25)  # 25DG from 21DG|25DG@21.normal to 25DG|IIIG@tIII.0: could be locked
        WF_25DG_2 = FREE_25DG and (not OCC_25DG) and (not BLK_25DG) and WA_25DG_2  # 25DG from 21DG|25DG@21.normal to 25DG|IIIG@tIII.0: free for a route (R6)
        WA_25DG_3 = (not (L_21DG_1 or L_21DG_3 or K_21DG)) and AVR_23_25 and (not TR_23_25) and ((not OCC_21DG) or QR_21)  # 25DG from 25DG|IIIG@tIII.0 to 17-23DG|25DG@x23.0: could be locked
        WF_25DG_3 = FREE_25DG and (not OCC_25DG) and (not BLK_25DG) and WA_25DG_3  # 25DG from 25DG|IIIG@tIII.0 to 17-23DG|25DG@x23.0: free for a route (R6)
        WA_25DG_4 = (not (L_21DG_2 or L_21DG_4 or K_21DG)) and AVN_23_25 and (not TR_23_25)  # 25DG from 25DG|IIIG@tIII.0 to 21DG|25DG@21.normal: could be locked
        WF_25DG_4 = FREE_25DG and (not OCC_25DG) and (not BLK_25DG) and WA_25DG_4  # 25DG from 25DG|IIIG@tIII.0 to 21DG|25DG@21.normal: free for a route (R6)
        WA_3DG_1 = (not (L_5DG_1 or L_5DG_3 or K_5DG)) and AVR_1_3 and (not TR_1_3) and ((not OCC_5DG) or QR_5_7)  # 3DG from 1DG|3DG@x1.0 to 3DG|9-15DG@3-9.end: could be locked
        WF_3DG_1 = FREE_3DG and (not OCC_3DG) and (not BLK_3DG) and WA_3DG_1  # 3DG from 1DG|3DG@x1.0 to 3DG|9-15DG@3-9.end: free for a route (R6)
        WA_3DG_2 = (not (L_5DG_2 or L_5DG_4 or K_5DG)) and AVN_1_3 and (not TR_1_3)  # 3DG from 3DG|5DG@3.normal to 3DG|9-15DG@3-9.end: could be locked
        WF_3DG_2 = FREE_3DG and (not OCC_3DG) and (not BLK_3DG) and WA_3DG_2  # 3DG from 3DG|5DG@3.normal to 3DG|9-15DG@3-9.end: free for a route (R6)
        WA_3DG_3 = (not (L_5DG_1 or L_5DG_3 or K_5DG)) and AVR_1_3 and (not TR_1_3) and ((not OCC_5DG) or QR_5_7)  # 3DG from 3DG|9-15DG@3-9.end to 1DG|3DG@x1.0: could be locked
        WF_3DG_3 = FREE_3DG and (not OCC_3DG) and (not BLK_3DG) and WA_3DG_3  # 3DG from 3DG|9-15DG@3-9.end to 1DG|3DG@x1.0: free for a route (R6)
        WA_3DG_4 = (not (L_5DG_2 or L_5DG_4 or K_5DG)) and AVN_1_3 and (not TR_1_3)  # 3DG from 3DG|9-15DG@3-9.end to 3DG|5DG@3.normal: could be locked
        WF_3DG_4 = FREE_3DG and (not OCC_3DG) and (not BLK_3DG) and WA_3DG_4  # 3DG from 3DG|9-15DG@3-9.end to 3DG|5DG@3.normal: free for a route (R6)
        WF_4G_1 = FREE_4G and (not OCC_4G) and (not BLK_4G)  # 4G from 19-27DG|4G@t4.0 to E4: free for a route (R6)
        WA_5DG_1 = (not (L_3DG_1 or L_3DG_3 or K_3DG)) and AVN_5_7 and (not TR_5_7)  # 5DG from 3DG|5DG@3.normal to 5DG|IAG@5.toe: could be locked
        WF_5DG_1 = FREE_5DG and (not OCC_5DG) and (not BLK_5DG) and WA_5DG_1  # 5DG from 3DG|5DG@3.normal to 5DG|IAG@5.toe: free for a route (R6)
        WA_5DG_2 = (not (L_3DG_2 or L_3DG_4 or K_3DG)) and AVR_5_7 and (not TR_5_7) and ((not OCC_3DG) or QR_1_3)  # 5DG from 5DG|7DG@x5.0 to 5DG|IAG@5.toe: could be locked
        WF_5DG_2 = FREE_5DG and (not OCC_5DG) and (not BLK_5DG) and WA_5DG_2  # 5DG from 5DG|7DG@x5.0 to 5DG|IAG@5.toe: free for a route (R6)
        WA_5DG_3 = (not (L_3DG_1 or L_3DG_3 or K_3DG)) and AVN_5_7 and (not TR_5_7)  # 5DG from 5DG|IAG@5.toe to 3DG|5DG@3.normal: could be locked
        WF_5DG_3 = FREE_5DG and (not OCC_5DG) and (not BLK_5DG) and WA_5DG_3  # 5DG from 5DG|IAG@5.toe to 3DG|5DG@3.normal: free for a route (R6)
        WA_5DG_4 = (not (L_3DG_2 or L_3DG_4 or K_3DG)) and AVR_5_7 and (not TR_5_7) and ((not OCC_3DG) or QR_1_3)  # 5DG from 5DG|IAG@5.toe to 5DG|7DG@x5.0: could be locked
        WF_5DG_4 = FREE_5DG and (not OCC_5DG) and (not BLK_5DG) and WA_5DG_4  # 5DG from 5DG|IAG@5.toe to 5DG|7DG@x5.0: free for a route (R6)
        WF_5G_1 = FREE_5G and (not OCC_5G) and (not BLK_5G)  # 5G from 21DG|5G@t5.0 to E5: free for a route (R6)
        WA_7DG_1 = AVR_5_7 and (not TR_5_7)  # 7DG from 11-13DG|7DG@13.toe to 5DG|7DG@x5.0: could be locked
        WF_7DG_1 = FREE_7DG and (not OCC_7DG) and (not BLK_7DG) and WA_7DG_1  # 7DG from 11-13DG|7DG@13.toe to 5DG|7DG@x5.0: free for a route (R6)
        WA_7DG_2 = AVN_5_7 and (not TR_5_7)  # 7DG from 11-13DG|7DG@13.toe to DJ: could be locked
        WF_7DG_2 = FREE_7DG and (not OCC_7DG) and (not BLK_7DG) and WA_7DG_2  # 7DG from 11-13DG|7DG@13.toe to DJ: free for a route (R6)
        WA_7DG_3 = AVR_5_7 and (not TR_5_7)  # 7DG from 5DG|7DG@x5.0 to 11-13DG|7DG@13.toe: could be locked
        WF_7DG_3 = FREE_7DG and (not OCC_7DG) and (not BLK_7DG) and WA_7DG_3  # 7DG from 5DG|7DG@x5.0 to 11-13DG|7DG@13.toe: free for a route (R6)
        WA_7DG_4 = AVN_5_7 and (not TR_5_7)  # 7DG from DJ to 11-13DG|7DG@13.toe: could be locked
        WF_7DG_4 = FREE_7DG and (not OCC_7DG) and (not BLK_7DG) and WA_7DG_4  # 7DG from DJ to 11-13DG|7DG@13.toe: free for a route (R6)
        WA_9_15DG_1 = (not (L_11_13DG_4 or L_11_13DG_6 or K_11_13DG)) and AVR_9_11 and AVN_13_15 and (not TR_9_11) and (not TR_13_15)  # 9-15DG from 11-13DG|9-15DG@11.reverse to 3DG|9-15DG@3-9.end: could be locked
        WF_9_15DG_1 = FREE_9_15DG and (not OCC_9_15DG) and (not BLK_9_15DG) and WA_9_15DG_1  # 9-15DG from 11-13DG|9-15DG@11.reverse to 3DG|9-15DG@3-9.end: free for a route (R6)
        WA_9_15DG_2 = AVR_13_15 and (not TR_13_15)  # 9-15DG from 11-13DG|9-15DG@15.reverse to 17-23DG|9-15DG@15.toe: could be locked
        WF_9_15DG_2 = FREE_9_15DG and (not OCC_9_15DG) and (not BLK_9_15DG) and WA_9_15DG_2  # 9-15DG from 11-13DG|9-15DG@15.reverse to 17-23DG|9-15DG@15.toe: free for a route (R6)
        WA_9_15DG_3 = AVR_13_15 and (not TR_13_15)  # 9-15DG from 17-23DG|9-15DG@15.toe to 11-13DG|9-15DG@15.reverse: could be locked
        WF_9_15DG_3 = FREE_9_15DG and (not OCC_9_15DG) and (not BLK_9_15DG) and WA_9_15DG_3  # 9-15DG from 17-23DG|9-15DG@15.toe to 11-13DG|9-15DG@15.reverse: free for a route (R6)
        WA_9_15DG_4 = AVN_13_15 and AVN_9_11 and (not TR_13_15) and (not TR_9_11)  # 9-15DG from 17-23DG|9-15DG@15.toe to 3DG|9-15DG@3-9.end: could be locked
        WF_9_15DG_4 = FREE_9_15DG and (not OCC_9_15DG) and (not BLK_9_15DG) and WA_9_15DG_4  # 9-15DG from 17-23DG|9-15DG@15.toe to 3DG|9-15DG@3-9.end: free for a route (R6)
        WA_9_15DG_5 = (not (L_11_13DG_4 or L_11_13DG_6 or K_11_13DG)) and AVR_9_11 and AVN_13_15 and (not TR_9_11) and (not TR_13_15)  # 9-15DG from 3DG|9-15DG@3-9.end to 11-13DG|9-15DG@11.reverse: could be locked
        WF_9_15DG_5 = FREE_9_15DG and (not OCC_9_15DG) and (not BLK_9_15DG) and WA_9_15DG_5  # 9-15DG from 3DG|9-15DG@3-9.end to 11-13DG|9-15DG@11.reverse: free for a route (R6)
        WA_9_15DG_6 = AVN_9_11 and AVN_13_15 and (not TR_9_11) and (not TR_13_15)  # 9-15DG from 3DG|9-15DG@3-9.end to 17-23DG|9-15DG@15.toe: could be locked
        WF_9_15DG_6 = FREE_9_15DG and (not OCC_9_15DG) and (not BLK_9_15DG) and WA_9_15DG_6  # 9-15DG from 3DG|9-15DG@3-9.end to 17-23DG|9-15DG@15.toe: free for a route (R6)
        WF_IAG_2 = FREE_IAG and (not OCC_IAG) and (not BLK_IAG)  # IAG from BX to 5DG|IAG@5.toe: free for a route (R6)
        WF_IG_1 = FREE_IG and (not OCC_IG) and (not BLK_IG)  # IG from 17-23DG|IG@tI.0 to E1: free for a route (R6)
        WF_IIAG_1 = FREE_IIAG and (not OCC_IIAG) and (not BLK_IIAG)  # IIAG from 1DG|IIAG@1.toe to BS: free for a route (R6)
        WF_IIIG_1 = FREE_IIIG and (not OCC_IIIG) and (not BLK_IIIG)  # IIIG from 25DG|IIIG@tIII.0 to E3: free for a route (R6)
        WL_1_19WG_1 = (not OCC_1_19WG)  # 1/19WG from 1/19WG|19-27DG@19.normal to 1/19WG|1DG@WG.0: lies and is clear
        WP_1_19WG_1 = WL_1_19WG_1 and (not BLK_1_19WG)  # 1/19WG from 1/19WG|19-27DG@19.normal to 1/19WG|1DG@WG.0: proceed may be shown over it (R3)
        WL_1_19WG_2 = (not OCC_1_19WG)  # 1/19WG from 1/19WG|1DG@WG.0 to 1/19WG|19-27DG@19.normal: lies and is clear
        WD_11_13DG_1 = QN_9_11 and QN_13_15 and (not TR_9_11) and (not TR_13_15)  # 11-13DG from 11-13DG|21DG@11.toe to 11-13DG|7DG@13.toe: its points lie, nothing is foul of it
        WL_11_13DG_1 = (not OCC_11_13DG) and WD_11_13DG_1  # 11-13DG from 11-13DG|21DG@11.toe to 11-13DG|7DG@13.toe: lies and is clear
        WP_11_13DG_1 = WL_11_13DG_1 and (not BLK_11_13DG)  # 11-13DG from 11-13DG|21DG@11.toe to 11-13DG|7DG@13.toe: proceed may be shown over it (R3)
        WD_11_13DG_2 = QR_9_11 and (not TR_9_11)  # 11-13DG from 11-13DG|21DG@11.toe to 11-13DG|9-15DG@11.reverse: its points lie, nothing is foul of it
        WL_11_13DG_2 = (not OCC_11_13DG) and WD_11_13DG_2  # 11-13DG from 11-13DG|21DG@11.toe to 11-13DG|9-15DG@11.reverse: lies and is clear
        WP_11_13DG_2 = WL_11_13DG_2 and (not BLK_11_13DG)  # 11-13DG from 11-13DG|21DG@11.toe to 11-13DG|9-15DG@11.reverse: proceed may be shown over it (R3)
        WD_11_13DG_3 = QN_13_15 and QN_9_11 and (not TR_13_15) and (not TR_9_11)  # 11-13DG from 11-13DG|7DG@13.toe to 11-13DG|21DG@11.toe: its points lie, nothing is foul of it
        WL_11_13DG_3 = (not OCC_11_13DG) and WD_11_13DG_3  # 11-13DG from 11-13DG|7DG@13.toe to 11-13DG|21DG@11.toe: lies and is clear
        WP_11_13DG_3 = WL_11_13DG_3 and (not BLK_11_13DG)  # 11-13DG from 11-13DG|7DG@13.toe to 11-13DG|21DG@11.toe: proceed may be shown over it (R3)
        WD_11_13DG_4 = QR_13_15 and QN_9_11 and (not TR_13_15) and (not TR_9_11)  # 11-13DG from 11-13DG|7DG@13.toe to 11-13DG|9-15DG@15.reverse: its points lie, nothing is foul of it
        WL_11_13DG_4 = (not OCC_11_13DG) and WD_11_13DG_4  # 11-13DG from 11-13DG|7DG@13.toe to 11-13DG|9-15DG@15.reverse: lies and is clear
        WP_11_13DG_4 = WL_11_13DG_4 and (not BLK_11_13DG)  # 11-13DG from 11-13DG|7DG@13.toe to 11-13DG|9-15DG@15.reverse: proceed may be shown over it (R3)
        WD_11_13DG_5 = QR_9_11 and (not TR_9_11)  # 11-13DG from 11-13DG|9-15DG@11.reverse to 11-13DG|21DG@11.toe: its points lie, nothing is foul of it
        WL_11_13DG_5 = (not OCC_11_13DG) and WD_11_13DG_5  # 11-13DG from 11-13DG|9-15DG@11.reverse to 11-13DG|21DG@11.toe: lies and is clear
        WP_11_13DG_5 = WL_11_13DG_5 and (not BLK_11_13DG)  # 11-13DG from 11-13DG|9-15DG@11.reverse to 11-13DG|21DG@11.toe: proceed may be shown over it (R3)
        WD_11_13DG_6 = QR_13_15 and QN_9_11 and (not TR_13_15) and (not TR_9_11)  # 11-13DG from 11-13DG|9-15DG@15.reverse to 11-13DG|7DG@13.toe: its points lie, nothing is foul of it
        WL_11_13DG_6 = (not OCC_11_13DG) and WD_11_13DG_6  # 11-13DG from 11-13DG|9-15DG@15.reverse to 11-13DG|7DG@13.toe: lies and is clear
        WP_11_13DG_6 = WL_11_13DG_6 and (not BLK_11_13DG)  # 11-13DG from 11-13DG|9-15DG@15.reverse to 11-13DG|7DG@13.toe: proceed may be shown over it (R3)
        WD_17_23DG_1 = QR_17_19 and (not TR_17_19)  # 17-23DG from 17-23DG|19-27DG@x17.0 to 17-23DG|9-15DG@15.toe: its points lie, nothing is foul of it
        WL_17_23DG_1 = (not OCC_17_23DG) and WD_17_23DG_1  # 17-23DG from 17-23DG|19-27DG@x17.0 to 17-23DG|9-15DG@15.toe: lies and is clear
        WP_17_23DG_1 = WL_17_23DG_1 and (not BLK_17_23DG)  # 17-23DG from 17-23DG|19-27DG@x17.0 to 17-23DG|9-15DG@15.toe: proceed may be shown over it (R3)
        WD_17_23DG_2 = QR_23_25 and QN_17_19 and (not TR_23_25) and (not TR_17_19)  # 17-23DG from 17-23DG|25DG@x23.0 to 17-23DG|9-15DG@15.toe: its points lie, nothing is foul of it
        WL_17_23DG_2 = (not OCC_17_23DG) and WD_17_23DG_2  # 17-23DG from 17-23DG|25DG@x23.0 to 17-23DG|9-15DG@15.toe: lies and is clear
        WP_17_23DG_2 = WL_17_23DG_2 and (not BLK_17_23DG)  # 17-23DG from 17-23DG|25DG@x23.0 to 17-23DG|9-15DG@15.toe: proceed may be shown over it (R3)
        WD_17_23DG_3 = QR_17_19 and (not TR_17_19)  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|19-27DG@x17.0: its points lie, nothing is foul of it
        WL_17_23DG_3 = (not OCC_17_23DG) and WD_17_23DG_3  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|19-27DG@x17.0: lies and is clear
        WP_17_23DG_3 = WL_17_23DG_3 and (not BLK_17_23DG)  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|19-27DG@x17.0: proceed may be shown over it (R3)
        WD_17_23DG_4 = QN_17_19 and QR_23_25 and (not TR_17_19) and (not TR_23_25)  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|25DG@x23.0: its points lie, nothing is foul of it
        WL_17_23DG_4 = (not OCC_17_23DG) and WD_17_23DG_4  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|25DG@x23.0: lies and is clear
        WP_17_23DG_4 = WL_17_23DG_4 and (not BLK_17_23DG)  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|25DG@x23.0: proceed may be shown over it (R3)
        WD_17_23DG_5 = QN_17_19 and QN_23_25 and (not TR_17_19) and (not TR_23_25)  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|IG@tI.0: its points lie, nothing is foul of it
        WL_17_23DG_5 = (not OCC_17_23DG) and WD_17_23DG_5  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|IG@tI.0: lies and is clear
        WP_17_23DG_5 = WL_17_23DG_5 and (not BLK_17_23DG)  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|IG@tI.0: proceed may be shown over it (R3)
        WD_17_23DG_6 = QN_23_25 and QN_17_19 and (not TR_23_25) and (not TR_17_19)  # 17-23DG from 17-23DG|IG@tI.0 to 17-23DG|9-15DG@15.toe: its points lie, nothing is foul of it
        WL_17_23DG_6 = (not OCC_17_23DG) and WD_17_23DG_6  # 17-23DG from 17-23DG|IG@tI.0 to 17-23DG|9-15DG@15.toe: lies and is clear
        WP_17_23DG_6 = WL_17_23DG_6 and (not BLK_17_23DG)  # 17-23DG from 17-23DG|IG@tI.0 to 17-23DG|9-15DG@15.toe: proceed may be shown over it (R3)
        WD_19_27DG_1 = QN_17_19 and QR_27 and (not TR_17_19) and (not TR_27)  # 19-27DG from 1/19WG|19-27DG@19.normal to 19-27DG|4G@t4.0: its points lie, nothing is foul of it
        WL_19_27DG_1 = (not OCC_19_27DG) and WD_19_27DG_1  # 19-27DG from 1/19WG|19-27DG@19.normal to 19-27DG|4G@t4.0: lies and is clear
        WP_19_27DG_1 = WL_19_27DG_1 and (not BLK_19_27DG)  # 19-27DG from 1/19WG|19-27DG@19.normal to 19-27DG|4G@t4.0: proceed may be shown over it (R3)
        WD_19_27DG_2 = QN_17_19 and QN_27 and (not TR_17_19) and (not TR_27)  # 19-27DG from 1/19WG|19-27DG@19.normal to 19-27DG|IIG@tII.0: its points lie, nothing is foul of it
        WL_19_27DG_2 = (not OCC_19_27DG) and WD_19_27DG_2  # 19-27DG from 1/19WG|19-27DG@19.normal to 19-27DG|IIG@tII.0: lies and is clear
        WP_19_27DG_2 = WL_19_27DG_2 and (not BLK_19_27DG)  # 19-27DG from 1/19WG|19-27DG@19.normal to 19-27DG|IIG@tII.0: proceed may be shown over it (R3)
        WD_19_27DG_3 = QR_17_19 and QR_27 and (not TR_17_19) and (not TR_27)  # 19-27DG from 17-23DG|19-27DG@x17.0 to 19-27DG|4G@t4.0: its points lie, nothing is foul of it
        WL_19_27DG_3 = (not OCC_19_27DG) and WD_19_27DG_3  # 19-27DG from 17-23DG|19-27DG@x17.0 to 19-27DG|4G@t4.0: lies and is clear
        WP_19_27DG_3 = WL_19_27DG_3 and (not BLK_19_27DG)  # 19-27DG from 17-23DG|19-27DG@x17.0 to 19-27DG|4G@t4.0: proceed may be shown over it (R3)
        WD_19_27DG_4 = QR_17_19 and QN_27 and (not TR_17_19) and (not TR_27)  # 19-27DG from 17-23DG|19-27DG@x17.0 to 19-27DG|IIG@tII.0: its points lie, nothing is foul of it
        WL_19_27DG_4 = (not OCC_19_27DG) and WD_19_27DG_4  # 19-27DG from 17-23DG|19-27DG@x17.0 to 19-27DG|IIG@tII.0: lies and is clear
        WP_19_27DG_4 = WL_19_27DG_4 and (not BLK_19_27DG)  # 19-27DG from 17-23DG|19-27DG@x17.0 to 19-27DG|IIG@tII.0: proceed may be shown over it (R3)
        WD_19_27DG_5 = QR_27 and QN_17_19 and (not TR_27) and (not TR_17_19)  # 19-27DG from 19-27DG|4G@t4.0 to 1/19WG|19-27DG@19.normal: its points lie, nothing is foul of it
        WL_19_27DG_5 = (not OCC_19_27DG) and WD_19_27DG_5  # 19-27DG from 19-27DG|4G@t4.0 to 1/19WG|19-27DG@19.normal: lies and is clear
        WP_19_27DG_5 = WL_19_27DG_5 and (not BLK_19_27DG)  # 19-27DG from 19-27DG|4G@t4.0 to 1/19WG|19-27DG@19.normal: proceed may be shown over it (R3)
        WD_19_27DG_6 = QR_27 and QR_17_19 and (not TR_27) and (not TR_17_19)  # 19-27DG from 19-27DG|4G@t4.0 to 17-23DG|19-27DG@x17.0: its points lie, nothing is foul of it
        WL_19_27DG_6 = (not OCC_19_27DG) and WD_19_27DG_6  # 19-27DG from 19-27DG|4G@t4.0 to 17-23DG|19-27DG@x17.0: lies and is clear
        WP_19_27DG_6 = WL_19_27DG_6 and (not BLK_19_27DG)  # 19-27DG from 19-27DG|4G@t4.0 to 17-23DG|19-27DG@x17.0: proceed may be shown over it (R3)
        WD_19_27DG_7 = QN_27 and QN_17_19 and (not TR_27) and (not TR_17_19)  # 19-27DG from 19-27DG|IIG@tII.0 to 1/19WG|19-27DG@19.normal: its points lie, nothing is foul of it
        WL_19_27DG_7 = (not OCC_19_27DG) and WD_19_27DG_7  # 19-27DG from 19-27DG|IIG@tII.0 to 1/19WG|19-27DG@19.normal: lies and is clear
        WP_19_27DG_7 = WL_19_27DG_7 and (not BLK_19_27DG)  # 19-27DG from 19-27DG|IIG@tII.0 to 1/19WG|19-27DG@19.normal: proceed may be shown over it (R3)
        WD_19_27DG_8 = QN_27 and QR_17_19 and (not TR_27) and (not TR_17_19)  # 19-27DG from 19-27DG|IIG@tII.0 to 17-23DG|19-27DG@x17.0: its points lie, nothing is foul of it
        WL_19_27DG_8 = (not OCC_19_27DG) and WD_19_27DG_8  # 19-27DG from 19-27DG|IIG@tII.0 to 17-23DG|19-27DG@x17.0: lies and is clear
        WP_19_27DG_8 = WL_19_27DG_8 and (not BLK_19_27DG)  # 19-27DG from 19-27DG|IIG@tII.0 to 17-23DG|19-27DG@x17.0: proceed may be shown over it (R3)
        WD_1DG_1 = QN_1_3 and (not TR_1_3)  # 1DG from 1/19WG|1DG@WG.0 to 1DG|IIAG@1.toe: its points lie, nothing is foul of it
        WL_1DG_1 = (not OCC_1DG) and WD_1DG_1  # 1DG from 1/19WG|1DG@WG.0 to 1DG|IIAG@1.toe: lies and is clear
        WP_1DG_1 = WL_1DG_1 and (not BLK_1DG)  # 1DG from 1/19WG|1DG@WG.0 to 1DG|IIAG@1.toe: proceed may be shown over it (R3)
        WD_1DG_2 = QR_1_3 and (not TR_1_3)  # 1DG from 1DG|3DG@x1.0 to 1DG|IIAG@1.toe: its points lie, nothing is foul of it
        WL_1DG_2 = (not OCC_1DG) and WD_1DG_2  # 1DG from 1DG|3DG@x1.0 to 1DG|IIAG@1.toe: lies and is clear
        WP_1DG_2 = WL_1DG_2 and (not BLK_1DG)  # 1DG from 1DG|3DG@x1.0 to 1DG|IIAG@1.toe: proceed may be shown over it (R3)
        WD_1DG_3 = QN_1_3 and (not TR_1_3)  # 1DG from 1DG|IIAG@1.toe to 1/19WG|1DG@WG.0: its points lie, nothing is foul of it
        WL_1DG_3 = (not OCC_1DG) and WD_1DG_3  # 1DG from 1DG|IIAG@1.toe to 1/19WG|1DG@WG.0: lies and is clear
        WP_1DG_3 = WL_1DG_3 and (not BLK_1DG)  # 1DG from 1DG|IIAG@1.toe to 1/19WG|1DG@WG.0: proceed may be shown over it (R3)
        WD_1DG_4 = QR_1_3 and (not TR_1_3)  # 1DG from 1DG|IIAG@1.toe to 1DG|3DG@x1.0: its points lie, nothing is foul of it
        WL_1DG_4 = (not OCC_1DG) and WD_1DG_4  # 1DG from 1DG|IIAG@1.toe to 1DG|3DG@x1.0: lies and is clear
        WP_1DG_4 = WL_1DG_4 and (not BLK_1DG)  # 1DG from 1DG|IIAG@1.toe to 1DG|3DG@x1.0: proceed may be shown over it (R3)
        WD_21DG_1 = QN_21 and (not TR_21)  # 21DG from 11-13DG|21DG@11.toe to 21DG|25DG@21.normal: its points lie, nothing is foul of it
        WL_21DG_1 = (not OCC_21DG) and WD_21DG_1  # 21DG from 11-13DG|21DG@11.toe to 21DG|25DG@21.normal: lies and is clear
        WP_21DG_1 = WL_21DG_1 and (not BLK_21DG)  # 21DG from 11-13DG|21DG@11.toe to 21DG|25DG@21.normal: proceed may be shown over it (R3)
        WD_21DG_2 = QR_21 and (not TR_21) and ((not OCC_25DG) or QR_23_25)  # 21DG from 11-13DG|21DG@11.toe to 21DG|5G@t5.0: its points lie, nothing is foul of it
        WL_21DG_2 = (not OCC_21DG) and WD_21DG_2  # 21DG from 11-13DG|21DG@11.toe to 21DG|5G@t5.0: lies and is clear
        WP_21DG_2 = WL_21DG_2 and (not BLK_21DG)  # 21DG from 11-13DG|21DG@11.toe to 21DG|5G@t5.0: proceed may be shown over it (R3)
        WD_21DG_3 = QN_21 and (not TR_21)  # 21DG from 21DG|25DG@21.normal to 11-13DG|21DG@11.toe: its points lie, nothing is foul of it
        WL_21DG_3 = (not OCC_21DG) and WD_21DG_3  # 21DG from 21DG|25DG@21.normal to 11-13DG|21DG@11.toe: lies and is clear
        WP_21DG_3 = WL_21DG_3 and (not BLK_21DG)  # 21DG from 21DG|25DG@21.normal to 11-13DG|21DG@11.toe: proceed may be shown over it (R3)
        WD_21DG_4 = QR_21 and (not TR_21) and ((not OCC_25DG) or QR_23_25)  # 21DG from 21DG|5G@t5.0 to 11-13DG|21DG@11.toe: its points lie, nothing is foul of it
        WL_21DG_4 = (not OCC_21DG) and WD_21DG_4  # 21DG from 21DG|5G@t5.0 to 11-13DG|21DG@11.toe: lies and is clear
        WP_21DG_4 = WL_21DG_4 and (not BLK_21DG)  # 21DG from 21DG|5G@t5.0 to 11-13DG|21DG@11.toe: proceed may be shown over it (R3)
        WD_25DG_1 = QR_23_25 and (not TR_23_25) and ((not OCC_21DG) or QR_21)  # 25DG from 17-23DG|25DG@x23.0 to 25DG|IIIG@tIII.0: its points lie, nothing is foul of it
        WL_25DG_1 = (not OCC_25DG) and WD_25DG_1  # 25DG from 17-23DG|25DG@x23.0 to 25DG|IIIG@tIII.0: lies and is clear
        WP_25DG_1 = WL_25DG_1 and (not BLK_25DG)  # 25DG from 17-23DG|25DG@x23.0 to 25DG|IIIG@tIII.0: proceed may be shown over it (R3)
        WD_25DG_2 = QN_23_25 and (not TR_23_25)  # 25DG from 21DG|25DG@21.normal to 25DG|IIIG@tIII.0: its points lie, nothing is foul of it
        WL_25DG_2 = (not OCC_25DG) and WD_25DG_2  # 25DG from 21DG|25DG@21.normal to 25DG|IIIG@tIII.0: lies and is clear
        WP_25DG_2 = WL_25DG_2 and (not BLK_25DG)  # 25DG from 21DG|25DG@21.normal to 25DG|IIIG@tIII.0: proceed may be shown over it (R3)
        WD_25DG_3 = QR_23_25 and (not TR_23_25) and ((not OCC_21DG) or QR_21)  # 25DG from 25DG|IIIG@tIII.0 to 17-23DG|25DG@x23.0: its points lie, nothing is foul of it
        WL_25DG_3 = (not OCC_25DG) and WD_25DG_3  # 25DG from 25DG|IIIG@tIII.0 to 17-23DG|25DG@x23.0: lies and is clear
        WP_25DG_3 = WL_25DG_3 and (not BLK_25DG)  # 25DG from 25DG|IIIG@tIII.0 to 17-23DG|25DG@x23.0: proceed may be shown over it (R3)
        WD_25DG_4 = QN_23_25 and (not TR_23_25)  # 25DG from 25DG|IIIG@tIII.0 to 21DG|25DG@21.normal: its points lie, nothing is foul of it
        WL_25DG_4 = (not OCC_25DG) and WD_25DG_4  # 25DG from 25DG|IIIG@tIII.0 to 21DG|25DG@21.normal: lies and is clear
        WP_25DG_4 = WL_25DG_4 and (not BLK_25DG)  # 25DG from 25DG|IIIG@tIII.0 to 21DG|25DG@21.normal: proceed may be shown over it (R3)
        WD_3DG_1 = QR_1_3 and (not TR_1_3) and ((not OCC_5DG) or QR_5_7)  # 3DG from 1DG|3DG@x1.0 to 3DG|9-15DG@3-9.end: its points lie, nothing is foul of it
        WL_3DG_1 = (not OCC_3DG) and WD_3DG_1  # 3DG from 1DG|3DG@x1.0 to 3DG|9-15DG@3-9.end: lies and is clear
        WP_3DG_1 = WL_3DG_1 and (not BLK_3DG)  # 3DG from 1DG|3DG@x1.0 to 3DG|9-15DG@3-9.end: proceed may be shown over it (R3)
        WD_3DG_2 = QN_1_3 and (not TR_1_3)  # 3DG from 3DG|5DG@3.normal to 3DG|9-15DG@3-9.end: its points lie, nothing is foul of it
        WL_3DG_2 = (not OCC_3DG) and WD_3DG_2  # 3DG from 3DG|5DG@3.normal to 3DG|9-15DG@3-9.end: lies and is clear
        WP_3DG_2 = WL_3DG_2 and (not BLK_3DG)  # 3DG from 3DG|5DG@3.normal to 3DG|9-15DG@3-9.end: proceed may be shown over it (R3)
        WD_3DG_3 = QR_1_3 and (not TR_1_3) and ((not OCC_5DG) or QR_5_7)  # 3DG from 3DG|9-15DG@3-9.end to 1DG|3DG@x1.0: its points lie, nothing is foul of it
        WL_3DG_3 = (not OCC_3DG) and WD_3DG_3  # 3DG from 3DG|9-15DG@3-9.end to 1DG|3DG@x1.0: lies and is clear
        WP_3DG_3 = WL_3DG_3 and (not BLK_3DG)  # 3DG from 3DG|9-15DG@3-9.end to 1DG|3DG@x1.0: proceed may be shown over it (R3)
        WD_3DG_4 = QN_1_3 and (not TR_1_3)  # 3DG from 3DG|9-15DG@3-9.end to 3DG|5DG@3.normal: its points lie, nothing is foul of it
        WL_3DG_4 = (not OCC_3DG) and WD_3DG_4  # 3DG from 3DG|9-15DG@3-9.end to 3DG|5DG@3.normal: lies and is clear
        WP_3DG_4 = WL_3DG_4 and (not BLK_3DG)  # 3DG from 3DG|9-15DG@3-9.end to 3DG|5DG@3.normal: proceed may be shown over it (R3)
        WL_4G_1 = (not OCC_4G)  # 4G from 19-27DG|4G@t4.0 to E4: lies and is clear
        WP_4G_1 = WL_4G_1 and (not BLK_4G)  # 4G from 19-27DG|4G@t4.0 to E4: proceed may be shown over it (R3)
        WD_5DG_1 = QN_5_7 and (not TR_5_7)  # 5DG from 3DG|5DG@3.normal to 5DG|IAG@5.toe: its points lie, nothing is foul of it
        WL_5DG_1 = (not OCC_5DG) and WD_5DG_1  # 5DG from 3DG|5DG@3.normal to 5DG|IAG@5.toe: lies and is clear
        WP_5DG_1 = WL_5DG_1 and (not BLK_5DG)  # 5DG from 3DG|5DG@3.normal to 5DG|IAG@5.toe: proceed may be shown over it (R3)
        WD_5DG_2 = QR_5_7 and (not TR_5_7) and ((not OCC_3DG) or QR_1_3)  # 5DG from 5DG|7DG@x5.0 to 5DG|IAG@5.toe: its points lie, nothing is foul of it
        WL_5DG_2 = (not OCC_5DG) and WD_5DG_2  # 5DG from 5DG|7DG@x5.0 to 5DG|IAG@5.toe: lies and is clear
        WP_5DG_2 = WL_5DG_2 and (not BLK_5DG)  # 5DG from 5DG|7DG@x5.0 to 5DG|IAG@5.toe: proceed may be shown over it (R3)
        WD_5DG_3 = QN_5_7 and (not TR_5_7)  # 5DG from 5DG|IAG@5.toe to 3DG|5DG@3.normal: its points lie, nothing is foul of it
        WL_5DG_3 = (not OCC_5DG) and WD_5DG_3  # 5DG from 5DG|IAG@5.toe to 3DG|5DG@3.normal: lies and is clear
        WP_5DG_3 = WL_5DG_3 and (not BLK_5DG)  # 5DG from 5DG|IAG@5.toe to 3DG|5DG@3.normal: proceed may be shown over it (R3)
        WD_5DG_4 = QR_5_7 and (not TR_5_7) and ((not OCC_3DG) or QR_1_3)  # 5DG from 5DG|IAG@5.toe to 5DG|7DG@x5.0: its points lie, nothing is foul of it
        WL_5DG_4 = (not OCC_5DG) and WD_5DG_4  # 5DG from 5DG|IAG@5.toe to 5DG|7DG@x5.0: lies and is clear
        WP_5DG_4 = WL_5DG_4 and (not BLK_5DG)  # 5DG from 5DG|IAG@5.toe to 5DG|7DG@x5.0: proceed may be shown over it (R3)
        WL_5G_1 = (not OCC_5G)  # 5G from 21DG|5G@t5.0 to E5: lies and is clear
        WP_5G_1 = WL_5G_1 and (not BLK_5G)  # 5G from 21DG|5G@t5.0 to E5: proceed may be shown over it (R3)
        WD_7DG_1 = QR_5_7 and (not TR_5_7)  # 7DG from 11-13DG|7DG@13.toe to 5DG|7DG@x5.0: its points lie, nothing is foul of it
        WL_7DG_1 = (not OCC_7DG) and WD_7DG_1  # 7DG from 11-13DG|7DG@13.toe to 5DG|7DG@x5.0: lies and is clear
        WP_7DG_1 = WL_7DG_1 and (not BLK_7DG)  # 7DG from 11-13DG|7DG@13.toe to 5DG|7DG@x5.0: proceed may be shown over it (R3)
        WD_7DG_2 = QN_5_7 and (not TR_5_7)  # 7DG from 11-13DG|7DG@13.toe to DJ: its points lie, nothing is foul of it
        WL_7DG_2 = (not OCC_7DG) and WD_7DG_2  # 7DG from 11-13DG|7DG@13.toe to DJ: lies and is clear
        WP_7DG_2 = WL_7DG_2 and (not BLK_7DG)  # 7DG from 11-13DG|7DG@13.toe to DJ: proceed may be shown over it (R3)
        WD_7DG_3 = QR_5_7 and (not TR_5_7)  # 7DG from 5DG|7DG@x5.0 to 11-13DG|7DG@13.toe: its points lie, nothing is foul of it
        WL_7DG_3 = (not OCC_7DG) and WD_7DG_3  # 7DG from 5DG|7DG@x5.0 to 11-13DG|7DG@13.toe: lies and is clear
        WP_7DG_3 = WL_7DG_3 and (not BLK_7DG)  # 7DG from 5DG|7DG@x5.0 to 11-13DG|7DG@13.toe: proceed may be shown over it (R3)
        WD_7DG_4 = QN_5_7 and (not TR_5_7)  # 7DG from DJ to 11-13DG|7DG@13.toe: its points lie, nothing is foul of it
        WL_7DG_4 = (not OCC_7DG) and WD_7DG_4  # 7DG from DJ to 11-13DG|7DG@13.toe: lies and is clear
        WP_7DG_4 = WL_7DG_4 and (not BLK_7DG)  # 7DG from DJ to 11-13DG|7DG@13.toe: proceed may be shown over it (R3)
        WD_9_15DG_1 = QR_9_11 and QN_13_15 and (not TR_9_11) and (not TR_13_15)  # 9-15DG from 11-13DG|9-15DG@11.reverse to 3DG|9-15DG@3-9.end: its points lie, nothing is foul of it
        WL_9_15DG_1 = (not OCC_9_15DG) and WD_9_15DG_1  # 9-15DG from 11-13DG|9-15DG@11.reverse to 3DG|9-15DG@3-9.end: lies and is clear
        WP_9_15DG_1 = WL_9_15DG_1 and (not BLK_9_15DG)  # 9-15DG from 11-13DG|9-15DG@11.reverse to 3DG|9-15DG@3-9.end: proceed may be shown over it (R3)
        WD_9_15DG_2 = QR_13_15 and (not TR_13_15)  # 9-15DG from 11-13DG|9-15DG@15.reverse to 17-23DG|9-15DG@15.toe: its points lie, nothing is foul of it
        WL_9_15DG_2 = (not OCC_9_15DG) and WD_9_15DG_2  # 9-15DG from 11-13DG|9-15DG@15.reverse to 17-23DG|9-15DG@15.toe: lies and is clear
        WP_9_15DG_2 = WL_9_15DG_2 and (not BLK_9_15DG)  # 9-15DG from 11-13DG|9-15DG@15.reverse to 17-23DG|9-15DG@15.toe: proceed may be shown over it (R3)
        WD_9_15DG_3 = QR_13_15 and (not TR_13_15)  # 9-15DG from 17-23DG|9-15DG@15.toe to 11-13DG|9-15DG@15.reverse: its points lie, nothing is foul of it
        WL_9_15DG_3 = (not OCC_9_15DG) and WD_9_15DG_3  # 9-15DG from 17-23DG|9-15DG@15.toe to 11-13DG|9-15DG@15.reverse: lies and is clear
        WP_9_15DG_3 = WL_9_15DG_3 and (not BLK_9_15DG)  # 9-15DG from 17-23DG|9-15DG@15.toe to 11-13DG|9-15DG@15.reverse: proceed may be shown over it (R3)
        WD_9_15DG_4 = QN_13_15 and QN_9_11 and (not TR_13_15) and (not TR_9_11)  # 9-15DG from 17-23DG|9-15DG@15.toe to 3DG|9-15DG@3-9.end: its points lie, nothing is foul of it
        WL_9_15DG_4 = (not OCC_9_15DG) and WD_9_15DG_4  # 9-15DG from 17-23DG|9-15DG@15.toe to 3DG|9-15DG@3-9.end: lies and is clear
        WP_9_15DG_4 = WL_9_15DG_4 and (not BLK_9_15DG)  # 9-15DG from 17-23DG|9-15DG@15.toe to 3DG|9-15DG@3-9.end: proceed may be shown over it (R3)
        WD_9_15DG_5 = QR_9_11 and QN_13_15 and (not TR_9_11) and (not TR_13_15)  # 9-15DG from 3DG|9-15DG@3-9.end to 11-13DG|9-15DG@11.reverse: its points lie, nothing is foul of it
        WL_9_15DG_5 = (not OCC_9_15DG) and WD_9_15DG_5  # 9-15DG from 3DG|9-15DG@3-9.end to 11-13DG|9-15DG@11.reverse: lies and is clear
        WP_9_15DG_5 = WL_9_15DG_5 and (not BLK_9_15DG)  # 9-15DG from 3DG|9-15DG@3-9.end to 11-13DG|9-15DG@11.reverse: proceed may be shown over it (R3)
        WD_9_15DG_6 = QN_9_11 and QN_13_15 and (not TR_9_11) and (not TR_13_15)  # 9-15DG from 3DG|9-15DG@3-9.end to 17-23DG|9-15DG@15.toe: its points lie, nothing is foul of it
        WL_9_15DG_6 = (not OCC_9_15DG) and WD_9_15DG_6  # 9-15DG from 3DG|9-15DG@3-9.end to 17-23DG|9-15DG@15.toe: lies and is clear
        WP_9_15DG_6 = WL_9_15DG_6 and (not BLK_9_15DG)  # 9-15DG from 3DG|9-15DG@3-9.end to 17-23DG|9-15DG@15.toe: proceed may be shown over it (R3)
        WL_IAG_1 = (not OCC_IAG)  # IAG from 5DG|IAG@5.toe to BX: lies and is clear
        WL_IAG_2 = (not OCC_IAG)  # IAG from BX to 5DG|IAG@5.toe: lies and is clear
        WP_IAG_2 = WL_IAG_2 and (not BLK_IAG)  # IAG from BX to 5DG|IAG@5.toe: proceed may be shown over it (R3)
        WL_IG_1 = (not OCC_IG)  # IG from 17-23DG|IG@tI.0 to E1: lies and is clear
        WP_IG_1 = WL_IG_1 and (not BLK_IG)  # IG from 17-23DG|IG@tI.0 to E1: proceed may be shown over it (R3)
        WL_IIAG_1 = (not OCC_IIAG)  # IIAG from 1DG|IIAG@1.toe to BS: lies and is clear
        WP_IIAG_1 = WL_IIAG_1 and (not BLK_IIAG)  # IIAG from 1DG|IIAG@1.toe to BS: proceed may be shown over it (R3)
        WL_IIG_1 = (not OCC_IIG)  # IIG from 19-27DG|IIG@tII.0 to E2: lies and is clear
        WL_IIIG_1 = (not OCC_IIIG)  # IIIG from 25DG|IIIG@tIII.0 to E3: lies and is clear
        WP_IIIG_1 = WL_IIIG_1 and (not BLK_IIIG)  # IIIG from 25DG|IIIG@tIII.0 to E3: proceed may be shown over it (R3)
        RQ_R2 = (REQ == 2) or ((REQ == 0) and T_R2 and N_R2 and (not N_R20))  # route D1-D9 is asked for (R14, R18)
        RQ_R7 = (REQ == 7) or ((REQ == 0) and T_R7 and N_R7)  # route D13-IG is asked for (R14, R18)
        RQ_R20 = (REQ == 20) or ((REQ == 0) and T_R20 and N_R20 and (not N_R7))  # route D9-D13 is asked for (R14, R18)
        G_R1 = (REQ == 1) and VALID and WF_1DG_3 and (not BLK_1_19WG) and (not M_1_19WG) and (not (L_19_27DG_5 or L_19_27DG_7))  # grant of route D1-D15 (R6)
        G_R2 = RQ_R2 and VALID and WF_1DG_4 and WF_3DG_1  # grant of route D1-D9 (R6)
        G_R3 = (REQ == 3) and VALID and WF_11_13DG_3 and WF_21DG_2 and (not BLK_5G) and (not M_5G)  # grant of route D11-5G (R6)
        G_R4 = (REQ == 4) and VALID and WF_11_13DG_4 and WF_9_15DG_2  # grant of route D11-D13 (R6)
        G_R5 = (REQ == 5) and VALID and WF_11_13DG_3 and WF_21DG_1 and WF_25DG_2 and (not BLK_IIIG) and (not M_IIIG)  # grant of route D11-IIIG (R6)
        G_R6 = (REQ == 6) and VALID and WF_17_23DG_3 and WF_19_27DG_3 and (not BLK_4G) and (not M_4G)  # grant of route D13-4G (R6)
        G_R7 = RQ_R7 and VALID and WF_17_23DG_5 and (not BLK_IG) and (not M_IG)  # grant of route D13-IG (R6)
        G_R8 = (REQ == 8) and VALID and WF_17_23DG_3 and WF_19_27DG_4 and (not BLK_IIG) and (not M_IIG)  # grant of route D13-IIG (R6)
        G_R9 = (REQ == 9) and VALID and WF_17_23DG_4 and WF_25DG_1 and (not BLK_IIIG) and (not M_IIIG)  # grant of route D13-IIIG (R6)
        G_R10 = (REQ == 10) and VALID and WF_19_27DG_1 and (not BLK_4G) and (not M_4G)  # grant of route D15-4G (R6)
        G_R11 = (REQ == 11) and VALID and WF_19_27DG_2 and (not BLK_IIG) and (not M_IIG)  # grant of route D15-IIG (R6)
        G_R12 = (REQ == 12) and VALID and WF_17_23DG_6 and WF_9_15DG_4  # grant of route D17-D7 (R6)
        G_R13 = (REQ == 13) and VALID and WF_17_23DG_6 and WF_9_15DG_3 and WF_11_13DG_6 and WF_7DG_1 and WF_5DG_2 and (not BLK_IAG) and (not M_IAG) and (not (L_IAG_2 and ((not U_IAG) or OCC_XJG)))  # grant of route D17-IAG (R6)
        G_R14 = (REQ == 14) and VALID and WF_5DG_4 and WF_7DG_3  # grant of route D3-D11 (R6)
        G_R15 = (REQ == 15) and VALID and WF_5DG_3 and WF_3DG_2  # grant of route D3-D9 (R6)
        G_R16 = (REQ == 16) and VALID and WF_1DG_1 and (not BLK_IIAG) and (not M_IIAG)  # grant of route D5-IIAG (R6)
        G_R17 = (REQ == 17) and VALID and WF_3DG_4 and WF_5DG_1 and (not BLK_IAG) and (not M_IAG) and (not (L_IAG_2 and ((not U_IAG) or OCC_XJG)))  # grant of route D7-IAG (R6)
        G_R18 = (REQ == 18) and VALID and WF_3DG_3 and WF_1DG_2 and (not BLK_IIAG) and (not M_IIAG)  # grant of route D7-IIAG (R6)
        G_R19 = (REQ == 19) and VALID and WF_9_15DG_5 and WF_11_13DG_5 and WF_21DG_2 and (not BLK_5G) and (not M_5G)  # grant of route D9-5G (R6)
        G_R20 = RQ_R20 and VALID and WF_9_15DG_6  # grant of route D9-D13 (R6)
        G_R21 = (REQ == 21) and VALID and WF_9_15DG_5 and WF_11_13DG_5 and WF_21DG_1 and WF_25DG_2 and (not BLK_IIIG) and (not M_IIIG)  # grant of route D9-IIIG (R6)
        G_R22 = (REQ == 22) and VALID and WF_19_27DG_5 and WF_1_19WG_1 and WF_1DG_1 and WF_IIAG_1  # grant of route S4-BS (R6)
        G_R23 = (REQ == 23) and VALID and WF_19_27DG_6 and WF_17_23DG_1 and WF_9_15DG_4 and WF_3DG_3 and WF_1DG_2 and WF_IIAG_1  # grant of route S4-BS.2 (R6)
        G_R24 = (REQ == 24) and VALID and WF_19_27DG_6 and WF_17_23DG_1 and WF_9_15DG_3 and WF_11_13DG_6 and WF_7DG_2  # grant of route S4-DJ (R6)
        G_R25 = (REQ == 25) and VALID and WF_19_27DG_5 and (not BLK_1_19WG) and (not M_1_19WG) and (not L_1DG_3)  # grant of route S4-D5.s (R6)
        G_R26 = (REQ == 26) and VALID and WF_19_27DG_6 and WF_17_23DG_1 and WF_9_15DG_4  # grant of route S4-D7.s (R6)
        G_R27 = (REQ == 27) and VALID and WF_19_27DG_6 and WF_17_23DG_1 and WF_9_15DG_3 and WF_11_13DG_6 and WF_7DG_1 and WF_5DG_2 and (not BLK_IAG) and (not M_IAG) and (not (L_IAG_2 and ((not U_IAG) or OCC_XJG)))  # grant of route S4-IAG.s (R6)
        G_R28 = (REQ == 28) and VALID and WF_21DG_4 and WF_11_13DG_2 and WF_9_15DG_1 and WF_3DG_3 and WF_1DG_2 and WF_IIAG_1  # grant of route S5-BS (R6)
        G_R29 = (REQ == 29) and VALID and WF_21DG_4 and WF_11_13DG_1 and WF_7DG_2  # grant of route S5-DJ (R6)
        G_R30 = (REQ == 30) and VALID and WF_21DG_4 and WF_11_13DG_2 and WF_9_15DG_1  # grant of route S5-D7.s (R6)
        G_R31 = (REQ == 31) and VALID and WF_21DG_4 and WF_11_13DG_1 and WF_7DG_1 and WF_5DG_2 and (not BLK_IAG) and (not M_IAG) and (not (L_IAG_2 and ((not U_IAG) or OCC_XJG)))  # grant of route S5-IAG.s (R6)
        G_R32 = (REQ == 32) and VALID and WF_19_27DG_7 and WF_1_19WG_1 and WF_1DG_1 and WF_IIAG_1  # grant of route SII-BS (R6)
        G_R33 = (REQ == 33) and VALID and WF_19_27DG_8 and WF_17_23DG_1 and WF_9_15DG_4 and WF_3DG_3 and WF_1DG_2 and WF_IIAG_1  # grant of route SII-BS.2 (R6)
        G_R34 = (REQ == 34) and VALID and WF_19_27DG_8 and WF_17_23DG_1 and WF_9_15DG_3 and WF_11_13DG_6 and WF_7DG_2  # grant of route SII-DJ (R6)
        G_R35 = (REQ == 35) and VALID and WF_19_27DG_7 and (not BLK_1_19WG) and (not M_1_19WG) and (not L_1DG_3)  # grant of route SII-D5.s (R6)
        G_R36 = (REQ == 36) and VALID and WF_19_27DG_8 and WF_17_23DG_1 and WF_9_15DG_4  # grant of route SII-D7.s (R6)
        G_R37 = (REQ == 37) and VALID and WF_19_27DG_8 and WF_17_23DG_1 and WF_9_15DG_3 and WF_11_13DG_6 and WF_7DG_1 and WF_5DG_2 and (not BLK_IAG) and (not M_IAG) and (not (L_IAG_2 and ((not U_IAG) or OCC_XJG)))  # grant of route SII-IAG.s (R6)
        G_R38 = (REQ == 38) and VALID and WF_25DG_3 and WF_17_23DG_2 and WF_9_15DG_4 and WF_3DG_3 and WF_1DG_2 and WF_IIAG_1  # grant of route SIII-BS (R6)
        G_R39 = (REQ == 39) and VALID and WF_25DG_4 and WF_21DG_3 and WF_11_13DG_2 and WF_9_15DG_1 and WF_3DG_3 and WF_1DG_2 and WF_IIAG_1  # grant of route SIII-BS.2 (R6)
        G_R40 = (REQ == 40) and VALID and WF_25DG_4 and WF_21DG_3 and WF_11_13DG_1 and WF_7DG_2  # grant of route SIII-DJ (R6)
        G_R41 = (REQ == 41) and VALID and WF_25DG_3 and WF_17_23DG_2 and WF_9_15DG_3 and WF_11_13DG_6 and WF_7DG_2  # grant of route SIII-DJ.2 (R6)
        G_R42 = (REQ == 42) and VALID and WF_25DG_3 and WF_17_23DG_2 and WF_9_15DG_4  # grant of route SIII-D7.s (R6)
        G_R43 = (REQ == 43) and VALID and WF_25DG_4 and WF_21DG_3 and WF_11_13DG_2 and WF_9_15DG_1  # grant of route SIII-D7.s.2 (R6)
        G_R44 = (REQ == 44) and VALID and WF_25DG_4 and WF_21DG_3 and WF_11_13DG_1 and WF_7DG_1 and WF_5DG_2 and (not BLK_IAG) and (not M_IAG) and (not (L_IAG_2 and ((not U_IAG) or OCC_XJG)))  # grant of route SIII-IAG.s (R6)
        G_R45 = (REQ == 45) and VALID and WF_25DG_3 and WF_17_23DG_2 and WF_9_15DG_3 and WF_11_13DG_6 and WF_7DG_1 and WF_5DG_2 and (not BLK_IAG) and (not M_IAG) and (not (L_IAG_2 and ((not U_IAG) or OCC_XJG)))  # grant of route SIII-IAG.s.2 (R6)
        G_R46 = (REQ == 46) and VALID and WF_IAG_2 and WF_5DG_3 and WF_3DG_2 and WF_9_15DG_6 and WF_17_23DG_5 and WF_IG_1  # grant of route X-E1 (R6)
        G_R47 = (REQ == 47) and VALID and WF_IAG_2 and WF_5DG_4 and WF_7DG_3 and WF_11_13DG_4 and WF_9_15DG_2 and WF_17_23DG_5 and WF_IG_1  # grant of route X-E1.2 (R6)
        G_R48 = (REQ == 48) and VALID and WF_IAG_2 and WF_5DG_3 and WF_3DG_2 and WF_9_15DG_6 and WF_17_23DG_4 and WF_25DG_1 and WF_IIIG_1  # grant of route X-E3 (R6)
        G_R49 = (REQ == 49) and VALID and WF_IAG_2 and WF_5DG_4 and WF_7DG_3 and WF_11_13DG_3 and WF_21DG_1 and WF_25DG_2 and WF_IIIG_1  # grant of route X-E3.2 (R6)
        G_R50 = (REQ == 50) and VALID and WF_IAG_2 and WF_5DG_3 and WF_3DG_2 and WF_9_15DG_5 and WF_11_13DG_5 and WF_21DG_1 and WF_25DG_2 and WF_IIIG_1  # grant of route X-E3.3 (R6)
        G_R51 = (REQ == 51) and VALID and WF_IAG_2 and WF_5DG_4 and WF_7DG_3 and WF_11_13DG_4 and WF_9_15DG_2 and WF_17_23DG_4 and WF_25DG_1 and WF_IIIG_1  # grant of route X-E3.4 (R6)
        G_R52 = (REQ == 52) and VALID and WF_IAG_2 and WF_5DG_3 and WF_3DG_2 and WF_9_15DG_6 and WF_17_23DG_3 and WF_19_27DG_3 and WF_4G_1  # grant of route X-E4 (R6)
        G_R53 = (REQ == 53) and VALID and WF_IAG_2 and WF_5DG_4 and WF_7DG_3 and WF_11_13DG_4 and WF_9_15DG_2 and WF_17_23DG_3 and WF_19_27DG_3 and WF_4G_1  # grant of route X-E4.2 (R6)
        G_R54 = (REQ == 54) and VALID and WF_IAG_2 and WF_5DG_4 and WF_7DG_3 and WF_11_13DG_3 and WF_21DG_2 and WF_5G_1  # grant of route X-E5 (R6)
        G_R55 = (REQ == 55) and VALID and WF_IAG_2 and WF_5DG_3 and WF_3DG_2 and WF_9_15DG_5 and WF_11_13DG_5 and WF_21DG_2 and WF_5G_1  # grant of route X-E5.2 (R6)
        G_R56 = (REQ == 56) and VALID and WF_IAG_2 and FREE_5DG and (not BLK_5DG) and WA_5DG_3 and FREE_3DG and (not BLK_3DG) and WA_3DG_2 and FREE_9_15DG and (not BLK_9_15DG) and WA_9_15DG_6 and FREE_17_23DG and (not BLK_17_23DG) and WA_17_23DG_5 and WF_IG_1  # grant of route X-E1.c (R6)
        G_R57 = (REQ == 57) and VALID and WF_IAG_2 and FREE_5DG and (not BLK_5DG) and WA_5DG_4 and FREE_7DG and (not BLK_7DG) and WA_7DG_3 and FREE_11_13DG and (not BLK_11_13DG) and WA_11_13DG_4 and FREE_9_15DG and (not BLK_9_15DG) and WA_9_15DG_2 and FREE_17_23DG and (not BLK_17_23DG) and WA_17_23DG_5 and WF_IG_1  # grant of route X-E1.c.2 (R6)
        G_R58 = (REQ == 58) and VALID and WF_IAG_2 and FREE_5DG and (not BLK_5DG) and WA_5DG_3 and FREE_3DG and (not BLK_3DG) and WA_3DG_2 and FREE_9_15DG and (not BLK_9_15DG) and WA_9_15DG_6 and FREE_17_23DG and (not BLK_17_23DG) and WA_17_23DG_4 and FREE_25DG and (not BLK_25DG) and WA_25DG_1 and WF_IIIG_1  # grant of route X-E3.c (R6)
        G_R59 = (REQ == 59) and VALID and WF_IAG_2 and FREE_5DG and (not BLK_5DG) and WA_5DG_4 and FREE_7DG and (not BLK_7DG) and WA_7DG_3 and FREE_11_13DG and (not BLK_11_13DG) and WA_11_13DG_3 and FREE_21DG and (not BLK_21DG) and WA_21DG_1 and FREE_25DG and (not BLK_25DG) and WA_25DG_2 and WF_IIIG_1  # grant of route X-E3.c.2 (R6)
        G_R60 = (REQ == 60) and VALID and WF_IAG_2 and FREE_5DG and (not BLK_5DG) and WA_5DG_3 and FREE_3DG and (not BLK_3DG) and WA_3DG_2 and FREE_9_15DG and (not BLK_9_15DG) and WA_9_15DG_5 and FREE_11_13DG and (not BLK_11_13DG) and WA_11_13DG_5 and FREE_21DG and (not BLK_21DG) and WA_21DG_1 and FREE_25DG and (not BLK_25DG) and WA_25DG_2 and WF_IIIG_1  # grant of route X-E3.c.3 (R6)
        G_R61 = (REQ == 61) and VALID and WF_IAG_2 and FREE_5DG and (not BLK_5DG) and WA_5DG_4 and FREE_7DG and (not BLK_7DG) and WA_7DG_3 and FREE_11_13DG and (not BLK_11_13DG) and WA_11_13DG_4 and FREE_9_15DG and (not BLK_9_15DG) and WA_9_15DG_2 and FREE_17_23DG and (not BLK_17_23DG) and WA_17_23DG_4 and FREE_25DG and (not BLK_25DG) and WA_25DG_1 and WF_IIIG_1  # grant of route X-E3.c.4 (R6)
        G_R62 = (REQ == 62) and VALID and WF_IAG_2 and FREE_5DG and (not BLK_5DG) and WA_5DG_3 and FREE_3DG and (not BLK_3DG) and WA_3DG_2 and FREE_9_15DG and (not BLK_9_15DG) and WA_9_15DG_6 and FREE_17_23DG and (not BLK_17_23DG) and WA_17_23DG_3 and FREE_19_27DG and (not BLK_19_27DG) and WA_19_27DG_3 and WF_4G_1  # grant of route X-E4.c (R6)
        G_R63 = (REQ == 63) and VALID and WF_IAG_2 and FREE_5DG and (not BLK_5DG) and WA_5DG_4 and FREE_7DG and (not BLK_7DG) and WA_7DG_3 and FREE_11_13DG and (not BLK_11_13DG) and WA_11_13DG_4 and FREE_9_15DG and (not BLK_9_15DG) and WA_9_15DG_2 and FREE_17_23DG and (not BLK_17_23DG) and WA_17_23DG_3 and FREE_19_27DG and (not BLK_19_27DG) and WA_19_27DG_3 and WF_4G_1  # grant of route X-E4.c.2 (R6)
        G_R64 = (REQ == 64) and VALID and WF_IAG_2 and FREE_5DG and (not BLK_5DG) and WA_5DG_4 and FREE_7DG and (not BLK_7DG) and WA_7DG_3 and FREE_11_13DG and (not BLK_11_13DG) and WA_11_13DG_3 and FREE_21DG and (not BLK_21DG) and WA_21DG_2 and WF_5G_1  # grant of route X-E5.c (R6)
        G_R65 = (REQ == 65) and VALID and WF_IAG_2 and FREE_5DG and (not BLK_5DG) and WA_5DG_3 and FREE_3DG and (not BLK_3DG) and WA_3DG_2 and FREE_9_15DG and (not BLK_9_15DG) and WA_9_15DG_5 and FREE_11_13DG and (not BLK_11_13DG) and WA_11_13DG_5 and FREE_21DG and (not BLK_21DG) and WA_21DG_2 and WF_5G_1  # grant of route X-E5.c.2 (R6)
        G_R66 = (REQ == 66) and VALID and WF_7DG_4 and WF_11_13DG_4 and WF_9_15DG_2 and WF_17_23DG_5 and WF_IG_1  # grant of route XD-E1 (R6)
        G_R67 = (REQ == 67) and VALID and WF_7DG_4 and WF_11_13DG_3 and WF_21DG_1 and WF_25DG_2 and WF_IIIG_1  # grant of route XD-E3 (R6)
        G_R68 = (REQ == 68) and VALID and WF_7DG_4 and WF_11_13DG_4 and WF_9_15DG_2 and WF_17_23DG_4 and WF_25DG_1 and WF_IIIG_1  # grant of route XD-E3.2 (R6)
        G_R69 = (REQ == 69) and VALID and WF_7DG_4 and WF_11_13DG_4 and WF_9_15DG_2 and WF_17_23DG_3 and WF_19_27DG_3 and WF_4G_1  # grant of route XD-E4 (R6)
        G_R70 = (REQ == 70) and VALID and WF_7DG_4 and WF_11_13DG_3 and WF_21DG_2 and WF_5G_1  # grant of route XD-E5 (R6)
        G_R71 = (REQ == 71) and VALID and WF_7DG_4 and FREE_11_13DG and (not BLK_11_13DG) and WA_11_13DG_4 and FREE_9_15DG and (not BLK_9_15DG) and WA_9_15DG_2 and FREE_17_23DG and (not BLK_17_23DG) and WA_17_23DG_5 and WF_IG_1  # grant of route XD-E1.c (R6)
        G_R72 = (REQ == 72) and VALID and WF_7DG_4 and FREE_11_13DG and (not BLK_11_13DG) and WA_11_13DG_3 and FREE_21DG and (not BLK_21DG) and WA_21DG_1 and FREE_25DG and (not BLK_25DG) and WA_25DG_2 and WF_IIIG_1  # grant of route XD-E3.c (R6)
        G_R73 = (REQ == 73) and VALID and WF_7DG_4 and FREE_11_13DG and (not BLK_11_13DG) and WA_11_13DG_4 and FREE_9_15DG and (not BLK_9_15DG) and WA_9_15DG_2 and FREE_17_23DG and (not BLK_17_23DG) and WA_17_23DG_4 and FREE_25DG and (not BLK_25DG) and WA_25DG_1 and WF_IIIG_1  # grant of route XD-E3.c.2 (R6)
        G_R74 = (REQ == 74) and VALID and WF_7DG_4 and FREE_11_13DG and (not BLK_11_13DG) and WA_11_13DG_4 and FREE_9_15DG and (not BLK_9_15DG) and WA_9_15DG_2 and FREE_17_23DG and (not BLK_17_23DG) and WA_17_23DG_3 and FREE_19_27DG and (not BLK_19_27DG) and WA_19_27DG_3 and WF_4G_1  # grant of route XD-E4.c (R6)
        G_R75 = (REQ == 75) and VALID and WF_7DG_4 and FREE_11_13DG and (not BLK_11_13DG) and WA_11_13DG_3 and FREE_21DG and (not BLK_21DG) and WA_21DG_2 and WF_5G_1  # grant of route XD-E5.c (R6)
        GW_1_19WG_1 = G_R22 or G_R32  # 1/19WG from 1/19WG|19-27DG@19.normal to 1/19WG|1DG@WG.0: granted
        GB_1_19WG_1 = G_R25 or G_R35  # 1/19WG from 1/19WG|19-27DG@19.normal to 1/19WG|1DG@WG.0: granted
        GB_1_19WG_2 = G_R1  # 1/19WG from 1/19WG|1DG@WG.0 to 1/19WG|19-27DG@19.normal: granted
        GW_11_13DG_1 = G_R29 or G_R31 or G_R40 or G_R44  # 11-13DG from 11-13DG|21DG@11.toe to 11-13DG|7DG@13.toe: granted
        GW_11_13DG_2 = G_R28 or G_R30 or G_R39 or G_R43  # 11-13DG from 11-13DG|21DG@11.toe to 11-13DG|9-15DG@11.reverse: granted
        GW_11_13DG_3 = G_R3 or G_R5 or G_R49 or G_R54 or G_R59 or G_R64 or G_R67 or G_R70 or G_R72 or G_R75  # 11-13DG from 11-13DG|7DG@13.toe to 11-13DG|21DG@11.toe: granted
        GW_11_13DG_4 = G_R4 or G_R47 or G_R51 or G_R53 or G_R57 or G_R61 or G_R63 or G_R66 or G_R68 or G_R69 or G_R71 or G_R73 or G_R74  # 11-13DG from 11-13DG|7DG@13.toe to 11-13DG|9-15DG@15.reverse: granted
        GW_11_13DG_5 = G_R19 or G_R21 or G_R50 or G_R55 or G_R60 or G_R65  # 11-13DG from 11-13DG|9-15DG@11.reverse to 11-13DG|21DG@11.toe: granted
        GW_11_13DG_6 = G_R13 or G_R24 or G_R27 or G_R34 or G_R37 or G_R41 or G_R45  # 11-13DG from 11-13DG|9-15DG@15.reverse to 11-13DG|7DG@13.toe: granted
        GW_17_23DG_1 = G_R23 or G_R24 or G_R26 or G_R27 or G_R33 or G_R34 or G_R36 or G_R37  # 17-23DG from 17-23DG|19-27DG@x17.0 to 17-23DG|9-15DG@15.toe: granted
        GW_17_23DG_2 = G_R38 or G_R41 or G_R42 or G_R45  # 17-23DG from 17-23DG|25DG@x23.0 to 17-23DG|9-15DG@15.toe: granted
        GW_17_23DG_3 = G_R6 or G_R8 or G_R52 or G_R53 or G_R62 or G_R63 or G_R69 or G_R74  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|19-27DG@x17.0: granted
        GW_17_23DG_4 = G_R9 or G_R48 or G_R51 or G_R58 or G_R61 or G_R68 or G_R73  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|25DG@x23.0: granted
        GW_17_23DG_5 = G_R7 or G_R46 or G_R47 or G_R56 or G_R57 or G_R66 or G_R71  # 17-23DG from 17-23DG|9-15DG@15.toe to 17-23DG|IG@tI.0: granted
        GW_17_23DG_6 = G_R12 or G_R13  # 17-23DG from 17-23DG|IG@tI.0 to 17-23DG|9-15DG@15.toe: granted
        GW_19_27DG_1 = G_R10  # 19-27DG from 1/19WG|19-27DG@19.normal to 19-27DG|4G@t4.0: granted
        GW_19_27DG_2 = G_R11  # 19-27DG from 1/19WG|19-27DG@19.normal to 19-27DG|IIG@tII.0: granted
        GW_19_27DG_3 = G_R6 or G_R52 or G_R53 or G_R62 or G_R63 or G_R69 or G_R74  # 19-27DG from 17-23DG|19-27DG@x17.0 to 19-27DG|4G@t4.0: granted
        GW_19_27DG_4 = G_R8  # 19-27DG from 17-23DG|19-27DG@x17.0 to 19-27DG|IIG@tII.0: granted
        GW_19_27DG_5 = G_R22 or G_R25  # 19-27DG from 19-27DG|4G@t4.0 to 1/19WG|19-27DG@19.normal: granted
        GW_19_27DG_6 = G_R23 or G_R24 or G_R26 or G_R27  # 19-27DG from 19-27DG|4G@t4.0 to 17-23DG|19-27DG@x17.0: granted
        GW_19_27DG_7 = G_R32 or G_R35  # 19-27DG from 19-27DG|IIG@tII.0 to 1/19WG|19-27DG@19.normal: granted
        GW_19_27DG_8 = G_R33 or G_R34 or G_R36 or G_R37  # 19-27DG from 19-27DG|IIG@tII.0 to 17-23DG|19-27DG@x17.0: granted
        GW_1DG_1 = G_R16 or G_R22 or G_R32  # 1DG from 1/19WG|1DG@WG.0 to 1DG|IIAG@1.toe: granted
        GW_1DG_2 = G_R18 or G_R23 or G_R28 or G_R33 or G_R38 or G_R39  # 1DG from 1DG|3DG@x1.0 to 1DG|IIAG@1.toe: granted
        GW_1DG_3 = G_R1  # 1DG from 1DG|IIAG@1.toe to 1/19WG|1DG@WG.0: granted
        GW_1DG_4 = G_R2  # 1DG from 1DG|IIAG@1.toe to 1DG|3DG@x1.0: granted
        GW_21DG_1 = G_R5 or G_R21 or G_R49 or G_R50 or G_R59 or G_R60 or G_R67 or G_R72  # 21DG from 11-13DG|21DG@11.toe to 21DG|25DG@21.normal: granted
        GW_21DG_2 = G_R3 or G_R19 or G_R54 or G_R55 or G_R64 or G_R65 or G_R70 or G_R75  # 21DG from 11-13DG|21DG@11.toe to 21DG|5G@t5.0: granted
        GW_21DG_3 = G_R39 or G_R40 or G_R43 or G_R44  # 21DG from 21DG|25DG@21.normal to 11-13DG|21DG@11.toe: granted
        GW_21DG_4 = G_R28 or G_R29 or G_R30 or G_R31  # 21DG from 21DG|5G@t5.0 to 11-13DG|21DG@11.toe: granted
        GW_25DG_1 = G_R9 or G_R48 or G_R51 or G_R58 or G_R61 or G_R68 or G_R73  # 25DG from 17-23DG|25DG@x23.0 to 25DG|IIIG@tIII.0: granted
        GW_25DG_2 = G_R5 or G_R21 or G_R49 or G_R50 or G_R59 or G_R60 or G_R67 or G_R72  # 25DG from 21DG|25DG@21.normal to 25DG|IIIG@tIII.0: granted
        GW_25DG_3 = G_R38 or G_R41 or G_R42 or G_R45  # 25DG from 25DG|IIIG@tIII.0 to 17-23DG|25DG@x23.0: granted
        GW_25DG_4 = G_R39 or G_R40 or G_R43 or G_R44  # 25DG from 25DG|IIIG@tIII.0 to 21DG|25DG@21.normal: granted
        GW_3DG_1 = G_R2  # 3DG from 1DG|3DG@x1.0 to 3DG|9-15DG@3-9.end: granted
        GW_3DG_2 = G_R15 or G_R46 or G_R48 or G_R50 or G_R52 or G_R55 or G_R56 or G_R58 or G_R60 or G_R62 or G_R65  # 3DG from 3DG|5DG@3.normal to 3DG|9-15DG@3-9.end: granted
        GW_3DG_3 = G_R18 or G_R23 or G_R28 or G_R33 or G_R38 or G_R39  # 3DG from 3DG|9-15DG@3-9.end to 1DG|3DG@x1.0: granted
        GW_3DG_4 = G_R17  # 3DG from 3DG|9-15DG@3-9.end to 3DG|5DG@3.normal: granted
        GW_4G_1 = G_R52 or G_R53 or G_R62 or G_R63 or G_R69 or G_R74  # 4G from 19-27DG|4G@t4.0 to E4: granted
        GB_4G_1 = G_R6 or G_R10  # 4G from 19-27DG|4G@t4.0 to E4: granted
        GW_5DG_1 = G_R17  # 5DG from 3DG|5DG@3.normal to 5DG|IAG@5.toe: granted
        GW_5DG_2 = G_R13 or G_R27 or G_R31 or G_R37 or G_R44 or G_R45  # 5DG from 5DG|7DG@x5.0 to 5DG|IAG@5.toe: granted
        GW_5DG_3 = G_R15 or G_R46 or G_R48 or G_R50 or G_R52 or G_R55 or G_R56 or G_R58 or G_R60 or G_R62 or G_R65  # 5DG from 5DG|IAG@5.toe to 3DG|5DG@3.normal: granted
        GW_5DG_4 = G_R14 or G_R47 or G_R49 or G_R51 or G_R53 or G_R54 or G_R57 or G_R59 or G_R61 or G_R63 or G_R64  # 5DG from 5DG|IAG@5.toe to 5DG|7DG@x5.0: granted
        GW_5G_1 = G_R54 or G_R55 or G_R64 or G_R65 or G_R70 or G_R75  # 5G from 21DG|5G@t5.0 to E5: granted
        GB_5G_1 = G_R3 or G_R19  # 5G from 21DG|5G@t5.0 to E5: granted
        GW_7DG_1 = G_R13 or G_R27 or G_R31 or G_R37 or G_R44 or G_R45  # 7DG from 11-13DG|7DG@13.toe to 5DG|7DG@x5.0: granted
        GW_7DG_2 = G_R24 or G_R29 or G_R34 or G_R40 or G_R41  # 7DG from 11-13DG|7DG@13.toe to DJ: granted
        GW_7DG_3 = G_R14 or G_R47 or G_R49 or G_R51 or G_R53 or G_R54 or G_R57 or G_R59 or G_R61 or G_R63 or G_R64  # 7DG from 5DG|7DG@x5.0 to 11-13DG|7DG@13.toe: granted
        GW_7DG_4 = G_R66 or G_R67 or G_R68 or G_R69 or G_R70 or G_R71 or G_R72 or G_R73 or G_R74 or G_R75  # 7DG from DJ to 11-13DG|7DG@13.toe: granted
        GW_9_15DG_1 = G_R28 or G_R30 or G_R39 or G_R43  # 9-15DG from 11-13DG|9-15DG@11.reverse to 3DG|9-15DG@3-9.end: granted
        GW_9_15DG_2 = G_R4 or G_R47 or G_R51 or G_R53 or G_R57 or G_R61 or G_R63 or G_R66 or G_R68 or G_R69 or G_R71 or G_R73 or G_R74  # 9-15DG from 11-13DG|9-15DG@15.reverse to 17-23DG|9-15DG@15.toe: granted
        GW_9_15DG_3 = G_R13 or G_R24 or G_R27 or G_R34 or G_R37 or G_R41 or G_R45  # 9-15DG from 17-23DG|9-15DG@15.toe to 11-13DG|9-15DG@15.reverse: granted
        GW_9_15DG_4 = G_R12 or G_R23 or G_R26 or G_R33 or G_R36 or G_R38 or G_R42  # 9-15DG from 17-23DG|9-15DG@15.toe to 3DG|9-15DG@3-9.end: granted
        GW_9_15DG_5 = G_R19 or G_R21 or G_R50 or G_R55 or G_R60 or G_R65  # 9-15DG from 3DG|9-15DG@3-9.end to 11-13DG|9-15DG@11.reverse: granted
        GW_9_15DG_6 = G_R20 or G_R46 or G_R48 or G_R52 or G_R56 or G_R58 or G_R62  # 9-15DG from 3DG|9-15DG@3-9.end to 17-23DG|9-15DG@15.toe: granted
        GB_IAG_1 = G_R13 or G_R17 or G_R27 or G_R31 or G_R37 or G_R44 or G_R45  # IAG from 5DG|IAG@5.toe to BX: granted
        GW_IAG_2 = G_R46 or G_R47 or G_R48 or G_R49 or G_R50 or G_R51 or G_R52 or G_R53 or G_R54 or G_R55 or G_R56 or G_R57 or G_R58 or G_R59 or G_R60 or G_R61 or G_R62 or G_R63 or G_R64 or G_R65  # IAG from BX to 5DG|IAG@5.toe: granted
        GW_IG_1 = G_R46 or G_R47 or G_R56 or G_R57 or G_R66 or G_R71  # IG from 17-23DG|IG@tI.0 to E1: granted
        GB_IG_1 = G_R7  # IG from 17-23DG|IG@tI.0 to E1: granted
        GW_IIAG_1 = G_R22 or G_R23 or G_R28 or G_R32 or G_R33 or G_R38 or G_R39  # IIAG from 1DG|IIAG@1.toe to BS: granted
        GB_IIAG_1 = G_R16 or G_R18  # IIAG from 1DG|IIAG@1.toe to BS: granted
        GB_IIG_1 = G_R8 or G_R11  # IIG from 19-27DG|IIG@tII.0 to E2: granted
        GW_IIIG_1 = G_R48 or G_R49 or G_R50 or G_R51 or G_R58 or G_R59 or G_R60 or G_R61 or G_R67 or G_R68 or G_R72 or G_R73  # IIIG from 25DG|IIIG@tIII.0 to E3: granted
        GB_IIIG_1 = G_R5 or G_R9 or G_R21  # IIIG from 25DG|IIIG@tIII.0 to E3: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_D1) and (not CAN_D1) and WL_1DG_3  # route D1-D15 becomes locked (R3)
        CO_R1 = VALID and WP_1DG_3 and (not BLK_1_19WG) and (not D_1DG)  # conditions of proceed for route D1-D15 (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_D1) and (not CAN_D1) and WL_1DG_4 and WL_3DG_1  # route D1-D9 becomes locked (R3)
        CO_R2 = VALID and WP_1DG_4 and WP_3DG_1 and (not D_1DG)  # conditions of proceed for route D1-D9 (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_D11) and (not CAN_D11) and WL_11_13DG_3 and WL_21DG_2  # route D11-5G becomes locked (R3)
        CO_R3 = VALID and WP_11_13DG_3 and WP_21DG_2 and (not BLK_5G) and (not D_11_13DG)  # conditions of proceed for route D11-5G (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_D11) and (not CAN_D11) and WL_11_13DG_4 and WL_9_15DG_2  # route D11-D13 becomes locked (R3)
        CO_R4 = VALID and WP_11_13DG_4 and WP_9_15DG_2 and (not D_11_13DG)  # conditions of proceed for route D11-D13 (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_D11) and (not CAN_D11) and WL_11_13DG_3 and WL_21DG_1 and WL_25DG_2  # route D11-IIIG becomes locked (R3)
        CO_R5 = VALID and WP_11_13DG_3 and WP_21DG_1 and WP_25DG_2 and (not BLK_IIIG) and (not D_11_13DG)  # conditions of proceed for route D11-IIIG (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_D13) and (not CAN_D13) and WL_17_23DG_3 and WL_19_27DG_3  # route D13-4G becomes locked (R3)
        CO_R6 = VALID and WP_17_23DG_3 and WP_19_27DG_3 and (not BLK_4G) and (not D_17_23DG)  # conditions of proceed for route D13-4G (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_D13) and (not CAN_D13) and WL_17_23DG_5  # route D13-IG becomes locked (R3)
        CO_R7 = VALID and WP_17_23DG_5 and (not BLK_IG) and (not D_17_23DG)  # conditions of proceed for route D13-IG (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_D13) and (not CAN_D13) and WL_17_23DG_3 and WL_19_27DG_4  # route D13-IIG becomes locked (R3)
        CO_R8 = VALID and WP_17_23DG_3 and WP_19_27DG_4 and (not BLK_IIG) and (not D_17_23DG)  # conditions of proceed for route D13-IIG (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_D13) and (not CAN_D13) and WL_17_23DG_4 and WL_25DG_1  # route D13-IIIG becomes locked (R3)
        CO_R9 = VALID and WP_17_23DG_4 and WP_25DG_1 and (not BLK_IIIG) and (not D_17_23DG)  # conditions of proceed for route D13-IIIG (R3)
        LK_R10 = A_R10 and (not B_R10) and VALID and (not X_D15) and (not CAN_D15) and WL_19_27DG_1  # route D15-4G becomes locked (R3)
        CO_R10 = VALID and WP_19_27DG_1 and (not BLK_4G) and (not D_19_27DG)  # conditions of proceed for route D15-4G (R3)
        LK_R11 = A_R11 and (not B_R11) and VALID and (not X_D15) and (not CAN_D15) and WL_19_27DG_2  # route D15-IIG becomes locked (R3)
        CO_R11 = VALID and WP_19_27DG_2 and (not BLK_IIG) and (not D_19_27DG)  # conditions of proceed for route D15-IIG (R3)
        LK_R12 = A_R12 and (not B_R12) and VALID and (not X_D17) and (not CAN_D17) and WL_17_23DG_6 and WL_9_15DG_4  # route D17-D7 becomes locked (R3)
        CO_R12 = VALID and WP_17_23DG_6 and WP_9_15DG_4 and (not D_17_23DG)  # conditions of proceed for route D17-D7 (R3)
        LK_R13 = A_R13 and (not B_R13) and VALID and (not X_D17) and (not CAN_D17) and WL_17_23DG_6 and WL_9_15DG_3 and WL_11_13DG_6 and WL_7DG_1 and WL_5DG_2  # route D17-IAG becomes locked (R3)
        CO_R13 = VALID and WP_17_23DG_6 and WP_9_15DG_3 and WP_11_13DG_6 and WP_7DG_1 and WP_5DG_2 and (not BLK_IAG) and (not D_17_23DG)  # conditions of proceed for route D17-IAG (R3)
        LK_R14 = A_R14 and (not B_R14) and VALID and (not X_D3) and (not CAN_D3) and WL_5DG_4 and WL_7DG_3  # route D3-D11 becomes locked (R3)
        CO_R14 = VALID and WP_5DG_4 and WP_7DG_3 and (not D_5DG)  # conditions of proceed for route D3-D11 (R3)
        LK_R15 = A_R15 and (not B_R15) and VALID and (not X_D3) and (not CAN_D3) and WL_5DG_3 and WL_3DG_2  # route D3-D9 becomes locked (R3)
        CO_R15 = VALID and WP_5DG_3 and WP_3DG_2 and (not D_5DG)  # conditions of proceed for route D3-D9 (R3)
        LK_R16 = A_R16 and (not B_R16) and VALID and (not X_D5) and (not CAN_D5) and WL_1DG_1  # route D5-IIAG becomes locked (R3)
        CO_R16 = VALID and WP_1DG_1 and (not BLK_IIAG) and (not D_1DG)  # conditions of proceed for route D5-IIAG (R3)
        LK_R17 = A_R17 and (not B_R17) and VALID and (not X_D7) and (not CAN_D7) and WL_3DG_4 and WL_5DG_1  # route D7-IAG becomes locked (R3)
        CO_R17 = VALID and WP_3DG_4 and WP_5DG_1 and (not BLK_IAG) and (not D_3DG)  # conditions of proceed for route D7-IAG (R3)
        LK_R18 = A_R18 and (not B_R18) and VALID and (not X_D7) and (not CAN_D7) and WL_3DG_3 and WL_1DG_2  # route D7-IIAG becomes locked (R3)
        CO_R18 = VALID and WP_3DG_3 and WP_1DG_2 and (not BLK_IIAG) and (not D_3DG)  # conditions of proceed for route D7-IIAG (R3)
        LK_R19 = A_R19 and (not B_R19) and VALID and (not X_D9) and (not CAN_D9) and WL_9_15DG_5 and WL_11_13DG_5 and WL_21DG_2  # route D9-5G becomes locked (R3)
        CO_R19 = VALID and WP_9_15DG_5 and WP_11_13DG_5 and WP_21DG_2 and (not BLK_5G) and (not D_9_15DG)  # conditions of proceed for route D9-5G (R3)
        LK_R20 = A_R20 and (not B_R20) and VALID and (not X_D9) and (not CAN_D9) and WL_9_15DG_6  # route D9-D13 becomes locked (R3)
        CO_R20 = VALID and WP_9_15DG_6 and (not D_9_15DG)  # conditions of proceed for route D9-D13 (R3)
        LK_R21 = A_R21 and (not B_R21) and VALID and (not X_D9) and (not CAN_D9) and WL_9_15DG_5 and WL_11_13DG_5 and WL_21DG_1 and WL_25DG_2  # route D9-IIIG becomes locked (R3)
        CO_R21 = VALID and WP_9_15DG_5 and WP_11_13DG_5 and WP_21DG_1 and WP_25DG_2 and (not BLK_IIIG) and (not D_9_15DG)  # conditions of proceed for route D9-IIIG (R3)
        LK_R22 = A_R22 and (not B_R22) and VALID and (not X_S4) and (not CAN_S4) and WL_19_27DG_5 and WL_1_19WG_1 and WL_1DG_1 and WL_IIAG_1  # route S4-BS becomes locked (R3)
        CO_R22 = VALID and WP_19_27DG_5 and WP_1_19WG_1 and WP_1DG_1 and WP_IIAG_1 and E_BF_BS and (not D_19_27DG) and CL_S4  # conditions of proceed for route S4-BS (R3)
        LK_R23 = A_R23 and (not B_R23) and VALID and (not X_S4) and (not CAN_S4) and WL_19_27DG_6 and WL_17_23DG_1 and WL_9_15DG_4 and WL_3DG_3 and WL_1DG_2 and WL_IIAG_1  # route S4-BS.2 becomes locked (R3)
        CO_R23 = VALID and WP_19_27DG_6 and WP_17_23DG_1 and WP_9_15DG_4 and WP_3DG_3 and WP_1DG_2 and WP_IIAG_1 and E_BF_BS and (not D_19_27DG) and CL_S4  # conditions of proceed for route S4-BS.2 (R3)
        LK_R24 = A_R24 and (not B_R24) and VALID and (not X_S4) and (not CAN_S4) and WL_19_27DG_6 and WL_17_23DG_1 and WL_9_15DG_3 and WL_11_13DG_6 and WL_7DG_2  # route S4-DJ becomes locked (R3)
        CO_R24 = VALID and WP_19_27DG_6 and WP_17_23DG_1 and WP_9_15DG_3 and WP_11_13DG_6 and WP_7DG_2 and E_BF_DJ and (not OCC_XDJG) and (not D_19_27DG) and CL_S4  # conditions of proceed for route S4-DJ (R3)
        LK_R25 = A_R25 and (not B_R25) and VALID and (not X_S4) and (not CAN_S4) and WL_19_27DG_5  # route S4-D5.s becomes locked (R3)
        CO_R25 = VALID and WP_19_27DG_5 and (not BLK_1_19WG) and (not D_19_27DG)  # conditions of proceed for route S4-D5.s (R3)
        LK_R26 = A_R26 and (not B_R26) and VALID and (not X_S4) and (not CAN_S4) and WL_19_27DG_6 and WL_17_23DG_1 and WL_9_15DG_4  # route S4-D7.s becomes locked (R3)
        CO_R26 = VALID and WP_19_27DG_6 and WP_17_23DG_1 and WP_9_15DG_4 and (not D_19_27DG)  # conditions of proceed for route S4-D7.s (R3)
        LK_R27 = A_R27 and (not B_R27) and VALID and (not X_S4) and (not CAN_S4) and WL_19_27DG_6 and WL_17_23DG_1 and WL_9_15DG_3 and WL_11_13DG_6 and WL_7DG_1 and WL_5DG_2  # route S4-IAG.s becomes locked (R3)
        CO_R27 = VALID and WP_19_27DG_6 and WP_17_23DG_1 and WP_9_15DG_3 and WP_11_13DG_6 and WP_7DG_1 and WP_5DG_2 and (not BLK_IAG) and (not D_19_27DG)  # conditions of proceed for route S4-IAG.s (R3)
        LK_R28 = A_R28 and (not B_R28) and VALID and (not X_S5) and (not CAN_S5) and WL_21DG_4 and WL_11_13DG_2 and WL_9_15DG_1 and WL_3DG_3 and WL_1DG_2 and WL_IIAG_1  # route S5-BS becomes locked (R3)
        CO_R28 = VALID and WP_21DG_4 and WP_11_13DG_2 and WP_9_15DG_1 and WP_3DG_3 and WP_1DG_2 and WP_IIAG_1 and E_BF_BS and (not D_21DG) and CL_S5  # conditions of proceed for route S5-BS (R3)
        LK_R29 = A_R29 and (not B_R29) and VALID and (not X_S5) and (not CAN_S5) and WL_21DG_4 and WL_11_13DG_1 and WL_7DG_2  # route S5-DJ becomes locked (R3)
        CO_R29 = VALID and WP_21DG_4 and WP_11_13DG_1 and WP_7DG_2 and E_BF_DJ and (not OCC_XDJG) and (not D_21DG) and CL_S5  # conditions of proceed for route S5-DJ (R3)
        LK_R30 = A_R30 and (not B_R30) and VALID and (not X_S5) and (not CAN_S5) and WL_21DG_4 and WL_11_13DG_2 and WL_9_15DG_1  # route S5-D7.s becomes locked (R3)
        CO_R30 = VALID and WP_21DG_4 and WP_11_13DG_2 and WP_9_15DG_1 and (not D_21DG)  # conditions of proceed for route S5-D7.s (R3)
        LK_R31 = A_R31 and (not B_R31) and VALID and (not X_S5) and (not CAN_S5) and WL_21DG_4 and WL_11_13DG_1 and WL_7DG_1 and WL_5DG_2  # route S5-IAG.s becomes locked (R3)
        CO_R31 = VALID and WP_21DG_4 and WP_11_13DG_1 and WP_7DG_1 and WP_5DG_2 and (not BLK_IAG) and (not D_21DG)  # conditions of proceed for route S5-IAG.s (R3)
        LK_R32 = A_R32 and (not B_R32) and VALID and (not X_SII) and (not CAN_SII) and WL_19_27DG_7 and WL_1_19WG_1 and WL_1DG_1 and WL_IIAG_1  # route SII-BS becomes locked (R3)
        CO_R32 = VALID and WP_19_27DG_7 and WP_1_19WG_1 and WP_1DG_1 and WP_IIAG_1 and E_BF_BS and (not D_19_27DG) and CL_SII  # conditions of proceed for route SII-BS (R3)
        LK_R33 = A_R33 and (not B_R33) and VALID and (not X_SII) and (not CAN_SII) and WL_19_27DG_8 and WL_17_23DG_1 and WL_9_15DG_4 and WL_3DG_3 and WL_1DG_2 and WL_IIAG_1  # route SII-BS.2 becomes locked (R3)
        CO_R33 = VALID and WP_19_27DG_8 and WP_17_23DG_1 and WP_9_15DG_4 and WP_3DG_3 and WP_1DG_2 and WP_IIAG_1 and E_BF_BS and (not D_19_27DG) and CL_SII  # conditions of proceed for route SII-BS.2 (R3)
        LK_R34 = A_R34 and (not B_R34) and VALID and (not X_SII) and (not CAN_SII) and WL_19_27DG_8 and WL_17_23DG_1 and WL_9_15DG_3 and WL_11_13DG_6 and WL_7DG_2  # route SII-DJ becomes locked (R3)
        CO_R34 = VALID and WP_19_27DG_8 and WP_17_23DG_1 and WP_9_15DG_3 and WP_11_13DG_6 and WP_7DG_2 and E_BF_DJ and (not OCC_XDJG) and (not D_19_27DG) and CL_SII  # conditions of proceed for route SII-DJ (R3)
        LK_R35 = A_R35 and (not B_R35) and VALID and (not X_SII) and (not CAN_SII) and WL_19_27DG_7  # route SII-D5.s becomes locked (R3)
        CO_R35 = VALID and WP_19_27DG_7 and (not BLK_1_19WG) and (not D_19_27DG)  # conditions of proceed for route SII-D5.s (R3)
        LK_R36 = A_R36 and (not B_R36) and VALID and (not X_SII) and (not CAN_SII) and WL_19_27DG_8 and WL_17_23DG_1 and WL_9_15DG_4  # route SII-D7.s becomes locked (R3)
        CO_R36 = VALID and WP_19_27DG_8 and WP_17_23DG_1 and WP_9_15DG_4 and (not D_19_27DG)  # conditions of proceed for route SII-D7.s (R3)
        LK_R37 = A_R37 and (not B_R37) and VALID and (not X_SII) and (not CAN_SII) and WL_19_27DG_8 and WL_17_23DG_1 and WL_9_15DG_3 and WL_11_13DG_6 and WL_7DG_1 and WL_5DG_2  # route SII-IAG.s becomes locked (R3)
        CO_R37 = VALID and WP_19_27DG_8 and WP_17_23DG_1 and WP_9_15DG_3 and WP_11_13DG_6 and WP_7DG_1 and WP_5DG_2 and (not BLK_IAG) and (not D_19_27DG)  # conditions of proceed for route SII-IAG.s (R3)
        LK_R38 = A_R38 and (not B_R38) and VALID and (not X_SIII) and (not CAN_SIII) and WL_25DG_3 and WL_17_23DG_2 and WL_9_15DG_4 and WL_3DG_3 and WL_1DG_2 and WL_IIAG_1  # route SIII-BS becomes locked (R3)
        CO_R38 = VALID and WP_25DG_3 and WP_17_23DG_2 and WP_9_15DG_4 and WP_3DG_3 and WP_1DG_2 and WP_IIAG_1 and E_BF_BS and (not D_25DG) and CL_SIII  # conditions of proceed for route SIII-BS (R3)
        LK_R39 = A_R39 and (not B_R39) and VALID and (not X_SIII) and (not CAN_SIII) and WL_25DG_4 and WL_21DG_3 and WL_11_13DG_2 and WL_9_15DG_1 and WL_3DG_3 and WL_1DG_2 and WL_IIAG_1  # route SIII-BS.2 becomes locked (R3)
        CO_R39 = VALID and WP_25DG_4 and WP_21DG_3 and WP_11_13DG_2 and WP_9_15DG_1 and WP_3DG_3 and WP_1DG_2 and WP_IIAG_1 and E_BF_BS and (not D_25DG) and CL_SIII  # conditions of proceed for route SIII-BS.2 (R3)
        LK_R40 = A_R40 and (not B_R40) and VALID and (not X_SIII) and (not CAN_SIII) and WL_25DG_4 and WL_21DG_3 and WL_11_13DG_1 and WL_7DG_2  # route SIII-DJ becomes locked (R3)
        CO_R40 = VALID and WP_25DG_4 and WP_21DG_3 and WP_11_13DG_1 and WP_7DG_2 and E_BF_DJ and (not OCC_XDJG) and (not D_25DG) and CL_SIII  # conditions of proceed for route SIII-DJ (R3)
        LK_R41 = A_R41 and (not B_R41) and VALID and (not X_SIII) and (not CAN_SIII) and WL_25DG_3 and WL_17_23DG_2 and WL_9_15DG_3 and WL_11_13DG_6 and WL_7DG_2  # route SIII-DJ.2 becomes locked (R3)
        CO_R41 = VALID and WP_25DG_3 and WP_17_23DG_2 and WP_9_15DG_3 and WP_11_13DG_6 and WP_7DG_2 and E_BF_DJ and (not OCC_XDJG) and (not D_25DG) and CL_SIII  # conditions of proceed for route SIII-DJ.2 (R3)
        LK_R42 = A_R42 and (not B_R42) and VALID and (not X_SIII) and (not CAN_SIII) and WL_25DG_3 and WL_17_23DG_2 and WL_9_15DG_4  # route SIII-D7.s becomes locked (R3)
        CO_R42 = VALID and WP_25DG_3 and WP_17_23DG_2 and WP_9_15DG_4 and (not D_25DG)  # conditions of proceed for route SIII-D7.s (R3)
        LK_R43 = A_R43 and (not B_R43) and VALID and (not X_SIII) and (not CAN_SIII) and WL_25DG_4 and WL_21DG_3 and WL_11_13DG_2 and WL_9_15DG_1  # route SIII-D7.s.2 becomes locked (R3)
        CO_R43 = VALID and WP_25DG_4 and WP_21DG_3 and WP_11_13DG_2 and WP_9_15DG_1 and (not D_25DG)  # conditions of proceed for route SIII-D7.s.2 (R3)
        LK_R44 = A_R44 and (not B_R44) and VALID and (not X_SIII) and (not CAN_SIII) and WL_25DG_4 and WL_21DG_3 and WL_11_13DG_1 and WL_7DG_1 and WL_5DG_2  # route SIII-IAG.s becomes locked (R3)
        CO_R44 = VALID and WP_25DG_4 and WP_21DG_3 and WP_11_13DG_1 and WP_7DG_1 and WP_5DG_2 and (not BLK_IAG) and (not D_25DG)  # conditions of proceed for route SIII-IAG.s (R3)
        LK_R45 = A_R45 and (not B_R45) and VALID and (not X_SIII) and (not CAN_SIII) and WL_25DG_3 and WL_17_23DG_2 and WL_9_15DG_3 and WL_11_13DG_6 and WL_7DG_1 and WL_5DG_2  # route SIII-IAG.s.2 becomes locked (R3)
        CO_R45 = VALID and WP_25DG_3 and WP_17_23DG_2 and WP_9_15DG_3 and WP_11_13DG_6 and WP_7DG_1 and WP_5DG_2 and (not BLK_IAG) and (not D_25DG)  # conditions of proceed for route SIII-IAG.s.2 (R3)
        LK_R46 = A_R46 and (not B_R46) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WL_5DG_3 and WL_3DG_2 and WL_9_15DG_6 and WL_17_23DG_5 and WL_IG_1  # route X-E1 becomes locked (R3)
        CO_R46 = VALID and WP_IAG_2 and WP_5DG_3 and WP_3DG_2 and WP_9_15DG_6 and WP_17_23DG_5 and WP_IG_1 and (not D_IAG) and CL_X  # conditions of proceed for route X-E1 (R3)
        LK_R47 = A_R47 and (not B_R47) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WL_5DG_4 and WL_7DG_3 and WL_11_13DG_4 and WL_9_15DG_2 and WL_17_23DG_5 and WL_IG_1  # route X-E1.2 becomes locked (R3)
        CO_R47 = VALID and WP_IAG_2 and WP_5DG_4 and WP_7DG_3 and WP_11_13DG_4 and WP_9_15DG_2 and WP_17_23DG_5 and WP_IG_1 and (not D_IAG) and CL_X  # conditions of proceed for route X-E1.2 (R3)
        LK_R48 = A_R48 and (not B_R48) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WL_5DG_3 and WL_3DG_2 and WL_9_15DG_6 and WL_17_23DG_4 and WL_25DG_1 and WL_IIIG_1  # route X-E3 becomes locked (R3)
        CO_R48 = VALID and WP_IAG_2 and WP_5DG_3 and WP_3DG_2 and WP_9_15DG_6 and WP_17_23DG_4 and WP_25DG_1 and WP_IIIG_1 and (not D_IAG) and CL_X  # conditions of proceed for route X-E3 (R3)
        LK_R49 = A_R49 and (not B_R49) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WL_5DG_4 and WL_7DG_3 and WL_11_13DG_3 and WL_21DG_1 and WL_25DG_2 and WL_IIIG_1  # route X-E3.2 becomes locked (R3)
        CO_R49 = VALID and WP_IAG_2 and WP_5DG_4 and WP_7DG_3 and WP_11_13DG_3 and WP_21DG_1 and WP_25DG_2 and WP_IIIG_1 and (not D_IAG) and CL_X  # conditions of proceed for route X-E3.2 (R3)
        LK_R50 = A_R50 and (not B_R50) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WL_5DG_3 and WL_3DG_2 and WL_9_15DG_5 and WL_11_13DG_5 and WL_21DG_1 and WL_25DG_2 and WL_IIIG_1  # route X-E3.3 becomes locked (R3)
        CO_R50 = VALID and WP_IAG_2 and WP_5DG_3 and WP_3DG_2 and WP_9_15DG_5 and WP_11_13DG_5 and WP_21DG_1 and WP_25DG_2 and WP_IIIG_1 and (not D_IAG) and CL_X  # conditions of proceed for route X-E3.3 (R3)
        LK_R51 = A_R51 and (not B_R51) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WL_5DG_4 and WL_7DG_3 and WL_11_13DG_4 and WL_9_15DG_2 and WL_17_23DG_4 and WL_25DG_1 and WL_IIIG_1  # route X-E3.4 becomes locked (R3)
        CO_R51 = VALID and WP_IAG_2 and WP_5DG_4 and WP_7DG_3 and WP_11_13DG_4 and WP_9_15DG_2 and WP_17_23DG_4 and WP_25DG_1 and WP_IIIG_1 and (not D_IAG) and CL_X  # conditions of proceed for route X-E3.4 (R3)
        LK_R52 = A_R52 and (not B_R52) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WL_5DG_3 and WL_3DG_2 and WL_9_15DG_6 and WL_17_23DG_3 and WL_19_27DG_3 and WL_4G_1  # route X-E4 becomes locked (R3)
        CO_R52 = VALID and WP_IAG_2 and WP_5DG_3 and WP_3DG_2 and WP_9_15DG_6 and WP_17_23DG_3 and WP_19_27DG_3 and WP_4G_1 and (not D_IAG) and CL_X  # conditions of proceed for route X-E4 (R3)
        LK_R53 = A_R53 and (not B_R53) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WL_5DG_4 and WL_7DG_3 and WL_11_13DG_4 and WL_9_15DG_2 and WL_17_23DG_3 and WL_19_27DG_3 and WL_4G_1  # route X-E4.2 becomes locked (R3)
        CO_R53 = VALID and WP_IAG_2 and WP_5DG_4 and WP_7DG_3 and WP_11_13DG_4 and WP_9_15DG_2 and WP_17_23DG_3 and WP_19_27DG_3 and WP_4G_1 and (not D_IAG) and CL_X  # conditions of proceed for route X-E4.2 (R3)
        LK_R54 = A_R54 and (not B_R54) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WL_5DG_4 and WL_7DG_3 and WL_11_13DG_3 and WL_21DG_2 and WL_5G_1  # route X-E5 becomes locked (R3)
        CO_R54 = VALID and WP_IAG_2 and WP_5DG_4 and WP_7DG_3 and WP_11_13DG_3 and WP_21DG_2 and WP_5G_1 and (not D_IAG) and CL_X  # conditions of proceed for route X-E5 (R3)
        LK_R55 = A_R55 and (not B_R55) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WL_5DG_3 and WL_3DG_2 and WL_9_15DG_5 and WL_11_13DG_5 and WL_21DG_2 and WL_5G_1  # route X-E5.2 becomes locked (R3)
        CO_R55 = VALID and WP_IAG_2 and WP_5DG_3 and WP_3DG_2 and WP_9_15DG_5 and WP_11_13DG_5 and WP_21DG_2 and WP_5G_1 and (not D_IAG) and CL_X  # conditions of proceed for route X-E5.2 (R3)
        LK_R56 = A_R56 and (not B_R56) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WD_5DG_3 and WD_3DG_2 and WD_9_15DG_6 and WD_17_23DG_5 and WL_IG_1  # route X-E1.c becomes locked (R3)
        CO_R56 = VALID and WP_IAG_2 and WD_5DG_3 and (not BLK_5DG) and WD_3DG_2 and (not BLK_3DG) and WD_9_15DG_6 and (not BLK_9_15DG) and WD_17_23DG_5 and (not BLK_17_23DG) and WP_IG_1  # conditions of proceed for route X-E1.c (R3)
        LK_R57 = A_R57 and (not B_R57) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WD_5DG_4 and WD_7DG_3 and WD_11_13DG_4 and WD_9_15DG_2 and WD_17_23DG_5 and WL_IG_1  # route X-E1.c.2 becomes locked (R3)
        CO_R57 = VALID and WP_IAG_2 and WD_5DG_4 and (not BLK_5DG) and WD_7DG_3 and (not BLK_7DG) and WD_11_13DG_4 and (not BLK_11_13DG) and WD_9_15DG_2 and (not BLK_9_15DG) and WD_17_23DG_5 and (not BLK_17_23DG) and WP_IG_1  # conditions of proceed for route X-E1.c.2 (R3)
        LK_R58 = A_R58 and (not B_R58) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WD_5DG_3 and WD_3DG_2 and WD_9_15DG_6 and WD_17_23DG_4 and WD_25DG_1 and WL_IIIG_1  # route X-E3.c becomes locked (R3)
        CO_R58 = VALID and WP_IAG_2 and WD_5DG_3 and (not BLK_5DG) and WD_3DG_2 and (not BLK_3DG) and WD_9_15DG_6 and (not BLK_9_15DG) and WD_17_23DG_4 and (not BLK_17_23DG) and WD_25DG_1 and (not BLK_25DG) and WP_IIIG_1  # conditions of proceed for route X-E3.c (R3)
        LK_R59 = A_R59 and (not B_R59) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WD_5DG_4 and WD_7DG_3 and WD_11_13DG_3 and WD_21DG_1 and WD_25DG_2 and WL_IIIG_1  # route X-E3.c.2 becomes locked (R3)
        CO_R59 = VALID and WP_IAG_2 and WD_5DG_4 and (not BLK_5DG) and WD_7DG_3 and (not BLK_7DG) and WD_11_13DG_3 and (not BLK_11_13DG) and WD_21DG_1 and (not BLK_21DG) and WD_25DG_2 and (not BLK_25DG) and WP_IIIG_1  # conditions of proceed for route X-E3.c.2 (R3)
        LK_R60 = A_R60 and (not B_R60) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WD_5DG_3 and WD_3DG_2 and WD_9_15DG_5 and WD_11_13DG_5 and WD_21DG_1 and WD_25DG_2 and WL_IIIG_1  # route X-E3.c.3 becomes locked (R3)
        CO_R60 = VALID and WP_IAG_2 and WD_5DG_3 and (not BLK_5DG) and WD_3DG_2 and (not BLK_3DG) and WD_9_15DG_5 and (not BLK_9_15DG) and WD_11_13DG_5 and (not BLK_11_13DG) and WD_21DG_1 and (not BLK_21DG) and WD_25DG_2 and (not BLK_25DG) and WP_IIIG_1  # conditions of proceed for route X-E3.c.3 (R3)
        LK_R61 = A_R61 and (not B_R61) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WD_5DG_4 and WD_7DG_3 and WD_11_13DG_4 and WD_9_15DG_2 and WD_17_23DG_4 and WD_25DG_1 and WL_IIIG_1  # route X-E3.c.4 becomes locked (R3)
        CO_R61 = VALID and WP_IAG_2 and WD_5DG_4 and (not BLK_5DG) and WD_7DG_3 and (not BLK_7DG) and WD_11_13DG_4 and (not BLK_11_13DG) and WD_9_15DG_2 and (not BLK_9_15DG) and WD_17_23DG_4 and (not BLK_17_23DG) and WD_25DG_1 and (not BLK_25DG) and WP_IIIG_1  # conditions of proceed for route X-E3.c.4 (R3)
        LK_R62 = A_R62 and (not B_R62) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WD_5DG_3 and WD_3DG_2 and WD_9_15DG_6 and WD_17_23DG_3 and WD_19_27DG_3 and WL_4G_1  # route X-E4.c becomes locked (R3)
        CO_R62 = VALID and WP_IAG_2 and WD_5DG_3 and (not BLK_5DG) and WD_3DG_2 and (not BLK_3DG) and WD_9_15DG_6 and (not BLK_9_15DG) and WD_17_23DG_3 and (not BLK_17_23DG) and WD_19_27DG_3 and (not BLK_19_27DG) and WP_4G_1  # conditions of proceed for route X-E4.c (R3)
        LK_R63 = A_R63 and (not B_R63) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WD_5DG_4 and WD_7DG_3 and WD_11_13DG_4 and WD_9_15DG_2 and WD_17_23DG_3 and WD_19_27DG_3 and WL_4G_1  # route X-E4.c.2 becomes locked (R3)
        CO_R63 = VALID and WP_IAG_2 and WD_5DG_4 and (not BLK_5DG) and WD_7DG_3 and (not BLK_7DG) and WD_11_13DG_4 and (not BLK_11_13DG) and WD_9_15DG_2 and (not BLK_9_15DG) and WD_17_23DG_3 and (not BLK_17_23DG) and WD_19_27DG_3 and (not BLK_19_27DG) and WP_4G_1  # conditions of proceed for route X-E4.c.2 (R3)
        LK_R64 = A_R64 and (not B_R64) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WD_5DG_4 and WD_7DG_3 and WD_11_13DG_3 and WD_21DG_2 and WL_5G_1  # route X-E5.c becomes locked (R3)
        CO_R64 = VALID and WP_IAG_2 and WD_5DG_4 and (not BLK_5DG) and WD_7DG_3 and (not BLK_7DG) and WD_11_13DG_3 and (not BLK_11_13DG) and WD_21DG_2 and (not BLK_21DG) and WP_5G_1  # conditions of proceed for route X-E5.c (R3)
        LK_R65 = A_R65 and (not B_R65) and VALID and (not X_X) and (not CAN_X) and WL_IAG_2 and WD_5DG_3 and WD_3DG_2 and WD_9_15DG_5 and WD_11_13DG_5 and WD_21DG_2 and WL_5G_1  # route X-E5.c.2 becomes locked (R3)
        CO_R65 = VALID and WP_IAG_2 and WD_5DG_3 and (not BLK_5DG) and WD_3DG_2 and (not BLK_3DG) and WD_9_15DG_5 and (not BLK_9_15DG) and WD_11_13DG_5 and (not BLK_11_13DG) and WD_21DG_2 and (not BLK_21DG) and WP_5G_1  # conditions of proceed for route X-E5.c.2 (R3)
        LK_R66 = A_R66 and (not B_R66) and VALID and (not X_XD) and (not CAN_XD) and WL_7DG_4 and WL_11_13DG_4 and WL_9_15DG_2 and WL_17_23DG_5 and WL_IG_1  # route XD-E1 becomes locked (R3)
        CO_R66 = VALID and WP_7DG_4 and WP_11_13DG_4 and WP_9_15DG_2 and WP_17_23DG_5 and WP_IG_1 and (not D_7DG) and CL_XD  # conditions of proceed for route XD-E1 (R3)
        LK_R67 = A_R67 and (not B_R67) and VALID and (not X_XD) and (not CAN_XD) and WL_7DG_4 and WL_11_13DG_3 and WL_21DG_1 and WL_25DG_2 and WL_IIIG_1  # route XD-E3 becomes locked (R3)
        CO_R67 = VALID and WP_7DG_4 and WP_11_13DG_3 and WP_21DG_1 and WP_25DG_2 and WP_IIIG_1 and (not D_7DG) and CL_XD  # conditions of proceed for route XD-E3 (R3)
        LK_R68 = A_R68 and (not B_R68) and VALID and (not X_XD) and (not CAN_XD) and WL_7DG_4 and WL_11_13DG_4 and WL_9_15DG_2 and WL_17_23DG_4 and WL_25DG_1 and WL_IIIG_1  # route XD-E3.2 becomes locked (R3)
        CO_R68 = VALID and WP_7DG_4 and WP_11_13DG_4 and WP_9_15DG_2 and WP_17_23DG_4 and WP_25DG_1 and WP_IIIG_1 and (not D_7DG) and CL_XD  # conditions of proceed for route XD-E3.2 (R3)
        LK_R69 = A_R69 and (not B_R69) and VALID and (not X_XD) and (not CAN_XD) and WL_7DG_4 and WL_11_13DG_4 and WL_9_15DG_2 and WL_17_23DG_3 and WL_19_27DG_3 and WL_4G_1  # route XD-E4 becomes locked (R3)
        CO_R69 = VALID and WP_7DG_4 and WP_11_13DG_4 and WP_9_15DG_2 and WP_17_23DG_3 and WP_19_27DG_3 and WP_4G_1 and (not D_7DG) and CL_XD  # conditions of proceed for route XD-E4 (R3)
        LK_R70 = A_R70 and (not B_R70) and VALID and (not X_XD) and (not CAN_XD) and WL_7DG_4 and WL_11_13DG_3 and WL_21DG_2 and WL_5G_1  # route XD-E5 becomes locked (R3)
        CO_R70 = VALID and WP_7DG_4 and WP_11_13DG_3 and WP_21DG_2 and WP_5G_1 and (not D_7DG) and CL_XD  # conditions of proceed for route XD-E5 (R3)
        LK_R71 = A_R71 and (not B_R71) and VALID and (not X_XD) and (not CAN_XD) and WL_7DG_4 and WD_11_13DG_4 and WD_9_15DG_2 and WD_17_23DG_5 and WL_IG_1  # route XD-E1.c becomes locked (R3)
        CO_R71 = VALID and WP_7DG_4 and WD_11_13DG_4 and (not BLK_11_13DG) and WD_9_15DG_2 and (not BLK_9_15DG) and WD_17_23DG_5 and (not BLK_17_23DG) and WP_IG_1  # conditions of proceed for route XD-E1.c (R3)
        LK_R72 = A_R72 and (not B_R72) and VALID and (not X_XD) and (not CAN_XD) and WL_7DG_4 and WD_11_13DG_3 and WD_21DG_1 and WD_25DG_2 and WL_IIIG_1  # route XD-E3.c becomes locked (R3)
        CO_R72 = VALID and WP_7DG_4 and WD_11_13DG_3 and (not BLK_11_13DG) and WD_21DG_1 and (not BLK_21DG) and WD_25DG_2 and (not BLK_25DG) and WP_IIIG_1  # conditions of proceed for route XD-E3.c (R3)
        LK_R73 = A_R73 and (not B_R73) and VALID and (not X_XD) and (not CAN_XD) and WL_7DG_4 and WD_11_13DG_4 and WD_9_15DG_2 and WD_17_23DG_4 and WD_25DG_1 and WL_IIIG_1  # route XD-E3.c.2 becomes locked (R3)
        CO_R73 = VALID and WP_7DG_4 and WD_11_13DG_4 and (not BLK_11_13DG) and WD_9_15DG_2 and (not BLK_9_15DG) and WD_17_23DG_4 and (not BLK_17_23DG) and WD_25DG_1 and (not BLK_25DG) and WP_IIIG_1  # conditions of proceed for route XD-E3.c.2 (R3)
        LK_R74 = A_R74 and (not B_R74) and VALID and (not X_XD) and (not CAN_XD) and WL_7DG_4 and WD_11_13DG_4 and WD_9_15DG_2 and WD_17_23DG_3 and WD_19_27DG_3 and WL_4G_1  # route XD-E4.c becomes locked (R3)
        CO_R74 = VALID and WP_7DG_4 and WD_11_13DG_4 and (not BLK_11_13DG) and WD_9_15DG_2 and (not BLK_9_15DG) and WD_17_23DG_3 and (not BLK_17_23DG) and WD_19_27DG_3 and (not BLK_19_27DG) and WP_4G_1  # conditions of proceed for route XD-E4.c (R3)
        LK_R75 = A_R75 and (not B_R75) and VALID and (not X_XD) and (not CAN_XD) and WL_7DG_4 and WD_11_13DG_3 and WD_21DG_2 and WL_5G_1  # route XD-E5.c becomes locked (R3)
        CO_R75 = VALID and WP_7DG_4 and WD_11_13DG_3 and (not BLK_11_13DG) and WD_21DG_2 and (not BLK_21DG) and WP_5G_1  # conditions of proceed for route XD-E5.c (R3)
        NU_1_19WG_1 = VALID and F_1_19WG and (not D_1_19WG) and (not U_1_19WG) and (L_1_19WG_1 or L_1_19WG_2) and OCC_1_19WG and OCC_19_27DG and U_19_27DG and (L_19_27DG_5 or L_19_27DG_7)  # a train comes into 1/19WG at 1/19WG|19-27DG@19.normal (R9)
        NU_1_19WG_2 = VALID and F_1_19WG and (not D_1_19WG) and (not U_1_19WG) and (L_1_19WG_1 or L_1_19WG_2) and OCC_1_19WG and OCC_1DG and U_1DG and L_1DG_3  # a train comes into 1/19WG at 1/19WG|1DG@WG.0 (R9)
        NU_11_13DG_1 = VALID and F_11_13DG and (not D_11_13DG) and (not U_11_13DG) and (L_11_13DG_1 or L_11_13DG_2) and OCC_11_13DG and OCC_21DG and U_21DG and (L_21DG_3 or L_21DG_4)  # a train comes into 11-13DG at 11-13DG|21DG@11.toe (R9)
        NU_11_13DG_2 = VALID and F_11_13DG and (not D_11_13DG) and (not U_11_13DG) and (L_11_13DG_3 or L_11_13DG_4) and OCC_11_13DG and OCC_7DG and ((not M_11_13DG) or U_7DG) and ((not M_11_13DG) or L_7DG_3 or L_7DG_4)  # a train comes into 11-13DG at 11-13DG|7DG@13.toe (R9)
        NU_11_13DG_3 = VALID and F_11_13DG and (not D_11_13DG) and (not U_11_13DG) and L_11_13DG_5 and OCC_11_13DG and OCC_9_15DG and U_9_15DG and L_9_15DG_5  # a train comes into 11-13DG at 11-13DG|9-15DG@11.reverse (R9)
        NU_11_13DG_4 = VALID and F_11_13DG and (not D_11_13DG) and (not U_11_13DG) and L_11_13DG_6 and OCC_11_13DG and OCC_9_15DG and U_9_15DG and L_9_15DG_3  # a train comes into 11-13DG at 11-13DG|9-15DG@15.reverse (R9)
        NU_17_23DG_1 = VALID and F_17_23DG and (not D_17_23DG) and (not U_17_23DG) and L_17_23DG_1 and OCC_17_23DG and OCC_19_27DG and U_19_27DG and (L_19_27DG_6 or L_19_27DG_8)  # a train comes into 17-23DG at 17-23DG|19-27DG@x17.0 (R9)
        NU_17_23DG_2 = VALID and F_17_23DG and (not D_17_23DG) and (not U_17_23DG) and L_17_23DG_2 and OCC_17_23DG and OCC_25DG and U_25DG and L_25DG_3  # a train comes into 17-23DG at 17-23DG|25DG@x23.0 (R9)
        NU_17_23DG_3 = VALID and F_17_23DG and (not D_17_23DG) and (not U_17_23DG) and (L_17_23DG_3 or L_17_23DG_4 or L_17_23DG_5) and OCC_17_23DG and OCC_9_15DG and ((not M_17_23DG) or U_9_15DG) and ((not M_17_23DG) or L_9_15DG_2 or L_9_15DG_6)  # a train comes into 17-23DG at 17-23DG|9-15DG@15.toe (R9)
        NU_17_23DG_4 = VALID and F_17_23DG and (not D_17_23DG) and (not U_17_23DG) and L_17_23DG_6 and OCC_17_23DG and OCC_IG and ((not M_17_23DG) or U_IG) and (not M_17_23DG)  # a train comes into 17-23DG at 17-23DG|IG@tI.0 (R9)
        NU_19_27DG_1 = VALID and F_19_27DG and (not D_19_27DG) and (not U_19_27DG) and (L_19_27DG_1 or L_19_27DG_2) and OCC_19_27DG and OCC_1_19WG and ((not M_19_27DG) or U_1_19WG) and ((not M_19_27DG) or L_1_19WG_2)  # a train comes into 19-27DG at 1/19WG|19-27DG@19.normal (R9)
        NU_19_27DG_2 = VALID and F_19_27DG and (not D_19_27DG) and (not U_19_27DG) and (L_19_27DG_3 or L_19_27DG_4) and OCC_19_27DG and OCC_17_23DG and U_17_23DG and L_17_23DG_3  # a train comes into 19-27DG at 17-23DG|19-27DG@x17.0 (R9)
        NU_19_27DG_3 = VALID and F_19_27DG and (not D_19_27DG) and (not U_19_27DG) and (L_19_27DG_5 or L_19_27DG_6) and OCC_19_27DG and OCC_4G  # a train comes into 19-27DG at 19-27DG|4G@t4.0 (R9)
        NU_19_27DG_4 = VALID and F_19_27DG and (not D_19_27DG) and (not U_19_27DG) and (L_19_27DG_7 or L_19_27DG_8) and OCC_19_27DG and OCC_IIG  # a train comes into 19-27DG at 19-27DG|IIG@tII.0 (R9)
        NU_1DG_1 = VALID and F_1DG and (not D_1DG) and (not U_1DG) and L_1DG_1 and OCC_1DG and OCC_1_19WG and ((not M_1DG) or U_1_19WG) and ((not M_1DG) or L_1_19WG_1)  # a train comes into 1DG at 1/19WG|1DG@WG.0 (R9)
        NU_1DG_2 = VALID and F_1DG and (not D_1DG) and (not U_1DG) and L_1DG_2 and OCC_1DG and OCC_3DG and U_3DG and L_3DG_3  # a train comes into 1DG at 1DG|3DG@x1.0 (R9)
        NU_1DG_3 = VALID and F_1DG and (not D_1DG) and (not U_1DG) and (L_1DG_3 or L_1DG_4) and OCC_1DG and OCC_IIAG and ((not M_1DG) or U_IIAG) and (not M_1DG)  # a train comes into 1DG at 1DG|IIAG@1.toe (R9)
        NU_21DG_1 = VALID and F_21DG and (not D_21DG) and (not U_21DG) and (L_21DG_1 or L_21DG_2) and OCC_21DG and OCC_11_13DG and U_11_13DG and (L_11_13DG_3 or L_11_13DG_5)  # a train comes into 21DG at 11-13DG|21DG@11.toe (R9)
        NU_21DG_2 = VALID and F_21DG and (not D_21DG) and (not U_21DG) and L_21DG_3 and OCC_21DG and OCC_25DG and U_25DG and L_25DG_4  # a train comes into 21DG at 21DG|25DG@21.normal (R9)
        NU_21DG_3 = VALID and F_21DG and (not D_21DG) and (not U_21DG) and L_21DG_4 and OCC_21DG and OCC_5G  # a train comes into 21DG at 21DG|5G@t5.0 (R9)
        NU_25DG_1 = VALID and F_25DG and (not D_25DG) and (not U_25DG) and L_25DG_1 and OCC_25DG and OCC_17_23DG and U_17_23DG and L_17_23DG_4  # a train comes into 25DG at 17-23DG|25DG@x23.0 (R9)
        NU_25DG_2 = VALID and F_25DG and (not D_25DG) and (not U_25DG) and L_25DG_2 and OCC_25DG and OCC_21DG and U_21DG and L_21DG_1  # a train comes into 25DG at 21DG|25DG@21.normal (R9)
        NU_25DG_3 = VALID and F_25DG and (not D_25DG) and (not U_25DG) and (L_25DG_3 or L_25DG_4) and OCC_25DG and OCC_IIIG  # a train comes into 25DG at 25DG|IIIG@tIII.0 (R9)
        NU_3DG_1 = VALID and F_3DG and (not D_3DG) and (not U_3DG) and L_3DG_1 and OCC_3DG and OCC_1DG and U_1DG and L_1DG_4  # a train comes into 3DG at 1DG|3DG@x1.0 (R9)
        NU_3DG_2 = VALID and F_3DG and (not D_3DG) and (not U_3DG) and L_3DG_2 and OCC_3DG and OCC_5DG and U_5DG and L_5DG_3  # a train comes into 3DG at 3DG|5DG@3.normal (R9)
        NU_3DG_3 = VALID and F_3DG and (not D_3DG) and (not U_3DG) and (L_3DG_3 or L_3DG_4) and OCC_3DG and OCC_9_15DG and ((not M_3DG) or U_9_15DG) and ((not M_3DG) or L_9_15DG_1 or L_9_15DG_4)  # a train comes into 3DG at 3DG|9-15DG@3-9.end (R9)
        NU_4G_1 = VALID and F_4G and (not D_4G) and (not U_4G) and L_4G_1 and OCC_4G and OCC_19_27DG and U_19_27DG and (L_19_27DG_1 or L_19_27DG_3)  # a train comes into 4G at 19-27DG|4G@t4.0 (R9)
        NU_5DG_1 = VALID and F_5DG and (not D_5DG) and (not U_5DG) and L_5DG_1 and OCC_5DG and OCC_3DG and U_3DG and L_3DG_4  # a train comes into 5DG at 3DG|5DG@3.normal (R9)
        NU_5DG_2 = VALID and F_5DG and (not D_5DG) and (not U_5DG) and L_5DG_2 and OCC_5DG and OCC_7DG and U_7DG and L_7DG_1  # a train comes into 5DG at 5DG|7DG@x5.0 (R9)
        NU_5DG_3 = VALID and F_5DG and (not D_5DG) and (not U_5DG) and (L_5DG_3 or L_5DG_4) and OCC_5DG and OCC_IAG and ((not M_5DG) or U_IAG) and ((not M_5DG) or L_IAG_2)  # a train comes into 5DG at 5DG|IAG@5.toe (R9)
        NU_5G_1 = VALID and F_5G and (not D_5G) and (not U_5G) and L_5G_1 and OCC_5G and OCC_21DG and U_21DG and L_21DG_2  # a train comes into 5G at 21DG|5G@t5.0 (R9)
        NU_7DG_1 = VALID and F_7DG and (not D_7DG) and (not U_7DG) and (L_7DG_1 or L_7DG_2) and OCC_7DG and OCC_11_13DG and U_11_13DG and (L_11_13DG_1 or L_11_13DG_6)  # a train comes into 7DG at 11-13DG|7DG@13.toe (R9)
        NU_7DG_2 = VALID and F_7DG and (not D_7DG) and (not U_7DG) and L_7DG_3 and OCC_7DG and OCC_5DG and U_5DG and L_5DG_4  # a train comes into 7DG at 5DG|7DG@x5.0 (R9)
        NU_7DG_3 = VALID and F_7DG and (not D_7DG) and (not U_7DG) and L_7DG_4 and OCC_7DG and OCC_XDJG  # a train comes into 7DG at DJ (R9)
        NU_9_15DG_1 = VALID and F_9_15DG and (not D_9_15DG) and (not U_9_15DG) and L_9_15DG_1 and OCC_9_15DG and OCC_11_13DG and U_11_13DG and L_11_13DG_2  # a train comes into 9-15DG at 11-13DG|9-15DG@11.reverse (R9)
        NU_9_15DG_2 = VALID and F_9_15DG and (not D_9_15DG) and (not U_9_15DG) and L_9_15DG_2 and OCC_9_15DG and OCC_11_13DG and U_11_13DG and L_11_13DG_4  # a train comes into 9-15DG at 11-13DG|9-15DG@15.reverse (R9)
        NU_9_15DG_3 = VALID and F_9_15DG and (not D_9_15DG) and (not U_9_15DG) and (L_9_15DG_3 or L_9_15DG_4) and OCC_9_15DG and OCC_17_23DG and U_17_23DG and (L_17_23DG_1 or L_17_23DG_2 or L_17_23DG_6)  # a train comes into 9-15DG at 17-23DG|9-15DG@15.toe (R9)
        NU_9_15DG_4 = VALID and F_9_15DG and (not D_9_15DG) and (not U_9_15DG) and (L_9_15DG_5 or L_9_15DG_6) and OCC_9_15DG and OCC_3DG and ((not M_9_15DG) or U_3DG) and ((not M_9_15DG) or L_3DG_1 or L_3DG_2)  # a train comes into 9-15DG at 3DG|9-15DG@3-9.end (R9)
        NU_IAG_1 = VALID and F_IAG and (not D_IAG) and (not U_IAG) and (L_IAG_1 or L_IAG_2) and OCC_IAG and OCC_5DG and U_5DG and (L_5DG_1 or L_5DG_2)  # a train comes into IAG at 5DG|IAG@5.toe (R9)
        NU_IAG_2 = VALID and F_IAG and (not D_IAG) and (not U_IAG) and L_IAG_2 and OCC_IAG and OCC_XJG  # a train comes into IAG at BX (R9)
        NU_IG_1 = VALID and F_IG and (not D_IG) and (not U_IG) and L_IG_1 and OCC_IG and OCC_17_23DG and U_17_23DG and L_17_23DG_5  # a train comes into IG at 17-23DG|IG@tI.0 (R9)
        NU_IIAG_1 = VALID and F_IIAG and (not D_IIAG) and (not U_IIAG) and L_IIAG_1 and OCC_IIAG and OCC_1DG and U_1DG and (L_1DG_1 or L_1DG_2)  # a train comes into IIAG at 1DG|IIAG@1.toe (R9)
        NU_IIG_1 = VALID and F_IIG and (not D_IIG) and (not U_IIG) and L_IIG_1 and OCC_IIG and OCC_19_27DG and U_19_27DG and (L_19_27DG_2 or L_19_27DG_4)  # a train comes into IIG at 19-27DG|IIG@tII.0 (R9)
        NU_IIIG_1 = VALID and F_IIIG and (not D_IIIG) and (not U_IIIG) and L_IIIG_1 and OCC_IIIG and OCC_25DG and U_25DG and (L_25DG_1 or L_25DG_2)  # a train comes into IIIG at 25DG|IIIG@tIII.0 (R9)
        ATI_D1 = X_D1 or ((not (A_R1 or A_R2)) and (L_1DG_3 or L_1DG_4) and (REL_1DG or (L_1DG_3 and (not M_1DG) and U_1DG and (not OCC_1DG))))  # D1 at stop, waiting for a train that may still come (R8)
        ATI_D11 = X_D11 or ((not (A_R3 or A_R4 or A_R5)) and (not (PA_R3 or PA_R4 or PA_R5)) and (L_11_13DG_3 or L_11_13DG_4) and REL_11_13DG)  # D11 at stop, waiting for a train that may still come (R8)
        ATI_D13 = X_D13 or ((not (A_R6 or A_R7 or A_R8 or A_R9)) and (not (PA_R6 or PA_R7 or PA_R8 or PA_R9)) and (L_17_23DG_3 or L_17_23DG_4 or L_17_23DG_5) and (REL_17_23DG or (L_17_23DG_5 and (not M_17_23DG) and U_17_23DG and (not OCC_17_23DG))))  # D13 at stop, waiting for a train that may still come (R8)
        ATI_D15 = X_D15 or ((not (A_R10 or A_R11)) and (L_19_27DG_1 or L_19_27DG_2) and (REL_19_27DG or (((L_19_27DG_1 and (not M_19_27DG)) or (L_19_27DG_2 and (not M_19_27DG))) and U_19_27DG and (not OCC_19_27DG))))  # D15 at stop, waiting for a train that may still come (R8)
        ATI_D17 = X_D17 or ((not (A_R12 or A_R13)) and L_17_23DG_6 and REL_17_23DG)  # D17 at stop, waiting for a train that may still come (R8)
        ATI_D3 = X_D3 or ((not (A_R14 or A_R15)) and (L_5DG_3 or L_5DG_4) and REL_5DG)  # D3 at stop, waiting for a train that may still come (R8)
        ATI_D5 = X_D5 or ((not A_R16) and L_1DG_1 and (REL_1DG or (L_1DG_1 and (not M_1DG) and U_1DG and (not OCC_1DG))))  # D5 at stop, waiting for a train that may still come (R8)
        ATI_D7 = X_D7 or ((not (A_R17 or A_R18)) and (not (PA_R17 or PA_R18)) and (L_3DG_3 or L_3DG_4) and REL_3DG)  # D7 at stop, waiting for a train that may still come (R8)
        ATI_D9 = X_D9 or ((not (A_R19 or A_R20 or A_R21)) and (not (PA_R19 or PA_R20 or PA_R21)) and (L_9_15DG_5 or L_9_15DG_6) and REL_9_15DG)  # D9 at stop, waiting for a train that may still come (R8)
        ATI_S4 = X_S4 or ((not (A_R22 or A_R23 or A_R24 or A_R25 or A_R26 or A_R27)) and (L_19_27DG_5 or L_19_27DG_6) and (REL_19_27DG or (L_19_27DG_5 and (not M_19_27DG) and U_19_27DG and (not OCC_19_27DG))))  # S4 at stop, waiting for a train that may still come (R8)
        ATI_S5 = X_S5 or ((not (A_R28 or A_R29 or A_R30 or A_R31)) and L_21DG_4 and REL_21DG)  # S5 at stop, waiting for a train that may still come (R8)
        ATI_SII = X_SII or ((not (A_R32 or A_R33 or A_R34 or A_R35 or A_R36 or A_R37)) and (L_19_27DG_7 or L_19_27DG_8) and (REL_19_27DG or (L_19_27DG_7 and (not M_19_27DG) and U_19_27DG and (not OCC_19_27DG))))  # SII at stop, waiting for a train that may still come (R8)
        ATI_SIII = X_SIII or ((not (A_R38 or A_R39 or A_R40 or A_R41 or A_R42 or A_R43 or A_R44 or A_R45)) and (L_25DG_3 or L_25DG_4) and REL_25DG)  # SIII at stop, waiting for a train that may still come (R8)
        ATI_X = X_X or ((not (A_R46 or A_R47 or A_R48 or A_R49 or A_R50 or A_R51 or A_R52 or A_R53 or A_R54 or A_R55 or A_R56 or A_R57 or A_R58 or A_R59 or A_R60 or A_R61 or A_R62 or A_R63 or A_R64 or A_R65)) and L_IAG_2 and REL_IAG)  # X at stop, waiting for a train that may still come (R8)
        ATI_XD = X_XD or ((not (A_R66 or A_R67 or A_R68 or A_R69 or A_R70 or A_R71 or A_R72 or A_R73 or A_R74 or A_R75)) and L_7DG_4 and REL_7DG)  # XD at stop, waiting for a train that may still come (R8)
        AT_D1 = self._timer('AT_D1', ATI_D1, dt_ms)  # D1: approach locking delay (R8)
        AT_D11 = self._timer('AT_D11', ATI_D11, dt_ms)  # D11: approach locking delay (R8)
        AT_D13 = self._timer('AT_D13', ATI_D13, dt_ms)  # D13: approach locking delay (R8)
        AT_D15 = self._timer('AT_D15', ATI_D15, dt_ms)  # D15: approach locking delay (R8)
        AT_D17 = self._timer('AT_D17', ATI_D17, dt_ms)  # D17: approach locking delay (R8)
        AT_D3 = self._timer('AT_D3', ATI_D3, dt_ms)  # D3: approach locking delay (R8)
        AT_D5 = self._timer('AT_D5', ATI_D5, dt_ms)  # D5: approach locking delay (R8)
        AT_D7 = self._timer('AT_D7', ATI_D7, dt_ms)  # D7: approach locking delay (R8)
        AT_D9 = self._timer('AT_D9', ATI_D9, dt_ms)  # D9: approach locking delay (R8)
        AT_S4 = self._timer('AT_S4', ATI_S4, dt_ms)  # S4: approach locking delay (R8)
        AT_S5 = self._timer('AT_S5', ATI_S5, dt_ms)  # S5: approach locking delay (R8)
        AT_SII = self._timer('AT_SII', ATI_SII, dt_ms)  # SII: approach locking delay (R8)
        AT_SIII = self._timer('AT_SIII', ATI_SIII, dt_ms)  # SIII: approach locking delay (R8)
        AT_X = self._timer('AT_X', ATI_X, dt_ms)  # X: approach locking delay (R8)
        AT_XD = self._timer('AT_XD', ATI_XD, dt_ms)  # XD: approach locking delay (R8)
        CD_D1 = X_D1 and (A_R1 or A_R2) and VALID and (not OCC_1DG) and ((not OCC_IIAG) or AT_D1 or (not (H_R1 or H_R2)))  # the route from D1 is cancelled (R8)
        CD_D11 = X_D11 and (A_R3 or A_R4 or A_R5) and VALID and (not OCC_11_13DG) and ((not OCC_7DG) or AT_D11 or (not (H_R3 or H_R4 or H_R5)))  # the route from D11 is cancelled (R8)
        CD_D13 = X_D13 and (A_R6 or A_R7 or A_R8 or A_R9) and VALID and (not OCC_17_23DG) and ((not OCC_9_15DG) or AT_D13 or (not (H_R6 or H_R7 or H_R8 or H_R9)))  # the route from D13 is cancelled (R8)
        CD_D15 = X_D15 and (A_R10 or A_R11) and VALID and (not OCC_19_27DG) and ((not OCC_1_19WG) or AT_D15 or (not (H_R10 or H_R11)))  # the route from D15 is cancelled (R8)
        CD_D17 = X_D17 and (A_R12 or A_R13) and VALID and (not OCC_17_23DG) and ((not OCC_IG) or AT_D17 or (not (H_R12 or H_R13)))  # the route from D17 is cancelled (R8)
        CD_D3 = X_D3 and (A_R14 or A_R15) and VALID and (not OCC_5DG) and ((not OCC_IAG) or AT_D3 or (not (H_R14 or H_R15)))  # the route from D3 is cancelled (R8)
        CD_D5 = X_D5 and A_R16 and VALID and (not OCC_1DG) and ((not OCC_1_19WG) or AT_D5 or (not H_R16))  # the route from D5 is cancelled (R8)
        CD_D7 = X_D7 and (A_R17 or A_R18) and VALID and (not OCC_3DG) and ((not OCC_9_15DG) or AT_D7 or (not (H_R17 or H_R18)))  # the route from D7 is cancelled (R8)
        CD_D9 = X_D9 and (A_R19 or A_R20 or A_R21) and VALID and (not OCC_9_15DG) and ((not OCC_3DG) or AT_D9 or (not (H_R19 or H_R20 or H_R21)))  # the route from D9 is cancelled (R8)
        CD_S4 = X_S4 and (A_R22 or A_R23 or A_R24 or A_R25 or A_R26 or A_R27) and VALID and (not OCC_19_27DG) and ((not OCC_4G) or AT_S4 or (not (H_R22 or H_R23 or H_R24 or H_R25 or H_R26 or H_R27)))  # the route from S4 is cancelled (R8)
        CD_S5 = X_S5 and (A_R28 or A_R29 or A_R30 or A_R31) and VALID and (not OCC_21DG) and ((not OCC_5G) or AT_S5 or (not (H_R28 or H_R29 or H_R30 or H_R31)))  # the route from S5 is cancelled (R8)
        CD_SII = X_SII and (A_R32 or A_R33 or A_R34 or A_R35 or A_R36 or A_R37) and VALID and (not OCC_19_27DG) and ((not OCC_IIG) or AT_SII or (not (H_R32 or H_R33 or H_R34 or H_R35 or H_R36 or H_R37)))  # the route from SII is cancelled (R8)
        CD_SIII = X_SIII and (A_R38 or A_R39 or A_R40 or A_R41 or A_R42 or A_R43 or A_R44 or A_R45) and VALID and (not OCC_25DG) and ((not OCC_IIIG) or AT_SIII or (not (H_R38 or H_R39 or H_R40 or H_R41 or H_R42 or H_R43 or H_R44 or H_R45)))  # the route from SIII is cancelled (R8)
        CD_X = X_X and (A_R46 or A_R47 or A_R48 or A_R49 or A_R50 or A_R51 or A_R52 or A_R53 or A_R54 or A_R55 or A_R56 or A_R57 or A_R58 or A_R59 or A_R60 or A_R61 or A_R62 or A_R63 or A_R64 or A_R65) and VALID and (not OCC_IAG) and ((not OCC_XJG) or AT_X or (not (H_R46 or H_R47 or H_R48 or H_R49 or H_R50 or H_R51 or H_R52 or H_R53 or H_R54 or H_R55 or H_R56 or H_R57 or H_R58 or H_R59 or H_R60 or H_R61 or H_R62 or H_R63 or H_R64 or H_R65)))  # the route from X is cancelled (R8)
        CD_XD = X_XD and (A_R66 or A_R67 or A_R68 or A_R69 or A_R70 or A_R71 or A_R72 or A_R73 or A_R74 or A_R75) and VALID and (not OCC_7DG) and ((not OCC_XDJG) or AT_XD or (not (H_R66 or H_R67 or H_R68 or H_R69 or H_R70 or H_R71 or H_R72 or H_R73 or H_R74 or H_R75)))  # the route from XD is cancelled (R8)
        EX_1_19WG = P_1_19WG  # a train in 1/19WG leaves over a boundary, or has passed on
        RTI_1_19WG = VALID and U_1_19WG and (not OCC_1_19WG) and (not (G_R1 or G_R25 or G_R35)) and (not (L_19_27DG_5 or L_19_27DG_7)) and (not L_1DG_3) and EX_1_19WG  # 1/19WG may be released behind the train (R9)
        EX_11_13DG = P_11_13DG  # a train in 11-13DG leaves over a boundary, or has passed on
        RTI_11_13DG = VALID and U_11_13DG and (not OCC_11_13DG) and (not (PA_R3 or PA_R4 or PA_R5)) and (not ((L_11_13DG_1 or L_11_13DG_2) and (L_21DG_3 or L_21DG_4))) and (not ((L_11_13DG_3 or L_11_13DG_4) and (L_7DG_3 or L_7DG_4) and M_11_13DG and M_7DG)) and (not (L_11_13DG_5 and L_9_15DG_5)) and (not (L_11_13DG_6 and L_9_15DG_3)) and EX_11_13DG  # 11-13DG may be released behind the train (R9)
        EX_17_23DG = P_17_23DG or (L_17_23DG_5 and (not M_17_23DG) and OCC_IG and ((not OCC_9_15DG) or AT_D13))  # a train in 17-23DG leaves over a boundary, or has passed on
        RTI_17_23DG = VALID and U_17_23DG and (not OCC_17_23DG) and (not (PA_R6 or PA_R7 or PA_R8 or PA_R9)) and (not (L_17_23DG_1 and (L_19_27DG_6 or L_19_27DG_8))) and (not (L_17_23DG_2 and L_25DG_3)) and (not ((L_17_23DG_3 or L_17_23DG_4 or L_17_23DG_5) and (L_9_15DG_2 or L_9_15DG_6) and M_17_23DG and M_9_15DG)) and EX_17_23DG  # 17-23DG may be released behind the train (R9)
        EX_19_27DG = P_19_27DG or (L_19_27DG_1 and (not M_19_27DG) and OCC_4G and ((not OCC_1_19WG) or AT_D15)) or (L_19_27DG_2 and (not M_19_27DG) and OCC_IIG and ((not OCC_1_19WG) or AT_D15)) or (L_19_27DG_3 and (not M_19_27DG) and OCC_4G) or (L_19_27DG_4 and (not M_19_27DG) and OCC_IIG) or (L_19_27DG_5 and (not M_19_27DG) and OCC_1_19WG and ((not OCC_4G) or AT_S4)) or (L_19_27DG_7 and (not M_19_27DG) and OCC_1_19WG and ((not OCC_IIG) or AT_SII))  # a train in 19-27DG leaves over a boundary, or has passed on
        RTI_19_27DG = VALID and U_19_27DG and (not OCC_19_27DG) and (not ((L_19_27DG_1 or L_19_27DG_2) and L_1_19WG_2 and M_19_27DG and M_1_19WG)) and (not ((L_19_27DG_3 or L_19_27DG_4) and L_17_23DG_3)) and EX_19_27DG  # 19-27DG may be released behind the train (R9)
        EX_1DG = P_1DG or (L_1DG_1 and (not M_1DG) and OCC_IIAG and ((not OCC_1_19WG) or AT_D5)) or (L_1DG_2 and (not M_1DG) and OCC_IIAG) or (L_1DG_3 and (not M_1DG) and OCC_1_19WG and ((not OCC_IIAG) or AT_D1))  # a train in 1DG leaves over a boundary, or has passed on
        RTI_1DG = VALID and U_1DG and (not OCC_1DG) and (not (L_1DG_1 and L_1_19WG_1 and M_1DG and M_1_19WG)) and (not (L_1DG_2 and L_3DG_3)) and EX_1DG  # 1DG may be released behind the train (R9)
        EX_21DG = P_21DG or (L_21DG_2 and (not M_21DG) and OCC_5G)  # a train in 21DG leaves over a boundary, or has passed on
        RTI_21DG = VALID and U_21DG and (not OCC_21DG) and (not ((L_21DG_1 or L_21DG_2) and (L_11_13DG_3 or L_11_13DG_5))) and (not (L_21DG_3 and L_25DG_4)) and EX_21DG  # 21DG may be released behind the train (R9)
        EX_25DG = P_25DG or (L_25DG_1 and (not M_25DG) and OCC_IIIG) or (L_25DG_2 and (not M_25DG) and OCC_IIIG)  # a train in 25DG leaves over a boundary, or has passed on
        RTI_25DG = VALID and U_25DG and (not OCC_25DG) and (not (L_25DG_1 and L_17_23DG_4)) and (not (L_25DG_2 and L_21DG_1)) and EX_25DG  # 25DG may be released behind the train (R9)
        EX_3DG = P_3DG  # a train in 3DG leaves over a boundary, or has passed on
        RTI_3DG = VALID and U_3DG and (not OCC_3DG) and (not (PA_R17 or PA_R18)) and (not (L_3DG_1 and L_1DG_4)) and (not (L_3DG_2 and L_5DG_3)) and (not ((L_3DG_3 or L_3DG_4) and (L_9_15DG_1 or L_9_15DG_4) and M_3DG and M_9_15DG)) and EX_3DG  # 3DG may be released behind the train (R9)
        EX_4G = P_4G or L_4G_1  # a train in 4G leaves over a boundary, or has passed on
        RTI_4G = VALID and U_4G and (not OCC_4G) and (not (G_R6 or G_R10)) and (not (L_19_27DG_1 or L_19_27DG_3)) and EX_4G  # 4G may be released behind the train (R9)
        EX_5DG = P_5DG or (L_5DG_1 and (not M_5DG) and OCC_IAG) or (L_5DG_2 and (not M_5DG) and OCC_IAG)  # a train in 5DG leaves over a boundary, or has passed on
        RTI_5DG = VALID and U_5DG and (not OCC_5DG) and (not (L_5DG_1 and L_3DG_4)) and (not (L_5DG_2 and L_7DG_1)) and (not ((L_5DG_3 or L_5DG_4) and L_IAG_2 and M_5DG and M_IAG)) and EX_5DG  # 5DG may be released behind the train (R9)
        EX_5G = P_5G or L_5G_1  # a train in 5G leaves over a boundary, or has passed on
        RTI_5G = VALID and U_5G and (not OCC_5G) and (not (G_R3 or G_R19)) and (not L_21DG_2) and EX_5G  # 5G may be released behind the train (R9)
        EX_7DG = P_7DG or L_7DG_2  # a train in 7DG leaves over a boundary, or has passed on
        RTI_7DG = VALID and U_7DG and (not OCC_7DG) and (not ((L_7DG_1 or L_7DG_2) and (L_11_13DG_1 or L_11_13DG_6))) and (not (L_7DG_3 and L_5DG_4)) and EX_7DG  # 7DG may be released behind the train (R9)
        EX_9_15DG = P_9_15DG  # a train in 9-15DG leaves over a boundary, or has passed on
        RTI_9_15DG = VALID and U_9_15DG and (not OCC_9_15DG) and (not (PA_R19 or PA_R20 or PA_R21)) and (not (L_9_15DG_1 and L_11_13DG_2)) and (not (L_9_15DG_2 and L_11_13DG_4)) and (not ((L_9_15DG_3 or L_9_15DG_4) and (L_17_23DG_1 or L_17_23DG_2 or L_17_23DG_6))) and (not ((L_9_15DG_5 or L_9_15DG_6) and (L_3DG_1 or L_3DG_2) and M_9_15DG and M_3DG)) and EX_9_15DG  # 9-15DG may be released behind the train (R9)
        EX_IAG = P_IAG or L_IAG_1  # a train in IAG leaves over a boundary, or has passed on
        RTI_IAG = VALID and U_IAG and (not OCC_IAG) and (not (G_R13 or G_R17 or G_R27 or G_R31 or G_R37 or G_R44 or G_R45)) and (not (L_5DG_1 or L_5DG_2)) and EX_IAG  # IAG may be released behind the train (R9)
        EX_IG = P_IG or L_IG_1  # a train in IG leaves over a boundary, or has passed on
        RTI_IG = VALID and U_IG and (not OCC_IG) and (not G_R7) and (not L_17_23DG_5) and EX_IG  # IG may be released behind the train (R9)
        EX_IIAG = P_IIAG or L_IIAG_1  # a train in IIAG leaves over a boundary, or has passed on
        RTI_IIAG = VALID and U_IIAG and (not OCC_IIAG) and (not (G_R16 or G_R18)) and (not (L_1DG_1 or L_1DG_2)) and EX_IIAG  # IIAG may be released behind the train (R9)
        EX_IIG = P_IIG or L_IIG_1  # a train in IIG leaves over a boundary, or has passed on
        RTI_IIG = VALID and U_IIG and (not OCC_IIG) and (not (G_R8 or G_R11)) and (not (L_19_27DG_2 or L_19_27DG_4)) and EX_IIG  # IIG may be released behind the train (R9)
        EX_IIIG = P_IIIG or L_IIIG_1  # a train in IIIG leaves over a boundary, or has passed on
        RTI_IIIG = VALID and U_IIIG and (not OCC_IIIG) and (not (G_R5 or G_R9 or G_R21)) and (not (L_25DG_1 or L_25DG_2)) and EX_IIIG  # IIIG may be released behind the train (R9)
        RT_1_19WG = self._timer('RT_1_19WG', RTI_1_19WG, dt_ms)  # 1/19WG: release delay (R9)
        RT_11_13DG = self._timer('RT_11_13DG', RTI_11_13DG, dt_ms)  # 11-13DG: release delay (R9)
        RT_17_23DG = self._timer('RT_17_23DG', RTI_17_23DG, dt_ms)  # 17-23DG: release delay (R9)
        RT_19_27DG = self._timer('RT_19_27DG', RTI_19_27DG, dt_ms)  # 19-27DG: release delay (R9)
        RT_1DG = self._timer('RT_1DG', RTI_1DG, dt_ms)  # 1DG: release delay (R9)
        RT_21DG = self._timer('RT_21DG', RTI_21DG, dt_ms)  # 21DG: release delay (R9)
        RT_25DG = self._timer('RT_25DG', RTI_25DG, dt_ms)  # 25DG: release delay (R9)
        RT_3DG = self._timer('RT_3DG', RTI_3DG, dt_ms)  # 3DG: release delay (R9)
        RT_4G = self._timer('RT_4G', RTI_4G, dt_ms)  # 4G: release delay (R9)
        RT_5DG = self._timer('RT_5DG', RTI_5DG, dt_ms)  # 5DG: release delay (R9)
        RT_5G = self._timer('RT_5G', RTI_5G, dt_ms)  # 5G: release delay (R9)
        RT_7DG = self._timer('RT_7DG', RTI_7DG, dt_ms)  # 7DG: release delay (R9)
        RT_9_15DG = self._timer('RT_9_15DG', RTI_9_15DG, dt_ms)  # 9-15DG: release delay (R9)
        RT_IAG = self._timer('RT_IAG', RTI_IAG, dt_ms)  # IAG: release delay (R9)
        RT_IG = self._timer('RT_IG', RTI_IG, dt_ms)  # IG: release delay (R9)
        RT_IIAG = self._timer('RT_IIAG', RTI_IIAG, dt_ms)  # IIAG: release delay (R9)
        RT_IIG = self._timer('RT_IIG', RTI_IIG, dt_ms)  # IIG: release delay (R9)
        RT_IIIG = self._timer('RT_IIIG', RTI_IIIG, dt_ms)  # IIIG: release delay (R9)
        AR_1_19WG = VALID and U_1_19WG and (not (G_R1 or G_R25 or G_R35)) and (not (L_19_27DG_5 or L_19_27DG_7)) and (not L_1DG_3) and (not (L_1_19WG_2 and (L_19_27DG_1 or L_19_27DG_2) and M_19_27DG and M_1_19WG)) and (not (L_1_19WG_1 and L_1DG_1 and M_1DG and M_1_19WG))  # a train has arrived in 1/19WG, wholly (R2)
        CA_1_19WG = VALID and (not OCC_1_19WG) and (not U_1_19WG) and (L_1_19WG_1 or L_1_19WG_2) and (not (G_R1 or G_R25 or G_R35)) and (not (L_19_27DG_5 or L_19_27DG_7)) and (not L_1DG_3)  # the lock before 1/19WG was withdrawn (R8)
        HR_1_19WG = VALID and (not OCC_1_19WG) and (not (G_R1 or G_R25 or G_R35)) and (not (L_19_27DG_5 or L_19_27DG_7)) and (not L_1DG_3) and REL_1_19WG and (L_1_19WG_1 or L_1_19WG_2)  # 1/19WG released by hand (R8, section fault release)
        SR_1_19WG = VALID and (not OCC_1_19WG) and K_1_19WG and (REL_1_19WG or RELALL) and (not (G_R1 or G_R25 or G_R35)) and (not (L_19_27DG_5 or L_19_27DG_7)) and (not L_1DG_3)  # 1/19WG released after a restart (R16)
        RLS_1_19WG = RT_1_19WG or CA_1_19WG or HR_1_19WG or SR_1_19WG  # 1/19WG is released
        CA_11_13DG = VALID and (not OCC_11_13DG) and (not U_11_13DG) and (L_11_13DG_1 or L_11_13DG_2 or ((L_11_13DG_3 or L_11_13DG_4) and M_11_13DG) or L_11_13DG_5 or L_11_13DG_6) and (not ((L_11_13DG_1 or L_11_13DG_2) and (L_21DG_3 or L_21DG_4))) and (not ((L_11_13DG_3 or L_11_13DG_4) and (L_7DG_3 or L_7DG_4) and M_11_13DG and M_7DG)) and (not (L_11_13DG_5 and L_9_15DG_5)) and (not (L_11_13DG_6 and L_9_15DG_3))  # the lock before 11-13DG was withdrawn (R8)
        HR_11_13DG = VALID and (not OCC_11_13DG) and (not (PA_R3 or PA_R4 or PA_R5)) and (not ((L_11_13DG_1 or L_11_13DG_2) and (L_21DG_3 or L_21DG_4))) and (not ((L_11_13DG_3 or L_11_13DG_4) and (L_7DG_3 or L_7DG_4) and M_11_13DG and M_7DG)) and (not (L_11_13DG_5 and L_9_15DG_5)) and (not (L_11_13DG_6 and L_9_15DG_3)) and REL_11_13DG and (L_11_13DG_1 or L_11_13DG_2 or L_11_13DG_3 or L_11_13DG_4 or L_11_13DG_5 or L_11_13DG_6) and ((not (L_11_13DG_3 or L_11_13DG_4)) or ((not (A_R3 or A_R4 or A_R5)) and ((not OCC_7DG) or AT_D11)))  # 11-13DG released by hand (R8, section fault release)
        SR_11_13DG = VALID and (not OCC_11_13DG) and K_11_13DG and (REL_11_13DG or RELALL)  # 11-13DG released after a restart (R16)
        RLS_11_13DG = RT_11_13DG or CA_11_13DG or CD_D11 or HR_11_13DG or SR_11_13DG  # 11-13DG is released
        CA_17_23DG = VALID and (not OCC_17_23DG) and (not U_17_23DG) and (L_17_23DG_1 or L_17_23DG_2 or ((L_17_23DG_3 or L_17_23DG_4 or L_17_23DG_5) and M_17_23DG) or (L_17_23DG_6 and M_17_23DG)) and (not (L_17_23DG_1 and (L_19_27DG_6 or L_19_27DG_8))) and (not (L_17_23DG_2 and L_25DG_3)) and (not ((L_17_23DG_3 or L_17_23DG_4 or L_17_23DG_5) and (L_9_15DG_2 or L_9_15DG_6) and M_17_23DG and M_9_15DG))  # the lock before 17-23DG was withdrawn (R8)
        HR_17_23DG = VALID and (not OCC_17_23DG) and (not (PA_R6 or PA_R7 or PA_R8 or PA_R9)) and (not (L_17_23DG_1 and (L_19_27DG_6 or L_19_27DG_8))) and (not (L_17_23DG_2 and L_25DG_3)) and (not ((L_17_23DG_3 or L_17_23DG_4 or L_17_23DG_5) and (L_9_15DG_2 or L_9_15DG_6) and M_17_23DG and M_9_15DG)) and REL_17_23DG and (L_17_23DG_1 or L_17_23DG_2 or L_17_23DG_3 or L_17_23DG_4 or L_17_23DG_5 or L_17_23DG_6) and ((not (L_17_23DG_3 or L_17_23DG_4 or L_17_23DG_5)) or ((not (A_R6 or A_R7 or A_R8 or A_R9)) and ((not OCC_9_15DG) or AT_D13))) and ((not L_17_23DG_6) or ((not (A_R12 or A_R13)) and ((not OCC_IG) or AT_D17)))  # 17-23DG released by hand (R8, section fault release)
        SR_17_23DG = VALID and (not OCC_17_23DG) and K_17_23DG and (REL_17_23DG or RELALL)  # 17-23DG released after a restart (R16)
        RLS_17_23DG = RT_17_23DG or CA_17_23DG or CD_D13 or CD_D17 or HR_17_23DG or SR_17_23DG  # 17-23DG is released
        CA_19_27DG = VALID and (not OCC_19_27DG) and (not U_19_27DG) and (((L_19_27DG_1 or L_19_27DG_2) and M_19_27DG) or L_19_27DG_3 or L_19_27DG_4) and (not ((L_19_27DG_1 or L_19_27DG_2) and L_1_19WG_2 and M_19_27DG and M_1_19WG)) and (not ((L_19_27DG_3 or L_19_27DG_4) and L_17_23DG_3))  # the lock before 19-27DG was withdrawn (R8)
        HR_19_27DG = VALID and (not OCC_19_27DG) and (not ((L_19_27DG_1 or L_19_27DG_2) and L_1_19WG_2 and M_19_27DG and M_1_19WG)) and (not ((L_19_27DG_3 or L_19_27DG_4) and L_17_23DG_3)) and REL_19_27DG and (L_19_27DG_1 or L_19_27DG_2 or L_19_27DG_3 or L_19_27DG_4 or L_19_27DG_5 or L_19_27DG_6 or L_19_27DG_7 or L_19_27DG_8) and ((not (L_19_27DG_1 or L_19_27DG_2)) or ((not (A_R10 or A_R11)) and ((not OCC_1_19WG) or AT_D15))) and ((not (L_19_27DG_5 or L_19_27DG_6)) or ((not (A_R22 or A_R23 or A_R24 or A_R25 or A_R26 or A_R27)) and ((not OCC_4G) or AT_S4))) and ((not (L_19_27DG_7 or L_19_27DG_8)) or ((not (A_R32 or A_R33 or A_R34 or A_R35 or A_R36 or A_R37)) and ((not OCC_IIG) or AT_SII)))  # 19-27DG released by hand (R8, section fault release)
        SR_19_27DG = VALID and (not OCC_19_27DG) and K_19_27DG and (REL_19_27DG or RELALL)  # 19-27DG released after a restart (R16)
        RLS_19_27DG = RT_19_27DG or CA_19_27DG or CD_D15 or CD_S4 or CD_SII or HR_19_27DG or SR_19_27DG  # 19-27DG is released
        CA_1DG = VALID and (not OCC_1DG) and (not U_1DG) and ((L_1DG_1 and M_1DG) or L_1DG_2 or ((L_1DG_3 or L_1DG_4) and M_1DG)) and (not (L_1DG_1 and L_1_19WG_1 and M_1DG and M_1_19WG)) and (not (L_1DG_2 and L_3DG_3))  # the lock before 1DG was withdrawn (R8)
        HR_1DG = VALID and (not OCC_1DG) and (not (L_1DG_1 and L_1_19WG_1 and M_1DG and M_1_19WG)) and (not (L_1DG_2 and L_3DG_3)) and REL_1DG and (L_1DG_1 or L_1DG_2 or L_1DG_3 or L_1DG_4) and ((not L_1DG_1) or ((not A_R16) and ((not OCC_1_19WG) or AT_D5))) and ((not (L_1DG_3 or L_1DG_4)) or ((not (A_R1 or A_R2)) and ((not OCC_IIAG) or AT_D1)))  # 1DG released by hand (R8, section fault release)
        SR_1DG = VALID and (not OCC_1DG) and K_1DG and (REL_1DG or RELALL)  # 1DG released after a restart (R16)
        RLS_1DG = RT_1DG or CA_1DG or CD_D5 or CD_D1 or HR_1DG or SR_1DG  # 1DG is released
        CA_21DG = VALID and (not OCC_21DG) and (not U_21DG) and (L_21DG_1 or L_21DG_2 or L_21DG_3) and (not ((L_21DG_1 or L_21DG_2) and (L_11_13DG_3 or L_11_13DG_5))) and (not (L_21DG_3 and L_25DG_4))  # the lock before 21DG was withdrawn (R8)
        HR_21DG = VALID and (not OCC_21DG) and (not ((L_21DG_1 or L_21DG_2) and (L_11_13DG_3 or L_11_13DG_5))) and (not (L_21DG_3 and L_25DG_4)) and REL_21DG and (L_21DG_1 or L_21DG_2 or L_21DG_3 or L_21DG_4) and ((not L_21DG_4) or ((not (A_R28 or A_R29 or A_R30 or A_R31)) and ((not OCC_5G) or AT_S5)))  # 21DG released by hand (R8, section fault release)
        SR_21DG = VALID and (not OCC_21DG) and K_21DG and (REL_21DG or RELALL)  # 21DG released after a restart (R16)
        RLS_21DG = RT_21DG or CA_21DG or CD_S5 or HR_21DG or SR_21DG  # 21DG is released
        CA_25DG = VALID and (not OCC_25DG) and (not U_25DG) and (L_25DG_1 or L_25DG_2) and (not (L_25DG_1 and L_17_23DG_4)) and (not (L_25DG_2 and L_21DG_1))  # the lock before 25DG was withdrawn (R8)
        HR_25DG = VALID and (not OCC_25DG) and (not (L_25DG_1 and L_17_23DG_4)) and (not (L_25DG_2 and L_21DG_1)) and REL_25DG and (L_25DG_1 or L_25DG_2 or L_25DG_3 or L_25DG_4) and ((not (L_25DG_3 or L_25DG_4)) or ((not (A_R38 or A_R39 or A_R40 or A_R41 or A_R42 or A_R43 or A_R44 or A_R45)) and ((not OCC_IIIG) or AT_SIII)))  # 25DG released by hand (R8, section fault release)
        SR_25DG = VALID and (not OCC_25DG) and K_25DG and (REL_25DG or RELALL)  # 25DG released after a restart (R16)
        RLS_25DG = RT_25DG or CA_25DG or CD_SIII or HR_25DG or SR_25DG  # 25DG is released
        CA_3DG = VALID and (not OCC_3DG) and (not U_3DG) and (L_3DG_1 or L_3DG_2 or ((L_3DG_3 or L_3DG_4) and M_3DG)) and (not (L_3DG_1 and L_1DG_4)) and (not (L_3DG_2 and L_5DG_3)) and (not ((L_3DG_3 or L_3DG_4) and (L_9_15DG_1 or L_9_15DG_4) and M_3DG and M_9_15DG))  # the lock before 3DG was withdrawn (R8)
        HR_3DG = VALID and (not OCC_3DG) and (not (PA_R17 or PA_R18)) and (not (L_3DG_1 and L_1DG_4)) and (not (L_3DG_2 and L_5DG_3)) and (not ((L_3DG_3 or L_3DG_4) and (L_9_15DG_1 or L_9_15DG_4) and M_3DG and M_9_15DG)) and REL_3DG and (L_3DG_1 or L_3DG_2 or L_3DG_3 or L_3DG_4) and ((not (L_3DG_3 or L_3DG_4)) or ((not (A_R17 or A_R18)) and ((not OCC_9_15DG) or AT_D7)))  # 3DG released by hand (R8, section fault release)
        SR_3DG = VALID and (not OCC_3DG) and K_3DG and (REL_3DG or RELALL)  # 3DG released after a restart (R16)
        RLS_3DG = RT_3DG or CA_3DG or CD_D7 or HR_3DG or SR_3DG  # 3DG is released
        AR_4G = VALID and U_4G and (not (G_R6 or G_R10)) and (not (L_19_27DG_1 or L_19_27DG_3))  # a train has arrived in 4G, wholly (R2)
        CA_4G = VALID and (not OCC_4G) and (not U_4G) and L_4G_1 and (not (G_R6 or G_R10)) and (not (L_19_27DG_1 or L_19_27DG_3))  # the lock before 4G was withdrawn (R8)
        HR_4G = VALID and (not OCC_4G) and (not (G_R6 or G_R10)) and (not (L_19_27DG_1 or L_19_27DG_3)) and REL_4G and L_4G_1  # 4G released by hand (R8, section fault release)
        SR_4G = VALID and (not OCC_4G) and K_4G and (REL_4G or RELALL) and (not (G_R6 or G_R10)) and (not (L_19_27DG_1 or L_19_27DG_3))  # 4G released after a restart (R16)
        RLS_4G = RT_4G or CA_4G or HR_4G or SR_4G  # 4G is released
        CA_5DG = VALID and (not OCC_5DG) and (not U_5DG) and (L_5DG_1 or L_5DG_2 or ((L_5DG_3 or L_5DG_4) and M_5DG)) and (not (L_5DG_1 and L_3DG_4)) and (not (L_5DG_2 and L_7DG_1)) and (not ((L_5DG_3 or L_5DG_4) and L_IAG_2 and M_5DG and M_IAG))  # the lock before 5DG was withdrawn (R8)
        HR_5DG = VALID and (not OCC_5DG) and (not (L_5DG_1 and L_3DG_4)) and (not (L_5DG_2 and L_7DG_1)) and (not ((L_5DG_3 or L_5DG_4) and L_IAG_2 and M_5DG and M_IAG)) and REL_5DG and (L_5DG_1 or L_5DG_2 or L_5DG_3 or L_5DG_4) and ((not (L_5DG_3 or L_5DG_4)) or ((not (A_R14 or A_R15)) and ((not OCC_IAG) or AT_D3)))  # 5DG released by hand (R8, section fault release)
        SR_5DG = VALID and (not OCC_5DG) and K_5DG and (REL_5DG or RELALL)  # 5DG released after a restart (R16)
        RLS_5DG = RT_5DG or CA_5DG or CD_D3 or HR_5DG or SR_5DG  # 5DG is released
        AR_5G = VALID and U_5G and (not (G_R3 or G_R19)) and (not L_21DG_2)  # a train has arrived in 5G, wholly (R2)
        CA_5G = VALID and (not OCC_5G) and (not U_5G) and L_5G_1 and (not (G_R3 or G_R19)) and (not L_21DG_2)  # the lock before 5G was withdrawn (R8)
        HR_5G = VALID and (not OCC_5G) and (not (G_R3 or G_R19)) and (not L_21DG_2) and REL_5G and L_5G_1  # 5G released by hand (R8, section fault release)
        SR_5G = VALID and (not OCC_5G) and K_5G and (REL_5G or RELALL) and (not (G_R3 or G_R19)) and (not L_21DG_2)  # 5G released after a restart (R16)
        RLS_5G = RT_5G or CA_5G or HR_5G or SR_5G  # 5G is released
        CA_7DG = VALID and (not OCC_7DG) and (not U_7DG) and (L_7DG_1 or L_7DG_2 or L_7DG_3) and (not ((L_7DG_1 or L_7DG_2) and (L_11_13DG_1 or L_11_13DG_6))) and (not (L_7DG_3 and L_5DG_4))  # the lock before 7DG was withdrawn (R8)
        HR_7DG = VALID and (not OCC_7DG) and (not ((L_7DG_1 or L_7DG_2) and (L_11_13DG_1 or L_11_13DG_6))) and (not (L_7DG_3 and L_5DG_4)) and REL_7DG and (L_7DG_1 or L_7DG_2 or L_7DG_3 or L_7DG_4) and ((not L_7DG_4) or ((not (A_R66 or A_R67 or A_R68 or A_R69 or A_R70 or A_R71 or A_R72 or A_R73 or A_R74 or A_R75)) and ((not OCC_XDJG) or AT_XD)))  # 7DG released by hand (R8, section fault release)
        SR_7DG = VALID and (not OCC_7DG) and K_7DG and (REL_7DG or RELALL)  # 7DG released after a restart (R16)
        RLS_7DG = RT_7DG or CA_7DG or CD_XD or HR_7DG or SR_7DG  # 7DG is released
        CA_9_15DG = VALID and (not OCC_9_15DG) and (not U_9_15DG) and (L_9_15DG_1 or L_9_15DG_2 or L_9_15DG_3 or L_9_15DG_4 or ((L_9_15DG_5 or L_9_15DG_6) and M_9_15DG)) and (not (L_9_15DG_1 and L_11_13DG_2)) and (not (L_9_15DG_2 and L_11_13DG_4)) and (not ((L_9_15DG_3 or L_9_15DG_4) and (L_17_23DG_1 or L_17_23DG_2 or L_17_23DG_6))) and (not ((L_9_15DG_5 or L_9_15DG_6) and (L_3DG_1 or L_3DG_2) and M_9_15DG and M_3DG))  # the lock before 9-15DG was withdrawn (R8)
        HR_9_15DG = VALID and (not OCC_9_15DG) and (not (PA_R19 or PA_R20 or PA_R21)) and (not (L_9_15DG_1 and L_11_13DG_2)) and (not (L_9_15DG_2 and L_11_13DG_4)) and (not ((L_9_15DG_3 or L_9_15DG_4) and (L_17_23DG_1 or L_17_23DG_2 or L_17_23DG_6))) and (not ((L_9_15DG_5 or L_9_15DG_6) and (L_3DG_1 or L_3DG_2) and M_9_15DG and M_3DG)) and REL_9_15DG and (L_9_15DG_1 or L_9_15DG_2 or L_9_15DG_3 or L_9_15DG_4 or L_9_15DG_5 or L_9_15DG_6) and ((not (L_9_15DG_5 or L_9_15DG_6)) or ((not (A_R19 or A_R20 or A_R21)) and ((not OCC_3DG) or AT_D9)))  # 9-15DG released by hand (R8, section fault release)
        SR_9_15DG = VALID and (not OCC_9_15DG) and K_9_15DG and (REL_9_15DG or RELALL)  # 9-15DG released after a restart (R16)
        RLS_9_15DG = RT_9_15DG or CA_9_15DG or CD_D9 or HR_9_15DG or SR_9_15DG  # 9-15DG is released
        AR_IAG = VALID and U_IAG and (not (G_R13 or G_R17 or G_R27 or G_R31 or G_R37 or G_R44 or G_R45)) and (not (L_5DG_1 or L_5DG_2)) and (not (L_IAG_2 and OCC_XJG)) and (not (L_IAG_2 and (L_5DG_3 or L_5DG_4) and M_5DG and M_IAG))  # a train has arrived in IAG, wholly (R2)
        CA_IAG = VALID and (not OCC_IAG) and (not U_IAG) and L_IAG_1 and (not (G_R13 or G_R17 or G_R27 or G_R31 or G_R37 or G_R44 or G_R45)) and (not (L_5DG_1 or L_5DG_2))  # the lock before IAG was withdrawn (R8)
        HR_IAG = VALID and (not OCC_IAG) and (not (G_R13 or G_R17 or G_R27 or G_R31 or G_R37 or G_R44 or G_R45)) and (not (L_5DG_1 or L_5DG_2)) and REL_IAG and (L_IAG_1 or L_IAG_2) and ((not L_IAG_2) or ((not (A_R46 or A_R47 or A_R48 or A_R49 or A_R50 or A_R51 or A_R52 or A_R53 or A_R54 or A_R55 or A_R56 or A_R57 or A_R58 or A_R59 or A_R60 or A_R61 or A_R62 or A_R63 or A_R64 or A_R65)) and ((not OCC_XJG) or AT_X)))  # IAG released by hand (R8, section fault release)
        SR_IAG = VALID and (not OCC_IAG) and K_IAG and (REL_IAG or RELALL) and (not (G_R13 or G_R17 or G_R27 or G_R31 or G_R37 or G_R44 or G_R45)) and (not (L_5DG_1 or L_5DG_2))  # IAG released after a restart (R16)
        RLS_IAG = RT_IAG or CA_IAG or CD_X or HR_IAG or SR_IAG  # IAG is released
        AR_IG = VALID and U_IG and (not G_R7) and (not L_17_23DG_5)  # a train has arrived in IG, wholly (R2)
        CA_IG = VALID and (not OCC_IG) and (not U_IG) and L_IG_1 and (not G_R7) and (not L_17_23DG_5)  # the lock before IG was withdrawn (R8)
        HR_IG = VALID and (not OCC_IG) and (not G_R7) and (not L_17_23DG_5) and REL_IG and L_IG_1  # IG released by hand (R8, section fault release)
        SR_IG = VALID and (not OCC_IG) and K_IG and (REL_IG or RELALL) and (not G_R7) and (not L_17_23DG_5)  # IG released after a restart (R16)
        RLS_IG = RT_IG or CA_IG or HR_IG or SR_IG  # IG is released
        AR_IIAG = VALID and U_IIAG and (not (G_R16 or G_R18)) and (not (L_1DG_1 or L_1DG_2))  # a train has arrived in IIAG, wholly (R2)
        CA_IIAG = VALID and (not OCC_IIAG) and (not U_IIAG) and L_IIAG_1 and (not (G_R16 or G_R18)) and (not (L_1DG_1 or L_1DG_2))  # the lock before IIAG was withdrawn (R8)
        HR_IIAG = VALID and (not OCC_IIAG) and (not (G_R16 or G_R18)) and (not (L_1DG_1 or L_1DG_2)) and REL_IIAG and L_IIAG_1  # IIAG released by hand (R8, section fault release)
        SR_IIAG = VALID and (not OCC_IIAG) and K_IIAG and (REL_IIAG or RELALL) and (not (G_R16 or G_R18)) and (not (L_1DG_1 or L_1DG_2))  # IIAG released after a restart (R16)
        RLS_IIAG = RT_IIAG or CA_IIAG or HR_IIAG or SR_IIAG  # IIAG is released
        AR_IIG = VALID and U_IIG and (not (G_R8 or G_R11)) and (not (L_19_27DG_2 or L_19_27DG_4))  # a train has arrived in IIG, wholly (R2)
        CA_IIG = VALID and (not OCC_IIG) and (not U_IIG) and L_IIG_1 and (not (G_R8 or G_R11)) and (not (L_19_27DG_2 or L_19_27DG_4))  # the lock before IIG was withdrawn (R8)
        HR_IIG = VALID and (not OCC_IIG) and (not (G_R8 or G_R11)) and (not (L_19_27DG_2 or L_19_27DG_4)) and REL_IIG and L_IIG_1  # IIG released by hand (R8, section fault release)
        SR_IIG = VALID and (not OCC_IIG) and K_IIG and (REL_IIG or RELALL) and (not (G_R8 or G_R11)) and (not (L_19_27DG_2 or L_19_27DG_4))  # IIG released after a restart (R16)
        RLS_IIG = RT_IIG or CA_IIG or HR_IIG or SR_IIG  # IIG is released
        AR_IIIG = VALID and U_IIIG and (not (G_R5 or G_R9 or G_R21)) and (not (L_25DG_1 or L_25DG_2))  # a train has arrived in IIIG, wholly (R2)
        CA_IIIG = VALID and (not OCC_IIIG) and (not U_IIIG) and L_IIIG_1 and (not (G_R5 or G_R9 or G_R21)) and (not (L_25DG_1 or L_25DG_2))  # the lock before IIIG was withdrawn (R8)
        HR_IIIG = VALID and (not OCC_IIIG) and (not (G_R5 or G_R9 or G_R21)) and (not (L_25DG_1 or L_25DG_2)) and REL_IIIG and L_IIIG_1  # IIIG released by hand (R8, section fault release)
        SR_IIIG = VALID and (not OCC_IIIG) and K_IIIG and (REL_IIIG or RELALL) and (not (G_R5 or G_R9 or G_R21)) and (not (L_25DG_1 or L_25DG_2))  # IIIG released after a restart (R16)
        RLS_IIIG = RT_IIIG or CA_IIIG or HR_IIIG or SR_IIIG  # IIIG is released
        TG_1_3 = (GW_1DG_1 or GW_1DG_2 or GW_1DG_3 or GW_1DG_4 or GW_3DG_1 or GW_3DG_2 or GW_3DG_3 or GW_3DG_4)  # a grant touches machine 1/3 in this scan
        GPN_1_3 = (GW_1DG_1 or GW_1DG_3 or GW_3DG_2 or GW_3DG_4)  # a grant needs 1/3 N
        MAN_1_3 = MN_1_3 and (not MR_1_3) and MOV_1_3 and (not TG_1_3)  # machine 1/3 moved N by hand
        GPR_1_3 = (GW_1DG_2 or GW_1DG_4 or GW_3DG_1 or GW_3DG_3)  # a grant needs 1/3 R
        MAR_1_3 = MR_1_3 and (not MN_1_3) and MOV_1_3 and (not TG_1_3)  # machine 1/3 moved R by hand
        HDN_1_3 = CN_1_3 and (not GPR_1_3) and (not MAR_1_3)  # the command N stays
        HDR_1_3 = CR_1_3 and (not GPN_1_3) and (not MAN_1_3)  # the command R stays
        TG_13_15 = (GW_11_13DG_1 or GW_11_13DG_2 or GW_11_13DG_3 or GW_11_13DG_4 or GW_11_13DG_5 or GW_11_13DG_6 or GW_9_15DG_1 or GW_9_15DG_2 or GW_9_15DG_3 or GW_9_15DG_4 or GW_9_15DG_5 or GW_9_15DG_6)  # a grant touches machine 13/15 in this scan
        GPN_13_15 = (GW_11_13DG_1 or GW_11_13DG_3 or GW_9_15DG_1 or GW_9_15DG_4 or GW_9_15DG_5 or GW_9_15DG_6)  # a grant needs 13/15 N
        MAN_13_15 = MN_13_15 and (not MR_13_15) and MOV_13_15 and (not TG_13_15)  # machine 13/15 moved N by hand
        GPR_13_15 = (GW_11_13DG_4 or GW_11_13DG_6 or GW_9_15DG_2 or GW_9_15DG_3)  # a grant needs 13/15 R
        MAR_13_15 = MR_13_15 and (not MN_13_15) and MOV_13_15 and (not TG_13_15)  # machine 13/15 moved R by hand
        HDN_13_15 = CN_13_15 and (not GPR_13_15) and (not MAR_13_15)  # the command N stays
        HDR_13_15 = CR_13_15 and (not GPN_13_15) and (not MAN_13_15)  # the command R stays
        TG_17_19 = (GW_17_23DG_1 or GW_17_23DG_2 or GW_17_23DG_3 or GW_17_23DG_4 or GW_17_23DG_5 or GW_17_23DG_6 or GW_19_27DG_1 or GW_19_27DG_2 or GW_19_27DG_3 or GW_19_27DG_4 or GW_19_27DG_5 or GW_19_27DG_6 or GW_19_27DG_7 or GW_19_27DG_8)  # a grant touches machine 17/19 in this scan
        GPN_17_19 = (GW_17_23DG_2 or GW_17_23DG_4 or GW_17_23DG_5 or GW_17_23DG_6 or GW_19_27DG_1 or GW_19_27DG_2 or GW_19_27DG_5 or GW_19_27DG_7)  # a grant needs 17/19 N
        MAN_17_19 = MN_17_19 and (not MR_17_19) and MOV_17_19 and (not TG_17_19)  # machine 17/19 moved N by hand
        GPR_17_19 = (GW_17_23DG_1 or GW_17_23DG_3 or GW_19_27DG_3 or GW_19_27DG_4 or GW_19_27DG_6 or GW_19_27DG_8)  # a grant needs 17/19 R
        MAR_17_19 = MR_17_19 and (not MN_17_19) and MOV_17_19 and (not TG_17_19)  # machine 17/19 moved R by hand
        HDN_17_19 = CN_17_19 and (not GPR_17_19) and (not MAR_17_19)  # the command N stays
        HDR_17_19 = CR_17_19 and (not GPN_17_19) and (not MAN_17_19)  # the command R stays
        TG_21 = (GW_21DG_1 or GW_21DG_2 or GW_21DG_3 or GW_21DG_4)  # a grant touches machine 21 in this scan
        GPN_21 = (GW_21DG_1 or GW_21DG_3)  # a grant needs 21 N
        MAN_21 = MN_21 and (not MR_21) and MOV_21 and (not TG_21)  # machine 21 moved N by hand
        GPR_21 = (GW_21DG_2 or GW_21DG_4)  # a grant needs 21 R
        MAR_21 = MR_21 and (not MN_21) and MOV_21 and (not TG_21)  # machine 21 moved R by hand
        HDN_21 = CN_21 and (not GPR_21) and (not MAR_21)  # the command N stays
        HDR_21 = CR_21 and (not GPN_21) and (not MAN_21)  # the command R stays
        TG_23_25 = (GW_17_23DG_1 or GW_17_23DG_2 or GW_17_23DG_3 or GW_17_23DG_4 or GW_17_23DG_5 or GW_17_23DG_6 or GW_25DG_1 or GW_25DG_2 or GW_25DG_3 or GW_25DG_4)  # a grant touches machine 23/25 in this scan
        GPN_23_25 = (GW_17_23DG_5 or GW_17_23DG_6 or GW_25DG_2 or GW_25DG_4) or ((G_R6 or G_R8 or G_R23 or G_R24 or G_R26 or G_R27 or G_R33 or G_R34 or G_R36 or G_R37 or G_R52 or G_R53 or G_R62 or G_R63 or G_R69 or G_R74) and MOV_23_25)  # a grant needs 23/25 N
        MAN_23_25 = MN_23_25 and (not MR_23_25) and MOV_23_25 and (not TG_23_25)  # machine 23/25 moved N by hand
        GPR_23_25 = (GW_17_23DG_2 or GW_17_23DG_4 or GW_25DG_1 or GW_25DG_3)  # a grant needs 23/25 R
        MAR_23_25 = MR_23_25 and (not MN_23_25) and MOV_23_25 and (not TG_23_25)  # machine 23/25 moved R by hand
        HDN_23_25 = CN_23_25 and (not GPR_23_25) and (not MAR_23_25)  # the command N stays
        HDR_23_25 = CR_23_25 and (not GPN_23_25) and (not MAN_23_25)  # the command R stays
        TG_27 = (GW_19_27DG_1 or GW_19_27DG_2 or GW_19_27DG_3 or GW_19_27DG_4 or GW_19_27DG_5 or GW_19_27DG_6 or GW_19_27DG_7 or GW_19_27DG_8)  # a grant touches machine 27 in this scan
        GPN_27 = (GW_19_27DG_2 or GW_19_27DG_4 or GW_19_27DG_7 or GW_19_27DG_8)  # a grant needs 27 N
        MAN_27 = MN_27 and (not MR_27) and MOV_27 and (not TG_27)  # machine 27 moved N by hand
        GPR_27 = (GW_19_27DG_1 or GW_19_27DG_3 or GW_19_27DG_5 or GW_19_27DG_6)  # a grant needs 27 R
        MAR_27 = MR_27 and (not MN_27) and MOV_27 and (not TG_27)  # machine 27 moved R by hand
        HDN_27 = CN_27 and (not GPR_27) and (not MAR_27)  # the command N stays
        HDR_27 = CR_27 and (not GPN_27) and (not MAN_27)  # the command R stays
        TG_5_7 = (GW_5DG_1 or GW_5DG_2 or GW_5DG_3 or GW_5DG_4 or GW_7DG_1 or GW_7DG_2 or GW_7DG_3 or GW_7DG_4)  # a grant touches machine 5/7 in this scan
        GPN_5_7 = (GW_5DG_1 or GW_5DG_3 or GW_7DG_2 or GW_7DG_4)  # a grant needs 5/7 N
        MAN_5_7 = MN_5_7 and (not MR_5_7) and MOV_5_7 and (not TG_5_7)  # machine 5/7 moved N by hand
        GPR_5_7 = (GW_5DG_2 or GW_5DG_4 or GW_7DG_1 or GW_7DG_3)  # a grant needs 5/7 R
        MAR_5_7 = MR_5_7 and (not MN_5_7) and MOV_5_7 and (not TG_5_7)  # machine 5/7 moved R by hand
        HDN_5_7 = CN_5_7 and (not GPR_5_7) and (not MAR_5_7)  # the command N stays
        HDR_5_7 = CR_5_7 and (not GPN_5_7) and (not MAN_5_7)  # the command R stays
        TG_9_11 = (GW_11_13DG_1 or GW_11_13DG_2 or GW_11_13DG_3 or GW_11_13DG_4 or GW_11_13DG_5 or GW_11_13DG_6 or GW_9_15DG_1 or GW_9_15DG_2 or GW_9_15DG_3 or GW_9_15DG_4 or GW_9_15DG_5 or GW_9_15DG_6)  # a grant touches machine 9/11 in this scan
        GPN_9_11 = (GW_11_13DG_1 or GW_11_13DG_3 or GW_11_13DG_4 or GW_11_13DG_6 or GW_9_15DG_4 or GW_9_15DG_6)  # a grant needs 9/11 N
        MAN_9_11 = MN_9_11 and (not MR_9_11) and MOV_9_11 and (not TG_9_11)  # machine 9/11 moved N by hand
        GPR_9_11 = (GW_11_13DG_2 or GW_11_13DG_5 or GW_9_15DG_1 or GW_9_15DG_5)  # a grant needs 9/11 R
        MAR_9_11 = MR_9_11 and (not MN_9_11) and MOV_9_11 and (not TG_9_11)  # machine 9/11 moved R by hand
        HDN_9_11 = CN_9_11 and (not GPR_9_11) and (not MAR_9_11)  # the command N stays
        HDR_9_11 = CR_9_11 and (not GPN_9_11) and (not MAN_9_11)  # the command R stays
        STI_1_3 = (CN_1_3 and (not QN_1_3)) or (CR_1_3 and (not QR_1_3))  # machine 1/3 is not where it was commanded
        STI_13_15 = (CN_13_15 and (not QN_13_15)) or (CR_13_15 and (not QR_13_15))  # machine 13/15 is not where it was commanded
        STI_17_19 = (CN_17_19 and (not QN_17_19)) or (CR_17_19 and (not QR_17_19))  # machine 17/19 is not where it was commanded
        STI_21 = (CN_21 and (not QN_21)) or (CR_21 and (not QR_21))  # machine 21 is not where it was commanded
        STI_23_25 = (CN_23_25 and (not QN_23_25)) or (CR_23_25 and (not QR_23_25))  # machine 23/25 is not where it was commanded
        STI_27 = (CN_27 and (not QN_27)) or (CR_27 and (not QR_27))  # machine 27 is not where it was commanded
        STI_5_7 = (CN_5_7 and (not QN_5_7)) or (CR_5_7 and (not QR_5_7))  # machine 5/7 is not where it was commanded
        STI_9_11 = (CN_9_11 and (not QN_9_11)) or (CR_9_11 and (not QR_9_11))  # machine 9/11 is not where it was commanded
        ST_1_3 = self._timer('ST_1_3', STI_1_3, dt_ms)  # machine 1/3: time-out
        ST_13_15 = self._timer('ST_13_15', STI_13_15, dt_ms)  # machine 13/15: time-out
        ST_17_19 = self._timer('ST_17_19', STI_17_19, dt_ms)  # machine 17/19: time-out
        ST_21 = self._timer('ST_21', STI_21, dt_ms)  # machine 21: time-out
        ST_23_25 = self._timer('ST_23_25', STI_23_25, dt_ms)  # machine 23/25: time-out
        ST_27 = self._timer('ST_27', STI_27, dt_ms)  # machine 27: time-out
        ST_5_7 = self._timer('ST_5_7', STI_5_7, dt_ms)  # machine 5/7: time-out
        ST_9_11 = self._timer('ST_9_11', STI_9_11, dt_ms)  # machine 9/11: time-out
        SGI = (not SG)  # 
        SGT = self._timer('SGT', SGI, dt_ms)  # the gap since the last start is over (R10)
        ZT_1_3 = (STI_1_3 and (not Z_1_3)) and SGT and True  # machine 1/3 starts (R10)
        ZW_1_3 = (STI_1_3 and (not Z_1_3))  # 
        ZT_13_15 = (STI_13_15 and (not Z_13_15)) and SGT and (not ZW_1_3)  # machine 13/15 starts (R10)
        ZW_13_15 = (STI_13_15 and (not Z_13_15)) or ZW_1_3  # 
        ZT_17_19 = (STI_17_19 and (not Z_17_19)) and SGT and (not ZW_13_15)  # machine 17/19 starts (R10)
        ZW_17_19 = (STI_17_19 and (not Z_17_19)) or ZW_13_15  # 
        ZT_21 = (STI_21 and (not Z_21)) and SGT and (not ZW_17_19)  # machine 21 starts (R10)
        ZW_21 = (STI_21 and (not Z_21)) or ZW_17_19  # 
        ZT_23_25 = (STI_23_25 and (not Z_23_25)) and SGT and (not ZW_21)  # machine 23/25 starts (R10)
        ZW_23_25 = (STI_23_25 and (not Z_23_25)) or ZW_21  # 
        ZT_27 = (STI_27 and (not Z_27)) and SGT and (not ZW_23_25)  # machine 27 starts (R10)
        ZW_27 = (STI_27 and (not Z_27)) or ZW_23_25  # 
        ZT_5_7 = (STI_5_7 and (not Z_5_7)) and SGT and (not ZW_27)  # machine 5/7 starts (R10)
        ZW_5_7 = (STI_5_7 and (not Z_5_7)) or ZW_27  # 
        ZT_9_11 = (STI_9_11 and (not Z_9_11)) and SGT and (not ZW_5_7)  # machine 9/11 starts (R10)
        ZW_9_11 = (STI_9_11 and (not Z_9_11)) or ZW_5_7  # 
        KP_R1 = (not NU_1DG_3) and (not CD_D1)  # route D1-D15 stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_D1) and (not CAN_D1) and (S_R1 or RL_D1)  # proceed for route D1-D15 (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route D1-D15: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_1DG_3) and (not CD_D1)  # route D1-D9 stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_D1) and (not CAN_D1) and (S_R2 or RL_D1)  # proceed for route D1-D9 (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route D1-D9: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_11_13DG_2) and (not CD_D11)  # route D11-5G stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_D11) and (not CAN_D11) and (S_R3 or RL_D11)  # proceed for route D11-5G (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route D11-5G: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_11_13DG_2) and (not CD_D11)  # route D11-D13 stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_D11) and (not CAN_D11) and (S_R4 or RL_D11)  # proceed for route D11-D13 (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route D11-D13: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_11_13DG_2) and (not CD_D11)  # route D11-IIIG stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_D11) and (not CAN_D11) and (S_R5 or RL_D11)  # proceed for route D11-IIIG (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route D11-IIIG: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_17_23DG_3) and (not CD_D13)  # route D13-4G stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_D13) and (not CAN_D13) and (S_R6 or RL_D13)  # proceed for route D13-4G (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route D13-4G: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_17_23DG_3) and (not CD_D13)  # route D13-IG stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_D13) and (not CAN_D13) and (S_R7 or RL_D13)  # proceed for route D13-IG (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route D13-IG: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_17_23DG_3) and (not CD_D13)  # route D13-IIG stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_D13) and (not CAN_D13) and (S_R8 or RL_D13)  # proceed for route D13-IIG (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route D13-IIG: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_17_23DG_3) and (not CD_D13)  # route D13-IIIG stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_D13) and (not CAN_D13) and (S_R9 or RL_D13)  # proceed for route D13-IIIG (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route D13-IIIG: a condition was lost; no reopening by itself (R14)
        KP_R10 = (not NU_19_27DG_1) and (not CD_D15)  # route D15-4G stays set
        PR_R10 = A_R10 and B_R10 and W_R10 and CO_R10 and KP_R10 and (not X_D15) and (not CAN_D15) and (S_R10 or RL_D15)  # proceed for route D15-4G (R3, R11)
        LS_R10 = S_R10 and (not CO_R10)  # route D15-4G: a condition was lost; no reopening by itself (R14)
        KP_R11 = (not NU_19_27DG_1) and (not CD_D15)  # route D15-IIG stays set
        PR_R11 = A_R11 and B_R11 and W_R11 and CO_R11 and KP_R11 and (not X_D15) and (not CAN_D15) and (S_R11 or RL_D15)  # proceed for route D15-IIG (R3, R11)
        LS_R11 = S_R11 and (not CO_R11)  # route D15-IIG: a condition was lost; no reopening by itself (R14)
        KP_R12 = (not NU_17_23DG_4) and (not CD_D17)  # route D17-D7 stays set
        PR_R12 = A_R12 and B_R12 and W_R12 and CO_R12 and KP_R12 and (not X_D17) and (not CAN_D17) and (S_R12 or RL_D17)  # proceed for route D17-D7 (R3, R11)
        LS_R12 = S_R12 and (not CO_R12)  # route D17-D7: a condition was lost; no reopening by itself (R14)
        KP_R13 = (not NU_17_23DG_4) and (not CD_D17)  # route D17-IAG stays set
        PR_R13 = A_R13 and B_R13 and W_R13 and CO_R13 and KP_R13 and (not X_D17) and (not CAN_D17) and (S_R13 or RL_D17)  # proceed for route D17-IAG (R3, R11)
        LS_R13 = S_R13 and (not CO_R13)  # route D17-IAG: a condition was lost; no reopening by itself (R14)
        KP_R14 = (not NU_5DG_3) and (not CD_D3)  # route D3-D11 stays set
        PR_R14 = A_R14 and B_R14 and W_R14 and CO_R14 and KP_R14 and (not X_D3) and (not CAN_D3) and (S_R14 or RL_D3)  # proceed for route D3-D11 (R3, R11)
        LS_R14 = S_R14 and (not CO_R14)  # route D3-D11: a condition was lost; no reopening by itself (R14)
        KP_R15 = (not NU_5DG_3) and (not CD_D3)  # route D3-D9 stays set
        PR_R15 = A_R15 and B_R15 and W_R15 and CO_R15 and KP_R15 and (not X_D3) and (not CAN_D3) and (S_R15 or RL_D3)  # proceed for route D3-D9 (R3, R11)
        LS_R15 = S_R15 and (not CO_R15)  # route D3-D9: a condition was lost; no reopening by itself (R14)
        KP_R16 = (not NU_1DG_1) and (not CD_D5)  # route D5-IIAG stays set
        PR_R16 = A_R16 and B_R16 and W_R16 and CO_R16 and KP_R16 and (not X_D5) and (not CAN_D5) and (S_R16 or RL_D5)  # proceed for route D5-IIAG (R3, R11)
        LS_R16 = S_R16 and (not CO_R16)  # route D5-IIAG: a condition was lost; no reopening by itself (R14)
        KP_R17 = (not NU_3DG_3) and (not CD_D7)  # route D7-IAG stays set
        PR_R17 = A_R17 and B_R17 and W_R17 and CO_R17 and KP_R17 and (not X_D7) and (not CAN_D7) and (S_R17 or RL_D7)  # proceed for route D7-IAG (R3, R11)
        LS_R17 = S_R17 and (not CO_R17)  # route D7-IAG: a condition was lost; no reopening by itself (R14)
        KP_R18 = (not NU_3DG_3) and (not CD_D7)  # route D7-IIAG stays set
        PR_R18 = A_R18 and B_R18 and W_R18 and CO_R18 and KP_R18 and (not X_D7) and (not CAN_D7) and (S_R18 or RL_D7)  # proceed for route D7-IIAG (R3, R11)
        LS_R18 = S_R18 and (not CO_R18)  # route D7-IIAG: a condition was lost; no reopening by itself (R14)
        KP_R19 = (not NU_9_15DG_4) and (not CD_D9)  # route D9-5G stays set
        PR_R19 = A_R19 and B_R19 and W_R19 and CO_R19 and KP_R19 and (not X_D9) and (not CAN_D9) and (S_R19 or RL_D9)  # proceed for route D9-5G (R3, R11)
        LS_R19 = S_R19 and (not CO_R19)  # route D9-5G: a condition was lost; no reopening by itself (R14)
        KP_R20 = (not NU_9_15DG_4) and (not CD_D9)  # route D9-D13 stays set
        PR_R20 = A_R20 and B_R20 and W_R20 and CO_R20 and KP_R20 and (not X_D9) and (not CAN_D9) and (S_R20 or RL_D9)  # proceed for route D9-D13 (R3, R11)
        LS_R20 = S_R20 and (not CO_R20)  # route D9-D13: a condition was lost; no reopening by itself (R14)
        KP_R21 = (not NU_9_15DG_4) and (not CD_D9)  # route D9-IIIG stays set
        PR_R21 = A_R21 and B_R21 and W_R21 and CO_R21 and KP_R21 and (not X_D9) and (not CAN_D9) and (S_R21 or RL_D9)  # proceed for route D9-IIIG (R3, R11)
        LS_R21 = S_R21 and (not CO_R21)  # route D9-IIIG: a condition was lost; no reopening by itself (R14)
        KP_R22 = (not NU_19_27DG_3) and (not CD_S4)  # route S4-BS stays set
        PR_R22 = A_R22 and B_R22 and W_R22 and CO_R22 and KP_R22 and (not X_S4) and (not CAN_S4) and (S_R22 or RL_S4)  # proceed for route S4-BS (R3, R11)
        LS_R22 = S_R22 and (not CO_R22)  # route S4-BS: a condition was lost; no reopening by itself (R14)
        KP_R23 = (not NU_19_27DG_3) and (not CD_S4)  # route S4-BS.2 stays set
        PR_R23 = A_R23 and B_R23 and W_R23 and CO_R23 and KP_R23 and (not X_S4) and (not CAN_S4) and (S_R23 or RL_S4)  # proceed for route S4-BS.2 (R3, R11)
        LS_R23 = S_R23 and (not CO_R23)  # route S4-BS.2: a condition was lost; no reopening by itself (R14)
        KP_R24 = (not NU_19_27DG_3) and (not CD_S4)  # route S4-DJ stays set
        PR_R24 = A_R24 and B_R24 and W_R24 and CO_R24 and KP_R24 and (not X_S4) and (not CAN_S4) and (S_R24 or RL_S4)  # proceed for route S4-DJ (R3, R11)
        LS_R24 = S_R24 and (not CO_R24)  # route S4-DJ: a condition was lost; no reopening by itself (R14)
        KP_R25 = (not NU_19_27DG_3) and (not CD_S4)  # route S4-D5.s stays set
        PR_R25 = A_R25 and B_R25 and W_R25 and CO_R25 and KP_R25 and (not X_S4) and (not CAN_S4) and (S_R25 or RL_S4)  # proceed for route S4-D5.s (R3, R11)
        LS_R25 = S_R25 and (not CO_R25)  # route S4-D5.s: a condition was lost; no reopening by itself (R14)
        KP_R26 = (not NU_19_27DG_3) and (not CD_S4)  # route S4-D7.s stays set
        PR_R26 = A_R26 and B_R26 and W_R26 and CO_R26 and KP_R26 and (not X_S4) and (not CAN_S4) and (S_R26 or RL_S4)  # proceed for route S4-D7.s (R3, R11)
        LS_R26 = S_R26 and (not CO_R26)  # route S4-D7.s: a condition was lost; no reopening by itself (R14)
        KP_R27 = (not NU_19_27DG_3) and (not CD_S4)  # route S4-IAG.s stays set
        PR_R27 = A_R27 and B_R27 and W_R27 and CO_R27 and KP_R27 and (not X_S4) and (not CAN_S4) and (S_R27 or RL_S4)  # proceed for route S4-IAG.s (R3, R11)
        LS_R27 = S_R27 and (not CO_R27)  # route S4-IAG.s: a condition was lost; no reopening by itself (R14)
        KP_R28 = (not NU_21DG_3) and (not CD_S5)  # route S5-BS stays set
        PR_R28 = A_R28 and B_R28 and W_R28 and CO_R28 and KP_R28 and (not X_S5) and (not CAN_S5) and (S_R28 or RL_S5)  # proceed for route S5-BS (R3, R11)
        LS_R28 = S_R28 and (not CO_R28)  # route S5-BS: a condition was lost; no reopening by itself (R14)
        KP_R29 = (not NU_21DG_3) and (not CD_S5)  # route S5-DJ stays set
        PR_R29 = A_R29 and B_R29 and W_R29 and CO_R29 and KP_R29 and (not X_S5) and (not CAN_S5) and (S_R29 or RL_S5)  # proceed for route S5-DJ (R3, R11)
        LS_R29 = S_R29 and (not CO_R29)  # route S5-DJ: a condition was lost; no reopening by itself (R14)
        KP_R30 = (not NU_21DG_3) and (not CD_S5)  # route S5-D7.s stays set
        PR_R30 = A_R30 and B_R30 and W_R30 and CO_R30 and KP_R30 and (not X_S5) and (not CAN_S5) and (S_R30 or RL_S5)  # proceed for route S5-D7.s (R3, R11)
        LS_R30 = S_R30 and (not CO_R30)  # route S5-D7.s: a condition was lost; no reopening by itself (R14)
        KP_R31 = (not NU_21DG_3) and (not CD_S5)  # route S5-IAG.s stays set
        PR_R31 = A_R31 and B_R31 and W_R31 and CO_R31 and KP_R31 and (not X_S5) and (not CAN_S5) and (S_R31 or RL_S5)  # proceed for route S5-IAG.s (R3, R11)
        LS_R31 = S_R31 and (not CO_R31)  # route S5-IAG.s: a condition was lost; no reopening by itself (R14)
        KP_R32 = (not NU_19_27DG_4) and (not CD_SII)  # route SII-BS stays set
        PR_R32 = A_R32 and B_R32 and W_R32 and CO_R32 and KP_R32 and (not X_SII) and (not CAN_SII) and (S_R32 or RL_SII)  # proceed for route SII-BS (R3, R11)
        LS_R32 = S_R32 and (not CO_R32)  # route SII-BS: a condition was lost; no reopening by itself (R14)
        KP_R33 = (not NU_19_27DG_4) and (not CD_SII)  # route SII-BS.2 stays set
        PR_R33 = A_R33 and B_R33 and W_R33 and CO_R33 and KP_R33 and (not X_SII) and (not CAN_SII) and (S_R33 or RL_SII)  # proceed for route SII-BS.2 (R3, R11)
        LS_R33 = S_R33 and (not CO_R33)  # route SII-BS.2: a condition was lost; no reopening by itself (R14)
        KP_R34 = (not NU_19_27DG_4) and (not CD_SII)  # route SII-DJ stays set
        PR_R34 = A_R34 and B_R34 and W_R34 and CO_R34 and KP_R34 and (not X_SII) and (not CAN_SII) and (S_R34 or RL_SII)  # proceed for route SII-DJ (R3, R11)
        LS_R34 = S_R34 and (not CO_R34)  # route SII-DJ: a condition was lost; no reopening by itself (R14)
        KP_R35 = (not NU_19_27DG_4) and (not CD_SII)  # route SII-D5.s stays set
        PR_R35 = A_R35 and B_R35 and W_R35 and CO_R35 and KP_R35 and (not X_SII) and (not CAN_SII) and (S_R35 or RL_SII)  # proceed for route SII-D5.s (R3, R11)
        LS_R35 = S_R35 and (not CO_R35)  # route SII-D5.s: a condition was lost; no reopening by itself (R14)
        KP_R36 = (not NU_19_27DG_4) and (not CD_SII)  # route SII-D7.s stays set
        PR_R36 = A_R36 and B_R36 and W_R36 and CO_R36 and KP_R36 and (not X_SII) and (not CAN_SII) and (S_R36 or RL_SII)  # proceed for route SII-D7.s (R3, R11)
        LS_R36 = S_R36 and (not CO_R36)  # route SII-D7.s: a condition was lost; no reopening by itself (R14)
        KP_R37 = (not NU_19_27DG_4) and (not CD_SII)  # route SII-IAG.s stays set
        PR_R37 = A_R37 and B_R37 and W_R37 and CO_R37 and KP_R37 and (not X_SII) and (not CAN_SII) and (S_R37 or RL_SII)  # proceed for route SII-IAG.s (R3, R11)
        LS_R37 = S_R37 and (not CO_R37)  # route SII-IAG.s: a condition was lost; no reopening by itself (R14)
        KP_R38 = (not NU_25DG_3) and (not CD_SIII)  # route SIII-BS stays set
        PR_R38 = A_R38 and B_R38 and W_R38 and CO_R38 and KP_R38 and (not X_SIII) and (not CAN_SIII) and (S_R38 or RL_SIII)  # proceed for route SIII-BS (R3, R11)
        LS_R38 = S_R38 and (not CO_R38)  # route SIII-BS: a condition was lost; no reopening by itself (R14)
        KP_R39 = (not NU_25DG_3) and (not CD_SIII)  # route SIII-BS.2 stays set
        PR_R39 = A_R39 and B_R39 and W_R39 and CO_R39 and KP_R39 and (not X_SIII) and (not CAN_SIII) and (S_R39 or RL_SIII)  # proceed for route SIII-BS.2 (R3, R11)
        LS_R39 = S_R39 and (not CO_R39)  # route SIII-BS.2: a condition was lost; no reopening by itself (R14)
        KP_R40 = (not NU_25DG_3) and (not CD_SIII)  # route SIII-DJ stays set
        PR_R40 = A_R40 and B_R40 and W_R40 and CO_R40 and KP_R40 and (not X_SIII) and (not CAN_SIII) and (S_R40 or RL_SIII)  # proceed for route SIII-DJ (R3, R11)
        LS_R40 = S_R40 and (not CO_R40)  # route SIII-DJ: a condition was lost; no reopening by itself (R14)
        KP_R41 = (not NU_25DG_3) and (not CD_SIII)  # route SIII-DJ.2 stays set
        PR_R41 = A_R41 and B_R41 and W_R41 and CO_R41 and KP_R41 and (not X_SIII) and (not CAN_SIII) and (S_R41 or RL_SIII)  # proceed for route SIII-DJ.2 (R3, R11)
        LS_R41 = S_R41 and (not CO_R41)  # route SIII-DJ.2: a condition was lost; no reopening by itself (R14)
        KP_R42 = (not NU_25DG_3) and (not CD_SIII)  # route SIII-D7.s stays set
        PR_R42 = A_R42 and B_R42 and W_R42 and CO_R42 and KP_R42 and (not X_SIII) and (not CAN_SIII) and (S_R42 or RL_SIII)  # proceed for route SIII-D7.s (R3, R11)
        LS_R42 = S_R42 and (not CO_R42)  # route SIII-D7.s: a condition was lost; no reopening by itself (R14)
        KP_R43 = (not NU_25DG_3) and (not CD_SIII)  # route SIII-D7.s.2 stays set
        PR_R43 = A_R43 and B_R43 and W_R43 and CO_R43 and KP_R43 and (not X_SIII) and (not CAN_SIII) and (S_R43 or RL_SIII)  # proceed for route SIII-D7.s.2 (R3, R11)
        LS_R43 = S_R43 and (not CO_R43)  # route SIII-D7.s.2: a condition was lost; no reopening by itself (R14)
        KP_R44 = (not NU_25DG_3) and (not CD_SIII)  # route SIII-IAG.s stays set
        PR_R44 = A_R44 and B_R44 and W_R44 and CO_R44 and KP_R44 and (not X_SIII) and (not CAN_SIII) and (S_R44 or RL_SIII)  # proceed for route SIII-IAG.s (R3, R11)
        LS_R44 = S_R44 and (not CO_R44)  # route SIII-IAG.s: a condition was lost; no reopening by itself (R14)
        KP_R45 = (not NU_25DG_3) and (not CD_SIII)  # route SIII-IAG.s.2 stays set
        PR_R45 = A_R45 and B_R45 and W_R45 and CO_R45 and KP_R45 and (not X_SIII) and (not CAN_SIII) and (S_R45 or RL_SIII)  # proceed for route SIII-IAG.s.2 (R3, R11)
        LS_R45 = S_R45 and (not CO_R45)  # route SIII-IAG.s.2: a condition was lost; no reopening by itself (R14)
        KP_R46 = (not NU_IAG_2) and (not CD_X)  # route X-E1 stays set
        PR_R46 = A_R46 and B_R46 and W_R46 and CO_R46 and KP_R46 and (not X_X) and (not CAN_X) and (S_R46 or RL_X)  # proceed for route X-E1 (R3, R11)
        LS_R46 = S_R46 and (not CO_R46)  # route X-E1: a condition was lost; no reopening by itself (R14)
        KP_R47 = (not NU_IAG_2) and (not CD_X)  # route X-E1.2 stays set
        PR_R47 = A_R47 and B_R47 and W_R47 and CO_R47 and KP_R47 and (not X_X) and (not CAN_X) and (S_R47 or RL_X)  # proceed for route X-E1.2 (R3, R11)
        LS_R47 = S_R47 and (not CO_R47)  # route X-E1.2: a condition was lost; no reopening by itself (R14)
        KP_R48 = (not NU_IAG_2) and (not CD_X)  # route X-E3 stays set
        PR_R48 = A_R48 and B_R48 and W_R48 and CO_R48 and KP_R48 and (not X_X) and (not CAN_X) and (S_R48 or RL_X)  # proceed for route X-E3 (R3, R11)
        LS_R48 = S_R48 and (not CO_R48)  # route X-E3: a condition was lost; no reopening by itself (R14)
        KP_R49 = (not NU_IAG_2) and (not CD_X)  # route X-E3.2 stays set
        PR_R49 = A_R49 and B_R49 and W_R49 and CO_R49 and KP_R49 and (not X_X) and (not CAN_X) and (S_R49 or RL_X)  # proceed for route X-E3.2 (R3, R11)
        LS_R49 = S_R49 and (not CO_R49)  # route X-E3.2: a condition was lost; no reopening by itself (R14)
        KP_R50 = (not NU_IAG_2) and (not CD_X)  # route X-E3.3 stays set
        PR_R50 = A_R50 and B_R50 and W_R50 and CO_R50 and KP_R50 and (not X_X) and (not CAN_X) and (S_R50 or RL_X)  # proceed for route X-E3.3 (R3, R11)
        LS_R50 = S_R50 and (not CO_R50)  # route X-E3.3: a condition was lost; no reopening by itself (R14)
        KP_R51 = (not NU_IAG_2) and (not CD_X)  # route X-E3.4 stays set
        PR_R51 = A_R51 and B_R51 and W_R51 and CO_R51 and KP_R51 and (not X_X) and (not CAN_X) and (S_R51 or RL_X)  # proceed for route X-E3.4 (R3, R11)
        LS_R51 = S_R51 and (not CO_R51)  # route X-E3.4: a condition was lost; no reopening by itself (R14)
        KP_R52 = (not NU_IAG_2) and (not CD_X)  # route X-E4 stays set
        PR_R52 = A_R52 and B_R52 and W_R52 and CO_R52 and KP_R52 and (not X_X) and (not CAN_X) and (S_R52 or RL_X)  # proceed for route X-E4 (R3, R11)
        LS_R52 = S_R52 and (not CO_R52)  # route X-E4: a condition was lost; no reopening by itself (R14)
        KP_R53 = (not NU_IAG_2) and (not CD_X)  # route X-E4.2 stays set
        PR_R53 = A_R53 and B_R53 and W_R53 and CO_R53 and KP_R53 and (not X_X) and (not CAN_X) and (S_R53 or RL_X)  # proceed for route X-E4.2 (R3, R11)
        LS_R53 = S_R53 and (not CO_R53)  # route X-E4.2: a condition was lost; no reopening by itself (R14)
        KP_R54 = (not NU_IAG_2) and (not CD_X)  # route X-E5 stays set
        PR_R54 = A_R54 and B_R54 and W_R54 and CO_R54 and KP_R54 and (not X_X) and (not CAN_X) and (S_R54 or RL_X)  # proceed for route X-E5 (R3, R11)
        LS_R54 = S_R54 and (not CO_R54)  # route X-E5: a condition was lost; no reopening by itself (R14)
        KP_R55 = (not NU_IAG_2) and (not CD_X)  # route X-E5.2 stays set
        PR_R55 = A_R55 and B_R55 and W_R55 and CO_R55 and KP_R55 and (not X_X) and (not CAN_X) and (S_R55 or RL_X)  # proceed for route X-E5.2 (R3, R11)
        LS_R55 = S_R55 and (not CO_R55)  # route X-E5.2: a condition was lost; no reopening by itself (R14)
        KP_R56 = (not NU_IAG_2) and (not CD_X)  # route X-E1.c stays set
        PR_R56 = A_R56 and B_R56 and W_R56 and CO_R56 and KP_R56 and (not X_X) and (not CAN_X) and (S_R56 or RL_X)  # proceed for route X-E1.c (R3, R11)
        LS_R56 = S_R56 and (not CO_R56)  # route X-E1.c: a condition was lost; no reopening by itself (R14)
        KP_R57 = (not NU_IAG_2) and (not CD_X)  # route X-E1.c.2 stays set
        PR_R57 = A_R57 and B_R57 and W_R57 and CO_R57 and KP_R57 and (not X_X) and (not CAN_X) and (S_R57 or RL_X)  # proceed for route X-E1.c.2 (R3, R11)
        LS_R57 = S_R57 and (not CO_R57)  # route X-E1.c.2: a condition was lost; no reopening by itself (R14)
        KP_R58 = (not NU_IAG_2) and (not CD_X)  # route X-E3.c stays set
        PR_R58 = A_R58 and B_R58 and W_R58 and CO_R58 and KP_R58 and (not X_X) and (not CAN_X) and (S_R58 or RL_X)  # proceed for route X-E3.c (R3, R11)
        LS_R58 = S_R58 and (not CO_R58)  # route X-E3.c: a condition was lost; no reopening by itself (R14)
        KP_R59 = (not NU_IAG_2) and (not CD_X)  # route X-E3.c.2 stays set
        PR_R59 = A_R59 and B_R59 and W_R59 and CO_R59 and KP_R59 and (not X_X) and (not CAN_X) and (S_R59 or RL_X)  # proceed for route X-E3.c.2 (R3, R11)
        LS_R59 = S_R59 and (not CO_R59)  # route X-E3.c.2: a condition was lost; no reopening by itself (R14)
        KP_R60 = (not NU_IAG_2) and (not CD_X)  # route X-E3.c.3 stays set
        PR_R60 = A_R60 and B_R60 and W_R60 and CO_R60 and KP_R60 and (not X_X) and (not CAN_X) and (S_R60 or RL_X)  # proceed for route X-E3.c.3 (R3, R11)
        LS_R60 = S_R60 and (not CO_R60)  # route X-E3.c.3: a condition was lost; no reopening by itself (R14)
        KP_R61 = (not NU_IAG_2) and (not CD_X)  # route X-E3.c.4 stays set
        PR_R61 = A_R61 and B_R61 and W_R61 and CO_R61 and KP_R61 and (not X_X) and (not CAN_X) and (S_R61 or RL_X)  # proceed for route X-E3.c.4 (R3, R11)
        LS_R61 = S_R61 and (not CO_R61)  # route X-E3.c.4: a condition was lost; no reopening by itself (R14)
        KP_R62 = (not NU_IAG_2) and (not CD_X)  # route X-E4.c stays set
        PR_R62 = A_R62 and B_R62 and W_R62 and CO_R62 and KP_R62 and (not X_X) and (not CAN_X) and (S_R62 or RL_X)  # proceed for route X-E4.c (R3, R11)
        LS_R62 = S_R62 and (not CO_R62)  # route X-E4.c: a condition was lost; no reopening by itself (R14)
        KP_R63 = (not NU_IAG_2) and (not CD_X)  # route X-E4.c.2 stays set
        PR_R63 = A_R63 and B_R63 and W_R63 and CO_R63 and KP_R63 and (not X_X) and (not CAN_X) and (S_R63 or RL_X)  # proceed for route X-E4.c.2 (R3, R11)
        LS_R63 = S_R63 and (not CO_R63)  # route X-E4.c.2: a condition was lost; no reopening by itself (R14)
        KP_R64 = (not NU_IAG_2) and (not CD_X)  # route X-E5.c stays set
        PR_R64 = A_R64 and B_R64 and W_R64 and CO_R64 and KP_R64 and (not X_X) and (not CAN_X) and (S_R64 or RL_X)  # proceed for route X-E5.c (R3, R11)
        LS_R64 = S_R64 and (not CO_R64)  # route X-E5.c: a condition was lost; no reopening by itself (R14)
        KP_R65 = (not NU_IAG_2) and (not CD_X)  # route X-E5.c.2 stays set
        PR_R65 = A_R65 and B_R65 and W_R65 and CO_R65 and KP_R65 and (not X_X) and (not CAN_X) and (S_R65 or RL_X)  # proceed for route X-E5.c.2 (R3, R11)
        LS_R65 = S_R65 and (not CO_R65)  # route X-E5.c.2: a condition was lost; no reopening by itself (R14)
        KP_R66 = (not NU_7DG_3) and (not CD_XD)  # route XD-E1 stays set
        PR_R66 = A_R66 and B_R66 and W_R66 and CO_R66 and KP_R66 and (not X_XD) and (not CAN_XD) and (S_R66 or RL_XD)  # proceed for route XD-E1 (R3, R11)
        LS_R66 = S_R66 and (not CO_R66)  # route XD-E1: a condition was lost; no reopening by itself (R14)
        KP_R67 = (not NU_7DG_3) and (not CD_XD)  # route XD-E3 stays set
        PR_R67 = A_R67 and B_R67 and W_R67 and CO_R67 and KP_R67 and (not X_XD) and (not CAN_XD) and (S_R67 or RL_XD)  # proceed for route XD-E3 (R3, R11)
        LS_R67 = S_R67 and (not CO_R67)  # route XD-E3: a condition was lost; no reopening by itself (R14)
        KP_R68 = (not NU_7DG_3) and (not CD_XD)  # route XD-E3.2 stays set
        PR_R68 = A_R68 and B_R68 and W_R68 and CO_R68 and KP_R68 and (not X_XD) and (not CAN_XD) and (S_R68 or RL_XD)  # proceed for route XD-E3.2 (R3, R11)
        LS_R68 = S_R68 and (not CO_R68)  # route XD-E3.2: a condition was lost; no reopening by itself (R14)
        KP_R69 = (not NU_7DG_3) and (not CD_XD)  # route XD-E4 stays set
        PR_R69 = A_R69 and B_R69 and W_R69 and CO_R69 and KP_R69 and (not X_XD) and (not CAN_XD) and (S_R69 or RL_XD)  # proceed for route XD-E4 (R3, R11)
        LS_R69 = S_R69 and (not CO_R69)  # route XD-E4: a condition was lost; no reopening by itself (R14)
        KP_R70 = (not NU_7DG_3) and (not CD_XD)  # route XD-E5 stays set
        PR_R70 = A_R70 and B_R70 and W_R70 and CO_R70 and KP_R70 and (not X_XD) and (not CAN_XD) and (S_R70 or RL_XD)  # proceed for route XD-E5 (R3, R11)
        LS_R70 = S_R70 and (not CO_R70)  # route XD-E5: a condition was lost; no reopening by itself (R14)
        KP_R71 = (not NU_7DG_3) and (not CD_XD)  # route XD-E1.c stays set
        PR_R71 = A_R71 and B_R71 and W_R71 and CO_R71 and KP_R71 and (not X_XD) and (not CAN_XD) and (S_R71 or RL_XD)  # proceed for route XD-E1.c (R3, R11)
        LS_R71 = S_R71 and (not CO_R71)  # route XD-E1.c: a condition was lost; no reopening by itself (R14)
        KP_R72 = (not NU_7DG_3) and (not CD_XD)  # route XD-E3.c stays set
        PR_R72 = A_R72 and B_R72 and W_R72 and CO_R72 and KP_R72 and (not X_XD) and (not CAN_XD) and (S_R72 or RL_XD)  # proceed for route XD-E3.c (R3, R11)
        LS_R72 = S_R72 and (not CO_R72)  # route XD-E3.c: a condition was lost; no reopening by itself (R14)
        KP_R73 = (not NU_7DG_3) and (not CD_XD)  # route XD-E3.c.2 stays set
        PR_R73 = A_R73 and B_R73 and W_R73 and CO_R73 and KP_R73 and (not X_XD) and (not CAN_XD) and (S_R73 or RL_XD)  # proceed for route XD-E3.c.2 (R3, R11)
        LS_R73 = S_R73 and (not CO_R73)  # route XD-E3.c.2: a condition was lost; no reopening by itself (R14)
        KP_R74 = (not NU_7DG_3) and (not CD_XD)  # route XD-E4.c stays set
        PR_R74 = A_R74 and B_R74 and W_R74 and CO_R74 and KP_R74 and (not X_XD) and (not CAN_XD) and (S_R74 or RL_XD)  # proceed for route XD-E4.c (R3, R11)
        LS_R74 = S_R74 and (not CO_R74)  # route XD-E4.c: a condition was lost; no reopening by itself (R14)
        KP_R75 = (not NU_7DG_3) and (not CD_XD)  # route XD-E5.c stays set
        PR_R75 = A_R75 and B_R75 and W_R75 and CO_R75 and KP_R75 and (not X_XD) and (not CAN_XD) and (S_R75 or RL_XD)  # proceed for route XD-E5.c (R3, R11)
        LS_R75 = S_R75 and (not CO_R75)  # route XD-E5.c: a condition was lost; no reopening by itself (R14)
        N_CN_1_3 = GPN_1_3 or MAN_1_3 or HDN_1_3  # machine 1/3 commanded N
        N_CR_1_3 = GPR_1_3 or MAR_1_3 or HDR_1_3  # machine 1/3 commanded R
        N_CN_13_15 = GPN_13_15 or MAN_13_15 or HDN_13_15  # machine 13/15 commanded N
        N_CR_13_15 = GPR_13_15 or MAR_13_15 or HDR_13_15  # machine 13/15 commanded R
        N_CN_17_19 = GPN_17_19 or MAN_17_19 or HDN_17_19  # machine 17/19 commanded N
        N_CR_17_19 = GPR_17_19 or MAR_17_19 or HDR_17_19  # machine 17/19 commanded R
        N_CN_21 = GPN_21 or MAN_21 or HDN_21  # machine 21 commanded N
        N_CR_21 = GPR_21 or MAR_21 or HDR_21  # machine 21 commanded R
        N_CN_23_25 = GPN_23_25 or MAN_23_25 or HDN_23_25  # machine 23/25 commanded N
        N_CR_23_25 = GPR_23_25 or MAR_23_25 or HDR_23_25  # machine 23/25 commanded R
        N_CN_27 = GPN_27 or MAN_27 or HDN_27  # machine 27 commanded N
        N_CR_27 = GPR_27 or MAR_27 or HDR_27  # machine 27 commanded R
        N_CN_5_7 = GPN_5_7 or MAN_5_7 or HDN_5_7  # machine 5/7 commanded N
        N_CR_5_7 = GPR_5_7 or MAR_5_7 or HDR_5_7  # machine 5/7 commanded R
        N_CN_9_11 = GPN_9_11 or MAN_9_11 or HDN_9_11  # machine 9/11 commanded N
        N_CR_9_11 = GPR_9_11 or MAR_9_11 or HDR_9_11  # machine 9/11 commanded R
        N_AL_1_3 = ST_1_3  # alarm: machine 1/3 not detected
        N_AL_13_15 = ST_13_15  # alarm: machine 13/15 not detected
        N_AL_17_19 = ST_17_19  # alarm: machine 17/19 not detected
        N_AL_21 = ST_21  # alarm: machine 21 not detected
        N_AL_23_25 = ST_23_25  # alarm: machine 23/25 not detected
        N_AL_27 = ST_27  # alarm: machine 27 not detected
        N_AL_5_7 = ST_5_7  # alarm: machine 5/7 not detected
        N_AL_9_11 = ST_9_11  # alarm: machine 9/11 not detected
        N_TH_1_3 = ((CN_1_3 and QN_1_3) or (CR_1_3 and QR_1_3)) and (not (GPN_1_3 or GPR_1_3 or MAN_1_3 or MAR_1_3))  # machine 1/3 was detected where it is commanded
        N_TR_1_3 = (TH_1_3 and VALID and ((CN_1_3 and (not QN_1_3) and (not GPR_1_3) and (not MAR_1_3)) or (CR_1_3 and (not QR_1_3) and (not GPN_1_3) and (not MAN_1_3)))) or (TR_1_3 and (not (TC_1_3 and VALID and (not OCC_1DG) and (not OCC_3DG))))  # machine 1/3 was trailed
        N_TH_13_15 = ((CN_13_15 and QN_13_15) or (CR_13_15 and QR_13_15)) and (not (GPN_13_15 or GPR_13_15 or MAN_13_15 or MAR_13_15))  # machine 13/15 was detected where it is commanded
        N_TR_13_15 = (TH_13_15 and VALID and ((CN_13_15 and (not QN_13_15) and (not GPR_13_15) and (not MAR_13_15)) or (CR_13_15 and (not QR_13_15) and (not GPN_13_15) and (not MAN_13_15)))) or (TR_13_15 and (not (TC_13_15 and VALID and (not OCC_11_13DG) and (not OCC_9_15DG))))  # machine 13/15 was trailed
        N_TH_17_19 = ((CN_17_19 and QN_17_19) or (CR_17_19 and QR_17_19)) and (not (GPN_17_19 or GPR_17_19 or MAN_17_19 or MAR_17_19))  # machine 17/19 was detected where it is commanded
        N_TR_17_19 = (TH_17_19 and VALID and ((CN_17_19 and (not QN_17_19) and (not GPR_17_19) and (not MAR_17_19)) or (CR_17_19 and (not QR_17_19) and (not GPN_17_19) and (not MAN_17_19)))) or (TR_17_19 and (not (TC_17_19 and VALID and (not OCC_17_23DG) and (not OCC_19_27DG))))  # machine 17/19 was trailed
        N_TH_21 = ((CN_21 and QN_21) or (CR_21 and QR_21)) and (not (GPN_21 or GPR_21 or MAN_21 or MAR_21))  # machine 21 was detected where it is commanded
        N_TR_21 = (TH_21 and VALID and ((CN_21 and (not QN_21) and (not GPR_21) and (not MAR_21)) or (CR_21 and (not QR_21) and (not GPN_21) and (not MAN_21)))) or (TR_21 and (not (TC_21 and VALID and (not OCC_21DG))))  # machine 21 was trailed
        N_TH_23_25 = ((CN_23_25 and QN_23_25) or (CR_23_25 and QR_23_25)) and (not (GPN_23_25 or GPR_23_25 or MAN_23_25 or MAR_23_25))  # machine 23/25 was detected where it is commanded
        N_TR_23_25 = (TH_23_25 and VALID and ((CN_23_25 and (not QN_23_25) and (not GPR_23_25) and (not MAR_23_25)) or (CR_23_25 and (not QR_23_25) and (not GPN_23_25) and (not MAN_23_25)))) or (TR_23_25 and (not (TC_23_25 and VALID and (not OCC_17_23DG) and (not OCC_25DG))))  # machine 23/25 was trailed
        N_TH_27 = ((CN_27 and QN_27) or (CR_27 and QR_27)) and (not (GPN_27 or GPR_27 or MAN_27 or MAR_27))  # machine 27 was detected where it is commanded
        N_TR_27 = (TH_27 and VALID and ((CN_27 and (not QN_27) and (not GPR_27) and (not MAR_27)) or (CR_27 and (not QR_27) and (not GPN_27) and (not MAN_27)))) or (TR_27 and (not (TC_27 and VALID and (not OCC_19_27DG))))  # machine 27 was trailed
        N_TH_5_7 = ((CN_5_7 and QN_5_7) or (CR_5_7 and QR_5_7)) and (not (GPN_5_7 or GPR_5_7 or MAN_5_7 or MAR_5_7))  # machine 5/7 was detected where it is commanded
        N_TR_5_7 = (TH_5_7 and VALID and ((CN_5_7 and (not QN_5_7) and (not GPR_5_7) and (not MAR_5_7)) or (CR_5_7 and (not QR_5_7) and (not GPN_5_7) and (not MAN_5_7)))) or (TR_5_7 and (not (TC_5_7 and VALID and (not OCC_5DG) and (not OCC_7DG))))  # machine 5/7 was trailed
        N_TH_9_11 = ((CN_9_11 and QN_9_11) or (CR_9_11 and QR_9_11)) and (not (GPN_9_11 or GPR_9_11 or MAN_9_11 or MAR_9_11))  # machine 9/11 was detected where it is commanded
        N_TR_9_11 = (TH_9_11 and VALID and ((CN_9_11 and (not QN_9_11) and (not GPR_9_11) and (not MAR_9_11)) or (CR_9_11 and (not QR_9_11) and (not GPN_9_11) and (not MAN_9_11)))) or (TR_9_11 and (not (TC_9_11 and VALID and (not OCC_11_13DG) and (not OCC_9_15DG))))  # machine 9/11 was trailed
        N_Z_1_3 = (Z_1_3 or ZT_1_3) and STI_1_3 and (not (GPN_1_3 or GPR_1_3 or MAN_1_3 or MAR_1_3))  # machine 1/3 may run
        N_Z_13_15 = (Z_13_15 or ZT_13_15) and STI_13_15 and (not (GPN_13_15 or GPR_13_15 or MAN_13_15 or MAR_13_15))  # machine 13/15 may run
        N_Z_17_19 = (Z_17_19 or ZT_17_19) and STI_17_19 and (not (GPN_17_19 or GPR_17_19 or MAN_17_19 or MAR_17_19))  # machine 17/19 may run
        N_Z_21 = (Z_21 or ZT_21) and STI_21 and (not (GPN_21 or GPR_21 or MAN_21 or MAR_21))  # machine 21 may run
        N_Z_23_25 = (Z_23_25 or ZT_23_25) and STI_23_25 and (not (GPN_23_25 or GPR_23_25 or MAN_23_25 or MAR_23_25))  # machine 23/25 may run
        N_Z_27 = (Z_27 or ZT_27) and STI_27 and (not (GPN_27 or GPR_27 or MAN_27 or MAR_27))  # machine 27 may run
        N_Z_5_7 = (Z_5_7 or ZT_5_7) and STI_5_7 and (not (GPN_5_7 or GPR_5_7 or MAN_5_7 or MAR_5_7))  # machine 5/7 may run
        N_Z_9_11 = (Z_9_11 or ZT_9_11) and STI_9_11 and (not (GPN_9_11 or GPR_9_11 or MAN_9_11 or MAR_9_11))  # machine 9/11 may run
        N_SG = (ZT_1_3 or ZT_13_15 or ZT_17_19 or ZT_21 or ZT_23_25 or ZT_27 or ZT_5_7 or ZT_9_11)  # a machine started in the last scan
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route D1-D15 active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route D1-D15 locked
        N_W_R1 = (W_R1 or LK_R1 or ((REQ == 1) and B_R1)) and (not LS_R1) and KP_R1 and (not X_D1) and (not CAN_D1)  # route D1-D15: proceed wanted
        N_S_R1 = PR_R1  # route D1-D15: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route D1-D15: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route D1-D9 active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route D1-D9 locked
        N_W_R2 = (W_R2 or LK_R2 or ((REQ == 2) and B_R2)) and (not LS_R2) and KP_R2 and (not X_D1) and (not CAN_D1)  # route D1-D9: proceed wanted
        N_S_R2 = PR_R2  # route D1-D9: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route D1-D9: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route D11-5G active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route D11-5G locked
        N_W_R3 = (W_R3 or LK_R3 or ((REQ == 3) and B_R3)) and (not LS_R3) and KP_R3 and (not X_D11) and (not CAN_D11)  # route D11-5G: proceed wanted
        N_PA_R3 = (PA_R3 or (S_R3 and NU_11_13DG_2)) and VALID and (not CAN_D11) and OCC_7DG and OCC_11_13DG and WD_11_13DG_3 and (not BLK_11_13DG) and WD_21DG_2 and (not BLK_21DG) and (not BLK_5G) and (not D_11_13DG)  # route D11-5G: open for the movement that passes D11
        N_S_R3 = PR_R3  # route D11-5G: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route D11-5G: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route D11-D13 active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route D11-D13 locked
        N_W_R4 = (W_R4 or LK_R4 or ((REQ == 4) and B_R4)) and (not LS_R4) and KP_R4 and (not X_D11) and (not CAN_D11)  # route D11-D13: proceed wanted
        N_PA_R4 = (PA_R4 or (S_R4 and NU_11_13DG_2)) and VALID and (not CAN_D11) and OCC_7DG and OCC_11_13DG and WD_11_13DG_4 and (not BLK_11_13DG) and WD_9_15DG_2 and (not BLK_9_15DG) and (not D_11_13DG)  # route D11-D13: open for the movement that passes D11
        N_S_R4 = PR_R4  # route D11-D13: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route D11-D13: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route D11-IIIG active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route D11-IIIG locked
        N_W_R5 = (W_R5 or LK_R5 or ((REQ == 5) and B_R5)) and (not LS_R5) and KP_R5 and (not X_D11) and (not CAN_D11)  # route D11-IIIG: proceed wanted
        N_PA_R5 = (PA_R5 or (S_R5 and NU_11_13DG_2)) and VALID and (not CAN_D11) and OCC_7DG and OCC_11_13DG and WD_11_13DG_3 and (not BLK_11_13DG) and WD_21DG_1 and (not BLK_21DG) and WD_25DG_2 and (not BLK_25DG) and (not BLK_IIIG) and (not D_11_13DG)  # route D11-IIIG: open for the movement that passes D11
        N_S_R5 = PR_R5  # route D11-IIIG: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route D11-IIIG: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route D13-4G active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route D13-4G locked
        N_W_R6 = (W_R6 or LK_R6 or ((REQ == 6) and B_R6)) and (not LS_R6) and KP_R6 and (not X_D13) and (not CAN_D13)  # route D13-4G: proceed wanted
        N_PA_R6 = (PA_R6 or (S_R6 and NU_17_23DG_3)) and VALID and (not CAN_D13) and OCC_9_15DG and OCC_17_23DG and WD_17_23DG_3 and (not BLK_17_23DG) and WD_19_27DG_3 and (not BLK_19_27DG) and (not BLK_4G) and (not D_17_23DG)  # route D13-4G: open for the movement that passes D13
        N_S_R6 = PR_R6  # route D13-4G: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route D13-4G: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route D13-IG active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route D13-IG locked
        N_W_R7 = (W_R7 or LK_R7 or ((REQ == 7) and B_R7)) and (not LS_R7) and KP_R7 and (not X_D13) and (not CAN_D13)  # route D13-IG: proceed wanted
        N_PA_R7 = (PA_R7 or (S_R7 and NU_17_23DG_3)) and VALID and (not CAN_D13) and OCC_9_15DG and OCC_17_23DG and WD_17_23DG_5 and (not BLK_17_23DG) and (not BLK_IG) and (not D_17_23DG)  # route D13-IG: open for the movement that passes D13
        N_S_R7 = PR_R7  # route D13-IG: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route D13-IG: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route D13-IIG active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route D13-IIG locked
        N_W_R8 = (W_R8 or LK_R8 or ((REQ == 8) and B_R8)) and (not LS_R8) and KP_R8 and (not X_D13) and (not CAN_D13)  # route D13-IIG: proceed wanted
        N_PA_R8 = (PA_R8 or (S_R8 and NU_17_23DG_3)) and VALID and (not CAN_D13) and OCC_9_15DG and OCC_17_23DG and WD_17_23DG_3 and (not BLK_17_23DG) and WD_19_27DG_4 and (not BLK_19_27DG) and (not BLK_IIG) and (not D_17_23DG)  # route D13-IIG: open for the movement that passes D13
        N_S_R8 = PR_R8  # route D13-IIG: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route D13-IIG: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route D13-IIIG active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route D13-IIIG locked
        N_W_R9 = (W_R9 or LK_R9 or ((REQ == 9) and B_R9)) and (not LS_R9) and KP_R9 and (not X_D13) and (not CAN_D13)  # route D13-IIIG: proceed wanted
        N_PA_R9 = (PA_R9 or (S_R9 and NU_17_23DG_3)) and VALID and (not CAN_D13) and OCC_9_15DG and OCC_17_23DG and WD_17_23DG_4 and (not BLK_17_23DG) and WD_25DG_1 and (not BLK_25DG) and (not BLK_IIIG) and (not D_17_23DG)  # route D13-IIIG: open for the movement that passes D13
        N_S_R9 = PR_R9  # route D13-IIIG: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route D13-IIIG: signal has been open
        N_A_R10 = (A_R10 or G_R10) and KP_R10  # route D15-4G active
        N_B_R10 = (B_R10 or LK_R10) and KP_R10  # route D15-4G locked
        N_W_R10 = (W_R10 or LK_R10 or ((REQ == 10) and B_R10)) and (not LS_R10) and KP_R10 and (not X_D15) and (not CAN_D15)  # route D15-4G: proceed wanted
        N_S_R10 = PR_R10  # route D15-4G: proceed
        N_H_R10 = (H_R10 or PR_R10) and KP_R10  # route D15-4G: signal has been open
        N_A_R11 = (A_R11 or G_R11) and KP_R11  # route D15-IIG active
        N_B_R11 = (B_R11 or LK_R11) and KP_R11  # route D15-IIG locked
        N_W_R11 = (W_R11 or LK_R11 or ((REQ == 11) and B_R11)) and (not LS_R11) and KP_R11 and (not X_D15) and (not CAN_D15)  # route D15-IIG: proceed wanted
        N_S_R11 = PR_R11  # route D15-IIG: proceed
        N_H_R11 = (H_R11 or PR_R11) and KP_R11  # route D15-IIG: signal has been open
        N_A_R12 = (A_R12 or G_R12) and KP_R12  # route D17-D7 active
        N_B_R12 = (B_R12 or LK_R12) and KP_R12  # route D17-D7 locked
        N_W_R12 = (W_R12 or LK_R12 or ((REQ == 12) and B_R12)) and (not LS_R12) and KP_R12 and (not X_D17) and (not CAN_D17)  # route D17-D7: proceed wanted
        N_S_R12 = PR_R12  # route D17-D7: proceed
        N_H_R12 = (H_R12 or PR_R12) and KP_R12  # route D17-D7: signal has been open
        N_A_R13 = (A_R13 or G_R13) and KP_R13  # route D17-IAG active
        N_B_R13 = (B_R13 or LK_R13) and KP_R13  # route D17-IAG locked
        N_W_R13 = (W_R13 or LK_R13 or ((REQ == 13) and B_R13)) and (not LS_R13) and KP_R13 and (not X_D17) and (not CAN_D17)  # route D17-IAG: proceed wanted
        N_S_R13 = PR_R13  # route D17-IAG: proceed
        N_H_R13 = (H_R13 or PR_R13) and KP_R13  # route D17-IAG: signal has been open
        N_A_R14 = (A_R14 or G_R14) and KP_R14  # route D3-D11 active
        N_B_R14 = (B_R14 or LK_R14) and KP_R14  # route D3-D11 locked
        N_W_R14 = (W_R14 or LK_R14 or ((REQ == 14) and B_R14)) and (not LS_R14) and KP_R14 and (not X_D3) and (not CAN_D3)  # route D3-D11: proceed wanted
        N_S_R14 = PR_R14  # route D3-D11: proceed
        N_H_R14 = (H_R14 or PR_R14) and KP_R14  # route D3-D11: signal has been open
        N_A_R15 = (A_R15 or G_R15) and KP_R15  # route D3-D9 active
        N_B_R15 = (B_R15 or LK_R15) and KP_R15  # route D3-D9 locked
        N_W_R15 = (W_R15 or LK_R15 or ((REQ == 15) and B_R15)) and (not LS_R15) and KP_R15 and (not X_D3) and (not CAN_D3)  # route D3-D9: proceed wanted
        N_S_R15 = PR_R15  # route D3-D9: proceed
        N_H_R15 = (H_R15 or PR_R15) and KP_R15  # route D3-D9: signal has been open
        N_A_R16 = (A_R16 or G_R16) and KP_R16  # route D5-IIAG active
        N_B_R16 = (B_R16 or LK_R16) and KP_R16  # route D5-IIAG locked
        N_W_R16 = (W_R16 or LK_R16 or ((REQ == 16) and B_R16)) and (not LS_R16) and KP_R16 and (not X_D5) and (not CAN_D5)  # route D5-IIAG: proceed wanted
        N_S_R16 = PR_R16  # route D5-IIAG: proceed
        N_H_R16 = (H_R16 or PR_R16) and KP_R16  # route D5-IIAG: signal has been open
        N_A_R17 = (A_R17 or G_R17) and KP_R17  # route D7-IAG active
        N_B_R17 = (B_R17 or LK_R17) and KP_R17  # route D7-IAG locked
        N_W_R17 = (W_R17 or LK_R17 or ((REQ == 17) and B_R17)) and (not LS_R17) and KP_R17 and (not X_D7) and (not CAN_D7)  # route D7-IAG: proceed wanted
        N_PA_R17 = (PA_R17 or (S_R17 and NU_3DG_3)) and VALID and (not CAN_D7) and OCC_9_15DG and OCC_3DG and WD_3DG_4 and (not BLK_3DG) and WD_5DG_1 and (not BLK_5DG) and (not BLK_IAG) and (not D_3DG)  # route D7-IAG: open for the movement that passes D7
        N_S_R17 = PR_R17  # route D7-IAG: proceed
        N_H_R17 = (H_R17 or PR_R17) and KP_R17  # route D7-IAG: signal has been open
        N_A_R18 = (A_R18 or G_R18) and KP_R18  # route D7-IIAG active
        N_B_R18 = (B_R18 or LK_R18) and KP_R18  # route D7-IIAG locked
        N_W_R18 = (W_R18 or LK_R18 or ((REQ == 18) and B_R18)) and (not LS_R18) and KP_R18 and (not X_D7) and (not CAN_D7)  # route D7-IIAG: proceed wanted
        N_PA_R18 = (PA_R18 or (S_R18 and NU_3DG_3)) and VALID and (not CAN_D7) and OCC_9_15DG and OCC_3DG and WD_3DG_3 and (not BLK_3DG) and WD_1DG_2 and (not BLK_1DG) and (not BLK_IIAG) and (not D_3DG)  # route D7-IIAG: open for the movement that passes D7
        N_S_R18 = PR_R18  # route D7-IIAG: proceed
        N_H_R18 = (H_R18 or PR_R18) and KP_R18  # route D7-IIAG: signal has been open
        N_A_R19 = (A_R19 or G_R19) and KP_R19  # route D9-5G active
        N_B_R19 = (B_R19 or LK_R19) and KP_R19  # route D9-5G locked
        N_W_R19 = (W_R19 or LK_R19 or ((REQ == 19) and B_R19)) and (not LS_R19) and KP_R19 and (not X_D9) and (not CAN_D9)  # route D9-5G: proceed wanted
        N_PA_R19 = (PA_R19 or (S_R19 and NU_9_15DG_4)) and VALID and (not CAN_D9) and OCC_3DG and OCC_9_15DG and WD_9_15DG_5 and (not BLK_9_15DG) and WD_11_13DG_5 and (not BLK_11_13DG) and WD_21DG_2 and (not BLK_21DG) and (not BLK_5G) and (not D_9_15DG)  # route D9-5G: open for the movement that passes D9
        N_S_R19 = PR_R19  # route D9-5G: proceed
        N_H_R19 = (H_R19 or PR_R19) and KP_R19  # route D9-5G: signal has been open
        N_A_R20 = (A_R20 or G_R20) and KP_R20  # route D9-D13 active
        N_B_R20 = (B_R20 or LK_R20) and KP_R20  # route D9-D13 locked
        N_W_R20 = (W_R20 or LK_R20 or ((REQ == 20) and B_R20)) and (not LS_R20) and KP_R20 and (not X_D9) and (not CAN_D9)  # route D9-D13: proceed wanted
        N_PA_R20 = (PA_R20 or (S_R20 and NU_9_15DG_4)) and VALID and (not CAN_D9) and OCC_3DG and OCC_9_15DG and WD_9_15DG_6 and (not BLK_9_15DG) and (not D_9_15DG)  # route D9-D13: open for the movement that passes D9
        N_S_R20 = PR_R20  # route D9-D13: proceed
        N_H_R20 = (H_R20 or PR_R20) and KP_R20  # route D9-D13: signal has been open
        N_A_R21 = (A_R21 or G_R21) and KP_R21  # route D9-IIIG active
        N_B_R21 = (B_R21 or LK_R21) and KP_R21  # route D9-IIIG locked
        N_W_R21 = (W_R21 or LK_R21 or ((REQ == 21) and B_R21)) and (not LS_R21) and KP_R21 and (not X_D9) and (not CAN_D9)  # route D9-IIIG: proceed wanted
        N_PA_R21 = (PA_R21 or (S_R21 and NU_9_15DG_4)) and VALID and (not CAN_D9) and OCC_3DG and OCC_9_15DG and WD_9_15DG_5 and (not BLK_9_15DG) and WD_11_13DG_5 and (not BLK_11_13DG) and WD_21DG_1 and (not BLK_21DG) and WD_25DG_2 and (not BLK_25DG) and (not BLK_IIIG) and (not D_9_15DG)  # route D9-IIIG: open for the movement that passes D9
        N_S_R21 = PR_R21  # route D9-IIIG: proceed
        N_H_R21 = (H_R21 or PR_R21) and KP_R21  # route D9-IIIG: signal has been open
        N_A_R22 = (A_R22 or G_R22) and KP_R22  # route S4-BS active
        N_B_R22 = (B_R22 or LK_R22) and KP_R22  # route S4-BS locked
        N_W_R22 = (W_R22 or LK_R22 or ((REQ == 22) and B_R22)) and (not LS_R22) and KP_R22 and (not X_S4) and (not CAN_S4)  # route S4-BS: proceed wanted
        N_S_R22 = PR_R22  # route S4-BS: proceed
        N_H_R22 = (H_R22 or PR_R22) and KP_R22  # route S4-BS: signal has been open
        N_A_R23 = (A_R23 or G_R23) and KP_R23  # route S4-BS.2 active
        N_B_R23 = (B_R23 or LK_R23) and KP_R23  # route S4-BS.2 locked
        N_W_R23 = (W_R23 or LK_R23 or ((REQ == 23) and B_R23)) and (not LS_R23) and KP_R23 and (not X_S4) and (not CAN_S4)  # route S4-BS.2: proceed wanted
        N_S_R23 = PR_R23  # route S4-BS.2: proceed
        N_H_R23 = (H_R23 or PR_R23) and KP_R23  # route S4-BS.2: signal has been open
        N_A_R24 = (A_R24 or G_R24) and KP_R24  # route S4-DJ active
        N_B_R24 = (B_R24 or LK_R24) and KP_R24  # route S4-DJ locked
        N_W_R24 = (W_R24 or LK_R24 or ((REQ == 24) and B_R24)) and (not LS_R24) and KP_R24 and (not X_S4) and (not CAN_S4)  # route S4-DJ: proceed wanted
        N_S_R24 = PR_R24  # route S4-DJ: proceed
        N_H_R24 = (H_R24 or PR_R24) and KP_R24  # route S4-DJ: signal has been open
        N_A_R25 = (A_R25 or G_R25) and KP_R25  # route S4-D5.s active
        N_B_R25 = (B_R25 or LK_R25) and KP_R25  # route S4-D5.s locked
        N_W_R25 = (W_R25 or LK_R25 or ((REQ == 25) and B_R25)) and (not LS_R25) and KP_R25 and (not X_S4) and (not CAN_S4)  # route S4-D5.s: proceed wanted
        N_S_R25 = PR_R25  # route S4-D5.s: proceed
        N_H_R25 = (H_R25 or PR_R25) and KP_R25  # route S4-D5.s: signal has been open
        N_A_R26 = (A_R26 or G_R26) and KP_R26  # route S4-D7.s active
        N_B_R26 = (B_R26 or LK_R26) and KP_R26  # route S4-D7.s locked
        N_W_R26 = (W_R26 or LK_R26 or ((REQ == 26) and B_R26)) and (not LS_R26) and KP_R26 and (not X_S4) and (not CAN_S4)  # route S4-D7.s: proceed wanted
        N_S_R26 = PR_R26  # route S4-D7.s: proceed
        N_H_R26 = (H_R26 or PR_R26) and KP_R26  # route S4-D7.s: signal has been open
        N_A_R27 = (A_R27 or G_R27) and KP_R27  # route S4-IAG.s active
        N_B_R27 = (B_R27 or LK_R27) and KP_R27  # route S4-IAG.s locked
        N_W_R27 = (W_R27 or LK_R27 or ((REQ == 27) and B_R27)) and (not LS_R27) and KP_R27 and (not X_S4) and (not CAN_S4)  # route S4-IAG.s: proceed wanted
        N_S_R27 = PR_R27  # route S4-IAG.s: proceed
        N_H_R27 = (H_R27 or PR_R27) and KP_R27  # route S4-IAG.s: signal has been open
        N_A_R28 = (A_R28 or G_R28) and KP_R28  # route S5-BS active
        N_B_R28 = (B_R28 or LK_R28) and KP_R28  # route S5-BS locked
        N_W_R28 = (W_R28 or LK_R28 or ((REQ == 28) and B_R28)) and (not LS_R28) and KP_R28 and (not X_S5) and (not CAN_S5)  # route S5-BS: proceed wanted
        N_S_R28 = PR_R28  # route S5-BS: proceed
        N_H_R28 = (H_R28 or PR_R28) and KP_R28  # route S5-BS: signal has been open
        N_A_R29 = (A_R29 or G_R29) and KP_R29  # route S5-DJ active
        N_B_R29 = (B_R29 or LK_R29) and KP_R29  # route S5-DJ locked
        N_W_R29 = (W_R29 or LK_R29 or ((REQ == 29) and B_R29)) and (not LS_R29) and KP_R29 and (not X_S5) and (not CAN_S5)  # route S5-DJ: proceed wanted
        N_S_R29 = PR_R29  # route S5-DJ: proceed
        N_H_R29 = (H_R29 or PR_R29) and KP_R29  # route S5-DJ: signal has been open
        N_A_R30 = (A_R30 or G_R30) and KP_R30  # route S5-D7.s active
        N_B_R30 = (B_R30 or LK_R30) and KP_R30  # route S5-D7.s locked
        N_W_R30 = (W_R30 or LK_R30 or ((REQ == 30) and B_R30)) and (not LS_R30) and KP_R30 and (not X_S5) and (not CAN_S5)  # route S5-D7.s: proceed wanted
        N_S_R30 = PR_R30  # route S5-D7.s: proceed
        N_H_R30 = (H_R30 or PR_R30) and KP_R30  # route S5-D7.s: signal has been open
        N_A_R31 = (A_R31 or G_R31) and KP_R31  # route S5-IAG.s active
        N_B_R31 = (B_R31 or LK_R31) and KP_R31  # route S5-IAG.s locked
        N_W_R31 = (W_R31 or LK_R31 or ((REQ == 31) and B_R31)) and (not LS_R31) and KP_R31 and (not X_S5) and (not CAN_S5)  # route S5-IAG.s: proceed wanted
        N_S_R31 = PR_R31  # route S5-IAG.s: proceed
        N_H_R31 = (H_R31 or PR_R31) and KP_R31  # route S5-IAG.s: signal has been open
        N_A_R32 = (A_R32 or G_R32) and KP_R32  # route SII-BS active
        N_B_R32 = (B_R32 or LK_R32) and KP_R32  # route SII-BS locked
        N_W_R32 = (W_R32 or LK_R32 or ((REQ == 32) and B_R32)) and (not LS_R32) and KP_R32 and (not X_SII) and (not CAN_SII)  # route SII-BS: proceed wanted
        N_S_R32 = PR_R32  # route SII-BS: proceed
        N_H_R32 = (H_R32 or PR_R32) and KP_R32  # route SII-BS: signal has been open
        N_A_R33 = (A_R33 or G_R33) and KP_R33  # route SII-BS.2 active
        N_B_R33 = (B_R33 or LK_R33) and KP_R33  # route SII-BS.2 locked
        N_W_R33 = (W_R33 or LK_R33 or ((REQ == 33) and B_R33)) and (not LS_R33) and KP_R33 and (not X_SII) and (not CAN_SII)  # route SII-BS.2: proceed wanted
        N_S_R33 = PR_R33  # route SII-BS.2: proceed
        N_H_R33 = (H_R33 or PR_R33) and KP_R33  # route SII-BS.2: signal has been open
        N_A_R34 = (A_R34 or G_R34) and KP_R34  # route SII-DJ active
        N_B_R34 = (B_R34 or LK_R34) and KP_R34  # route SII-DJ locked
        N_W_R34 = (W_R34 or LK_R34 or ((REQ == 34) and B_R34)) and (not LS_R34) and KP_R34 and (not X_SII) and (not CAN_SII)  # route SII-DJ: proceed wanted
        N_S_R34 = PR_R34  # route SII-DJ: proceed
        N_H_R34 = (H_R34 or PR_R34) and KP_R34  # route SII-DJ: signal has been open
        N_A_R35 = (A_R35 or G_R35) and KP_R35  # route SII-D5.s active
        N_B_R35 = (B_R35 or LK_R35) and KP_R35  # route SII-D5.s locked
        N_W_R35 = (W_R35 or LK_R35 or ((REQ == 35) and B_R35)) and (not LS_R35) and KP_R35 and (not X_SII) and (not CAN_SII)  # route SII-D5.s: proceed wanted
        N_S_R35 = PR_R35  # route SII-D5.s: proceed
        N_H_R35 = (H_R35 or PR_R35) and KP_R35  # route SII-D5.s: signal has been open
        N_A_R36 = (A_R36 or G_R36) and KP_R36  # route SII-D7.s active
        N_B_R36 = (B_R36 or LK_R36) and KP_R36  # route SII-D7.s locked
        N_W_R36 = (W_R36 or LK_R36 or ((REQ == 36) and B_R36)) and (not LS_R36) and KP_R36 and (not X_SII) and (not CAN_SII)  # route SII-D7.s: proceed wanted
        N_S_R36 = PR_R36  # route SII-D7.s: proceed
        N_H_R36 = (H_R36 or PR_R36) and KP_R36  # route SII-D7.s: signal has been open
        N_A_R37 = (A_R37 or G_R37) and KP_R37  # route SII-IAG.s active
        N_B_R37 = (B_R37 or LK_R37) and KP_R37  # route SII-IAG.s locked
        N_W_R37 = (W_R37 or LK_R37 or ((REQ == 37) and B_R37)) and (not LS_R37) and KP_R37 and (not X_SII) and (not CAN_SII)  # route SII-IAG.s: proceed wanted
        N_S_R37 = PR_R37  # route SII-IAG.s: proceed
        N_H_R37 = (H_R37 or PR_R37) and KP_R37  # route SII-IAG.s: signal has been open
        N_A_R38 = (A_R38 or G_R38) and KP_R38  # route SIII-BS active
        N_B_R38 = (B_R38 or LK_R38) and KP_R38  # route SIII-BS locked
        N_W_R38 = (W_R38 or LK_R38 or ((REQ == 38) and B_R38)) and (not LS_R38) and KP_R38 and (not X_SIII) and (not CAN_SIII)  # route SIII-BS: proceed wanted
        N_S_R38 = PR_R38  # route SIII-BS: proceed
        N_H_R38 = (H_R38 or PR_R38) and KP_R38  # route SIII-BS: signal has been open
        N_A_R39 = (A_R39 or G_R39) and KP_R39  # route SIII-BS.2 active
        N_B_R39 = (B_R39 or LK_R39) and KP_R39  # route SIII-BS.2 locked
        N_W_R39 = (W_R39 or LK_R39 or ((REQ == 39) and B_R39)) and (not LS_R39) and KP_R39 and (not X_SIII) and (not CAN_SIII)  # route SIII-BS.2: proceed wanted
        N_S_R39 = PR_R39  # route SIII-BS.2: proceed
        N_H_R39 = (H_R39 or PR_R39) and KP_R39  # route SIII-BS.2: signal has been open
        N_A_R40 = (A_R40 or G_R40) and KP_R40  # route SIII-DJ active
        N_B_R40 = (B_R40 or LK_R40) and KP_R40  # route SIII-DJ locked
        N_W_R40 = (W_R40 or LK_R40 or ((REQ == 40) and B_R40)) and (not LS_R40) and KP_R40 and (not X_SIII) and (not CAN_SIII)  # route SIII-DJ: proceed wanted
        N_S_R40 = PR_R40  # route SIII-DJ: proceed
        N_H_R40 = (H_R40 or PR_R40) and KP_R40  # route SIII-DJ: signal has been open
        N_A_R41 = (A_R41 or G_R41) and KP_R41  # route SIII-DJ.2 active
        N_B_R41 = (B_R41 or LK_R41) and KP_R41  # route SIII-DJ.2 locked
        N_W_R41 = (W_R41 or LK_R41 or ((REQ == 41) and B_R41)) and (not LS_R41) and KP_R41 and (not X_SIII) and (not CAN_SIII)  # route SIII-DJ.2: proceed wanted
        N_S_R41 = PR_R41  # route SIII-DJ.2: proceed
        N_H_R41 = (H_R41 or PR_R41) and KP_R41  # route SIII-DJ.2: signal has been open
        N_A_R42 = (A_R42 or G_R42) and KP_R42  # route SIII-D7.s active
        N_B_R42 = (B_R42 or LK_R42) and KP_R42  # route SIII-D7.s locked
        N_W_R42 = (W_R42 or LK_R42 or ((REQ == 42) and B_R42)) and (not LS_R42) and KP_R42 and (not X_SIII) and (not CAN_SIII)  # route SIII-D7.s: proceed wanted
        N_S_R42 = PR_R42  # route SIII-D7.s: proceed
        N_H_R42 = (H_R42 or PR_R42) and KP_R42  # route SIII-D7.s: signal has been open
        N_A_R43 = (A_R43 or G_R43) and KP_R43  # route SIII-D7.s.2 active
        N_B_R43 = (B_R43 or LK_R43) and KP_R43  # route SIII-D7.s.2 locked
        N_W_R43 = (W_R43 or LK_R43 or ((REQ == 43) and B_R43)) and (not LS_R43) and KP_R43 and (not X_SIII) and (not CAN_SIII)  # route SIII-D7.s.2: proceed wanted
        N_S_R43 = PR_R43  # route SIII-D7.s.2: proceed
        N_H_R43 = (H_R43 or PR_R43) and KP_R43  # route SIII-D7.s.2: signal has been open
        N_A_R44 = (A_R44 or G_R44) and KP_R44  # route SIII-IAG.s active
        N_B_R44 = (B_R44 or LK_R44) and KP_R44  # route SIII-IAG.s locked
        N_W_R44 = (W_R44 or LK_R44 or ((REQ == 44) and B_R44)) and (not LS_R44) and KP_R44 and (not X_SIII) and (not CAN_SIII)  # route SIII-IAG.s: proceed wanted
        N_S_R44 = PR_R44  # route SIII-IAG.s: proceed
        N_H_R44 = (H_R44 or PR_R44) and KP_R44  # route SIII-IAG.s: signal has been open
        N_A_R45 = (A_R45 or G_R45) and KP_R45  # route SIII-IAG.s.2 active
        N_B_R45 = (B_R45 or LK_R45) and KP_R45  # route SIII-IAG.s.2 locked
        N_W_R45 = (W_R45 or LK_R45 or ((REQ == 45) and B_R45)) and (not LS_R45) and KP_R45 and (not X_SIII) and (not CAN_SIII)  # route SIII-IAG.s.2: proceed wanted
        N_S_R45 = PR_R45  # route SIII-IAG.s.2: proceed
        N_H_R45 = (H_R45 or PR_R45) and KP_R45  # route SIII-IAG.s.2: signal has been open
        N_A_R46 = (A_R46 or G_R46) and KP_R46  # route X-E1 active
        N_B_R46 = (B_R46 or LK_R46) and KP_R46  # route X-E1 locked
        N_W_R46 = (W_R46 or LK_R46 or ((REQ == 46) and B_R46)) and (not LS_R46) and KP_R46 and (not X_X) and (not CAN_X)  # route X-E1: proceed wanted
        N_S_R46 = PR_R46  # route X-E1: proceed
        N_H_R46 = (H_R46 or PR_R46) and KP_R46  # route X-E1: signal has been open
        N_A_R47 = (A_R47 or G_R47) and KP_R47  # route X-E1.2 active
        N_B_R47 = (B_R47 or LK_R47) and KP_R47  # route X-E1.2 locked
        N_W_R47 = (W_R47 or LK_R47 or ((REQ == 47) and B_R47)) and (not LS_R47) and KP_R47 and (not X_X) and (not CAN_X)  # route X-E1.2: proceed wanted
        N_S_R47 = PR_R47  # route X-E1.2: proceed
        N_H_R47 = (H_R47 or PR_R47) and KP_R47  # route X-E1.2: signal has been open
        N_A_R48 = (A_R48 or G_R48) and KP_R48  # route X-E3 active
        N_B_R48 = (B_R48 or LK_R48) and KP_R48  # route X-E3 locked
        N_W_R48 = (W_R48 or LK_R48 or ((REQ == 48) and B_R48)) and (not LS_R48) and KP_R48 and (not X_X) and (not CAN_X)  # route X-E3: proceed wanted
        N_S_R48 = PR_R48  # route X-E3: proceed
        N_H_R48 = (H_R48 or PR_R48) and KP_R48  # route X-E3: signal has been open
        N_A_R49 = (A_R49 or G_R49) and KP_R49  # route X-E3.2 active
        N_B_R49 = (B_R49 or LK_R49) and KP_R49  # route X-E3.2 locked
        N_W_R49 = (W_R49 or LK_R49 or ((REQ == 49) and B_R49)) and (not LS_R49) and KP_R49 and (not X_X) and (not CAN_X)  # route X-E3.2: proceed wanted
        N_S_R49 = PR_R49  # route X-E3.2: proceed
        N_H_R49 = (H_R49 or PR_R49) and KP_R49  # route X-E3.2: signal has been open
        N_A_R50 = (A_R50 or G_R50) and KP_R50  # route X-E3.3 active
        N_B_R50 = (B_R50 or LK_R50) and KP_R50  # route X-E3.3 locked
        N_W_R50 = (W_R50 or LK_R50 or ((REQ == 50) and B_R50)) and (not LS_R50) and KP_R50 and (not X_X) and (not CAN_X)  # route X-E3.3: proceed wanted
        N_S_R50 = PR_R50  # route X-E3.3: proceed
        N_H_R50 = (H_R50 or PR_R50) and KP_R50  # route X-E3.3: signal has been open
        N_A_R51 = (A_R51 or G_R51) and KP_R51  # route X-E3.4 active
        N_B_R51 = (B_R51 or LK_R51) and KP_R51  # route X-E3.4 locked
        N_W_R51 = (W_R51 or LK_R51 or ((REQ == 51) and B_R51)) and (not LS_R51) and KP_R51 and (not X_X) and (not CAN_X)  # route X-E3.4: proceed wanted
        N_S_R51 = PR_R51  # route X-E3.4: proceed
        N_H_R51 = (H_R51 or PR_R51) and KP_R51  # route X-E3.4: signal has been open
        N_A_R52 = (A_R52 or G_R52) and KP_R52  # route X-E4 active
        N_B_R52 = (B_R52 or LK_R52) and KP_R52  # route X-E4 locked
        N_W_R52 = (W_R52 or LK_R52 or ((REQ == 52) and B_R52)) and (not LS_R52) and KP_R52 and (not X_X) and (not CAN_X)  # route X-E4: proceed wanted
        N_S_R52 = PR_R52  # route X-E4: proceed
        N_H_R52 = (H_R52 or PR_R52) and KP_R52  # route X-E4: signal has been open
        N_A_R53 = (A_R53 or G_R53) and KP_R53  # route X-E4.2 active
        N_B_R53 = (B_R53 or LK_R53) and KP_R53  # route X-E4.2 locked
        N_W_R53 = (W_R53 or LK_R53 or ((REQ == 53) and B_R53)) and (not LS_R53) and KP_R53 and (not X_X) and (not CAN_X)  # route X-E4.2: proceed wanted
        N_S_R53 = PR_R53  # route X-E4.2: proceed
        N_H_R53 = (H_R53 or PR_R53) and KP_R53  # route X-E4.2: signal has been open
        N_A_R54 = (A_R54 or G_R54) and KP_R54  # route X-E5 active
        N_B_R54 = (B_R54 or LK_R54) and KP_R54  # route X-E5 locked
        N_W_R54 = (W_R54 or LK_R54 or ((REQ == 54) and B_R54)) and (not LS_R54) and KP_R54 and (not X_X) and (not CAN_X)  # route X-E5: proceed wanted
        N_S_R54 = PR_R54  # route X-E5: proceed
        N_H_R54 = (H_R54 or PR_R54) and KP_R54  # route X-E5: signal has been open
        N_A_R55 = (A_R55 or G_R55) and KP_R55  # route X-E5.2 active
        N_B_R55 = (B_R55 or LK_R55) and KP_R55  # route X-E5.2 locked
        N_W_R55 = (W_R55 or LK_R55 or ((REQ == 55) and B_R55)) and (not LS_R55) and KP_R55 and (not X_X) and (not CAN_X)  # route X-E5.2: proceed wanted
        N_S_R55 = PR_R55  # route X-E5.2: proceed
        N_H_R55 = (H_R55 or PR_R55) and KP_R55  # route X-E5.2: signal has been open
        N_A_R56 = (A_R56 or G_R56) and KP_R56  # route X-E1.c active
        N_B_R56 = (B_R56 or LK_R56) and KP_R56  # route X-E1.c locked
        N_W_R56 = (W_R56 or LK_R56) and (not LS_R56) and KP_R56 and (not X_X) and (not CAN_X)  # route X-E1.c: proceed wanted
        N_S_R56 = PR_R56  # route X-E1.c: proceed
        N_H_R56 = (H_R56 or PR_R56) and KP_R56  # route X-E1.c: signal has been open
        N_A_R57 = (A_R57 or G_R57) and KP_R57  # route X-E1.c.2 active
        N_B_R57 = (B_R57 or LK_R57) and KP_R57  # route X-E1.c.2 locked
        N_W_R57 = (W_R57 or LK_R57) and (not LS_R57) and KP_R57 and (not X_X) and (not CAN_X)  # route X-E1.c.2: proceed wanted
        N_S_R57 = PR_R57  # route X-E1.c.2: proceed
        N_H_R57 = (H_R57 or PR_R57) and KP_R57  # route X-E1.c.2: signal has been open
        N_A_R58 = (A_R58 or G_R58) and KP_R58  # route X-E3.c active
        N_B_R58 = (B_R58 or LK_R58) and KP_R58  # route X-E3.c locked
        N_W_R58 = (W_R58 or LK_R58) and (not LS_R58) and KP_R58 and (not X_X) and (not CAN_X)  # route X-E3.c: proceed wanted
        N_S_R58 = PR_R58  # route X-E3.c: proceed
        N_H_R58 = (H_R58 or PR_R58) and KP_R58  # route X-E3.c: signal has been open
        N_A_R59 = (A_R59 or G_R59) and KP_R59  # route X-E3.c.2 active
        N_B_R59 = (B_R59 or LK_R59) and KP_R59  # route X-E3.c.2 locked
        N_W_R59 = (W_R59 or LK_R59) and (not LS_R59) and KP_R59 and (not X_X) and (not CAN_X)  # route X-E3.c.2: proceed wanted
        N_S_R59 = PR_R59  # route X-E3.c.2: proceed
        N_H_R59 = (H_R59 or PR_R59) and KP_R59  # route X-E3.c.2: signal has been open
        N_A_R60 = (A_R60 or G_R60) and KP_R60  # route X-E3.c.3 active
        N_B_R60 = (B_R60 or LK_R60) and KP_R60  # route X-E3.c.3 locked
        N_W_R60 = (W_R60 or LK_R60) and (not LS_R60) and KP_R60 and (not X_X) and (not CAN_X)  # route X-E3.c.3: proceed wanted
        N_S_R60 = PR_R60  # route X-E3.c.3: proceed
        N_H_R60 = (H_R60 or PR_R60) and KP_R60  # route X-E3.c.3: signal has been open
        N_A_R61 = (A_R61 or G_R61) and KP_R61  # route X-E3.c.4 active
        N_B_R61 = (B_R61 or LK_R61) and KP_R61  # route X-E3.c.4 locked
        N_W_R61 = (W_R61 or LK_R61) and (not LS_R61) and KP_R61 and (not X_X) and (not CAN_X)  # route X-E3.c.4: proceed wanted
        N_S_R61 = PR_R61  # route X-E3.c.4: proceed
        N_H_R61 = (H_R61 or PR_R61) and KP_R61  # route X-E3.c.4: signal has been open
        N_A_R62 = (A_R62 or G_R62) and KP_R62  # route X-E4.c active
        N_B_R62 = (B_R62 or LK_R62) and KP_R62  # route X-E4.c locked
        N_W_R62 = (W_R62 or LK_R62) and (not LS_R62) and KP_R62 and (not X_X) and (not CAN_X)  # route X-E4.c: proceed wanted
        N_S_R62 = PR_R62  # route X-E4.c: proceed
        N_H_R62 = (H_R62 or PR_R62) and KP_R62  # route X-E4.c: signal has been open
        N_A_R63 = (A_R63 or G_R63) and KP_R63  # route X-E4.c.2 active
        N_B_R63 = (B_R63 or LK_R63) and KP_R63  # route X-E4.c.2 locked
        N_W_R63 = (W_R63 or LK_R63) and (not LS_R63) and KP_R63 and (not X_X) and (not CAN_X)  # route X-E4.c.2: proceed wanted
        N_S_R63 = PR_R63  # route X-E4.c.2: proceed
        N_H_R63 = (H_R63 or PR_R63) and KP_R63  # route X-E4.c.2: signal has been open
        N_A_R64 = (A_R64 or G_R64) and KP_R64  # route X-E5.c active
        N_B_R64 = (B_R64 or LK_R64) and KP_R64  # route X-E5.c locked
        N_W_R64 = (W_R64 or LK_R64) and (not LS_R64) and KP_R64 and (not X_X) and (not CAN_X)  # route X-E5.c: proceed wanted
        N_S_R64 = PR_R64  # route X-E5.c: proceed
        N_H_R64 = (H_R64 or PR_R64) and KP_R64  # route X-E5.c: signal has been open
        N_A_R65 = (A_R65 or G_R65) and KP_R65  # route X-E5.c.2 active
        N_B_R65 = (B_R65 or LK_R65) and KP_R65  # route X-E5.c.2 locked
        N_W_R65 = (W_R65 or LK_R65) and (not LS_R65) and KP_R65 and (not X_X) and (not CAN_X)  # route X-E5.c.2: proceed wanted
        N_S_R65 = PR_R65  # route X-E5.c.2: proceed
        N_H_R65 = (H_R65 or PR_R65) and KP_R65  # route X-E5.c.2: signal has been open
        N_A_R66 = (A_R66 or G_R66) and KP_R66  # route XD-E1 active
        N_B_R66 = (B_R66 or LK_R66) and KP_R66  # route XD-E1 locked
        N_W_R66 = (W_R66 or LK_R66 or ((REQ == 66) and B_R66)) and (not LS_R66) and KP_R66 and (not X_XD) and (not CAN_XD)  # route XD-E1: proceed wanted
        N_S_R66 = PR_R66  # route XD-E1: proceed
        N_H_R66 = (H_R66 or PR_R66) and KP_R66  # route XD-E1: signal has been open
        N_A_R67 = (A_R67 or G_R67) and KP_R67  # route XD-E3 active
        N_B_R67 = (B_R67 or LK_R67) and KP_R67  # route XD-E3 locked
        N_W_R67 = (W_R67 or LK_R67 or ((REQ == 67) and B_R67)) and (not LS_R67) and KP_R67 and (not X_XD) and (not CAN_XD)  # route XD-E3: proceed wanted
        N_S_R67 = PR_R67  # route XD-E3: proceed
        N_H_R67 = (H_R67 or PR_R67) and KP_R67  # route XD-E3: signal has been open
        N_A_R68 = (A_R68 or G_R68) and KP_R68  # route XD-E3.2 active
        N_B_R68 = (B_R68 or LK_R68) and KP_R68  # route XD-E3.2 locked
        N_W_R68 = (W_R68 or LK_R68 or ((REQ == 68) and B_R68)) and (not LS_R68) and KP_R68 and (not X_XD) and (not CAN_XD)  # route XD-E3.2: proceed wanted
        N_S_R68 = PR_R68  # route XD-E3.2: proceed
        N_H_R68 = (H_R68 or PR_R68) and KP_R68  # route XD-E3.2: signal has been open
        N_A_R69 = (A_R69 or G_R69) and KP_R69  # route XD-E4 active
        N_B_R69 = (B_R69 or LK_R69) and KP_R69  # route XD-E4 locked
        N_W_R69 = (W_R69 or LK_R69 or ((REQ == 69) and B_R69)) and (not LS_R69) and KP_R69 and (not X_XD) and (not CAN_XD)  # route XD-E4: proceed wanted
        N_S_R69 = PR_R69  # route XD-E4: proceed
        N_H_R69 = (H_R69 or PR_R69) and KP_R69  # route XD-E4: signal has been open
        N_A_R70 = (A_R70 or G_R70) and KP_R70  # route XD-E5 active
        N_B_R70 = (B_R70 or LK_R70) and KP_R70  # route XD-E5 locked
        N_W_R70 = (W_R70 or LK_R70 or ((REQ == 70) and B_R70)) and (not LS_R70) and KP_R70 and (not X_XD) and (not CAN_XD)  # route XD-E5: proceed wanted
        N_S_R70 = PR_R70  # route XD-E5: proceed
        N_H_R70 = (H_R70 or PR_R70) and KP_R70  # route XD-E5: signal has been open
        N_A_R71 = (A_R71 or G_R71) and KP_R71  # route XD-E1.c active
        N_B_R71 = (B_R71 or LK_R71) and KP_R71  # route XD-E1.c locked
        N_W_R71 = (W_R71 or LK_R71) and (not LS_R71) and KP_R71 and (not X_XD) and (not CAN_XD)  # route XD-E1.c: proceed wanted
        N_S_R71 = PR_R71  # route XD-E1.c: proceed
        N_H_R71 = (H_R71 or PR_R71) and KP_R71  # route XD-E1.c: signal has been open
        N_A_R72 = (A_R72 or G_R72) and KP_R72  # route XD-E3.c active
        N_B_R72 = (B_R72 or LK_R72) and KP_R72  # route XD-E3.c locked
        N_W_R72 = (W_R72 or LK_R72) and (not LS_R72) and KP_R72 and (not X_XD) and (not CAN_XD)  # route XD-E3.c: proceed wanted
        N_S_R72 = PR_R72  # route XD-E3.c: proceed
        N_H_R72 = (H_R72 or PR_R72) and KP_R72  # route XD-E3.c: signal has been open
        N_A_R73 = (A_R73 or G_R73) and KP_R73  # route XD-E3.c.2 active
        N_B_R73 = (B_R73 or LK_R73) and KP_R73  # route XD-E3.c.2 locked
        N_W_R73 = (W_R73 or LK_R73) and (not LS_R73) and KP_R73 and (not X_XD) and (not CAN_XD)  # route XD-E3.c.2: proceed wanted
        N_S_R73 = PR_R73  # route XD-E3.c.2: proceed
        N_H_R73 = (H_R73 or PR_R73) and KP_R73  # route XD-E3.c.2: signal has been open
        N_A_R74 = (A_R74 or G_R74) and KP_R74  # route XD-E4.c active
        N_B_R74 = (B_R74 or LK_R74) and KP_R74  # route XD-E4.c locked
        N_W_R74 = (W_R74 or LK_R74) and (not LS_R74) and KP_R74 and (not X_XD) and (not CAN_XD)  # route XD-E4.c: proceed wanted
        N_S_R74 = PR_R74  # route XD-E4.c: proceed
        N_H_R74 = (H_R74 or PR_R74) and KP_R74  # route XD-E4.c: signal has been open
        N_A_R75 = (A_R75 or G_R75) and KP_R75  # route XD-E5.c active
        N_B_R75 = (B_R75 or LK_R75) and KP_R75  # route XD-E5.c locked
        N_W_R75 = (W_R75 or LK_R75) and (not LS_R75) and KP_R75 and (not X_XD) and (not CAN_XD)  # route XD-E5.c: proceed wanted
        N_S_R75 = PR_R75  # route XD-E5.c: proceed
        N_H_R75 = (H_R75 or PR_R75) and KP_R75  # route XD-E5.c: signal has been open
        N_X_D1 = (X_D1 or CAN_D1) and (A_R1 or A_R2) and (not CD_D1)  # D1: cancelling
        N_X_D11 = (X_D11 or CAN_D11) and (A_R3 or A_R4 or A_R5) and (not CD_D11)  # D11: cancelling
        N_X_D13 = (X_D13 or CAN_D13) and (A_R6 or A_R7 or A_R8 or A_R9) and (not CD_D13)  # D13: cancelling
        N_X_D15 = (X_D15 or CAN_D15) and (A_R10 or A_R11) and (not CD_D15)  # D15: cancelling
        N_X_D17 = (X_D17 or CAN_D17) and (A_R12 or A_R13) and (not CD_D17)  # D17: cancelling
        N_X_D3 = (X_D3 or CAN_D3) and (A_R14 or A_R15) and (not CD_D3)  # D3: cancelling
        N_X_D5 = (X_D5 or CAN_D5) and A_R16 and (not CD_D5)  # D5: cancelling
        N_X_D7 = (X_D7 or CAN_D7) and (A_R17 or A_R18) and (not CD_D7)  # D7: cancelling
        N_X_D9 = (X_D9 or CAN_D9) and (A_R19 or A_R20 or A_R21) and (not CD_D9)  # D9: cancelling
        N_X_S4 = (X_S4 or CAN_S4) and (A_R22 or A_R23 or A_R24 or A_R25 or A_R26 or A_R27) and (not CD_S4)  # S4: cancelling
        N_X_S5 = (X_S5 or CAN_S5) and (A_R28 or A_R29 or A_R30 or A_R31) and (not CD_S5)  # S5: cancelling
        N_X_SII = (X_SII or CAN_SII) and (A_R32 or A_R33 or A_R34 or A_R35 or A_R36 or A_R37) and (not CD_SII)  # SII: cancelling
        N_X_SIII = (X_SIII or CAN_SIII) and (A_R38 or A_R39 or A_R40 or A_R41 or A_R42 or A_R43 or A_R44 or A_R45) and (not CD_SIII)  # SIII: cancelling
        N_X_X = (X_X or CAN_X) and (A_R46 or A_R47 or A_R48 or A_R49 or A_R50 or A_R51 or A_R52 or A_R53 or A_R54 or A_R55 or A_R56 or A_R57 or A_R58 or A_R59 or A_R60 or A_R61 or A_R62 or A_R63 or A_R64 or A_R65) and (not CD_X)  # X: cancelling
        N_X_XD = (X_XD or CAN_XD) and (A_R66 or A_R67 or A_R68 or A_R69 or A_R70 or A_R71 or A_R72 or A_R73 or A_R74 or A_R75) and (not CD_XD)  # XD: cancelling
        N_N_R2 = (N_R2 or (VOY == 1)) and (not G_R2) and (not CAN_D1)  # route D1-D9 is noted
        N_T_R2 = T_R20  # it is the turn of route D1-D9
        N_N_R7 = (N_R7 or (VOY == 1)) and (not G_R7) and (not CAN_D13)  # route D13-IG is noted
        N_T_R7 = T_R2  # it is the turn of route D13-IG
        N_N_R20 = (N_R20 or (VOY == 1)) and (not G_R20) and (not CAN_D9)  # route D9-D13 is noted
        N_T_R20 = T_R7  # it is the turn of route D9-D13
        N_K_1_19WG = K_1_19WG and (not RLS_1_19WG)  # 1/19WG: restart lock (R16)
        N_L_1_19WG_1 = (L_1_19WG_1 or GW_1_19WG_1 or (GB_1_19WG_1 and FREE_1_19WG)) and (not RLS_1_19WG)  # 1/19WG locked from 1/19WG|19-27DG@19.normal to 1/19WG|1DG@WG.0
        N_L_1_19WG_2 = (L_1_19WG_2 or (GB_1_19WG_2 and FREE_1_19WG)) and (not RLS_1_19WG)  # 1/19WG locked from 1/19WG|1DG@WG.0 to 1/19WG|19-27DG@19.normal
        N_M_1_19WG = (M_1_19WG or G_R22 or G_R32) and (not RLS_1_19WG) and (not AR_1_19WG)  # 1/19WG locked for a train movement
        N_F_1_19WG = (F_1_19WG or LK_R22 or (LK_R25 and (L_1_19WG_1 or L_1_19WG_2)) or LK_R32 or (LK_R35 and (L_1_19WG_1 or L_1_19WG_2)) or (LK_R1 and (L_1_19WG_1 or L_1_19WG_2))) and (not RLS_1_19WG)  # 1/19WG firmly locked
        N_U_1_19WG = (U_1_19WG or NU_1_19WG_1 or NU_1_19WG_2) and (not RLS_1_19WG)  # 1/19WG used by a train (R9)
        N_P_1_19WG = (P_1_19WG or (U_1_19WG and OCC_1_19WG and (NU_19_27DG_1 or NU_1DG_1))) and (not RLS_1_19WG)  # 1/19WG: the train went on (R9)
        N_D_1_19WG = (D_1_19WG or ((not VALID) and (L_1_19WG_1 or L_1_19WG_2))) and (not RLS_1_19WG)  # 1/19WG: detection is not relied on, inputs were lost or a train is called on
        N_K_11_13DG = K_11_13DG and (not RLS_11_13DG)  # 11-13DG: restart lock (R16)
        N_L_11_13DG_1 = (L_11_13DG_1 or GW_11_13DG_1) and (not RLS_11_13DG)  # 11-13DG locked from 11-13DG|21DG@11.toe to 11-13DG|7DG@13.toe
        N_L_11_13DG_2 = (L_11_13DG_2 or GW_11_13DG_2) and (not RLS_11_13DG)  # 11-13DG locked from 11-13DG|21DG@11.toe to 11-13DG|9-15DG@11.reverse
        N_L_11_13DG_3 = (L_11_13DG_3 or GW_11_13DG_3) and (not RLS_11_13DG)  # 11-13DG locked from 11-13DG|7DG@13.toe to 11-13DG|21DG@11.toe
        N_L_11_13DG_4 = (L_11_13DG_4 or GW_11_13DG_4) and (not RLS_11_13DG)  # 11-13DG locked from 11-13DG|7DG@13.toe to 11-13DG|9-15DG@15.reverse
        N_L_11_13DG_5 = (L_11_13DG_5 or GW_11_13DG_5) and (not RLS_11_13DG)  # 11-13DG locked from 11-13DG|9-15DG@11.reverse to 11-13DG|21DG@11.toe
        N_L_11_13DG_6 = (L_11_13DG_6 or GW_11_13DG_6) and (not RLS_11_13DG)  # 11-13DG locked from 11-13DG|9-15DG@15.reverse to 11-13DG|7DG@13.toe
        N_M_11_13DG = (M_11_13DG or G_R29 or G_R40 or G_R28 or G_R39 or G_R49 or G_R54 or G_R59 or G_R64 or G_R67 or G_R70 or G_R72 or G_R75 or G_R47 or G_R51 or G_R53 or G_R57 or G_R61 or G_R63 or G_R66 or G_R68 or G_R69 or G_R71 or G_R73 or G_R74 or G_R50 or G_R55 or G_R60 or G_R65 or G_R24 or G_R34 or G_R41) and (not RLS_11_13DG)  # 11-13DG locked for a train movement
        N_F_11_13DG = (F_11_13DG or LK_R29 or LK_R31 or LK_R40 or LK_R44 or LK_R28 or LK_R30 or LK_R39 or LK_R43 or LK_R3 or LK_R5 or LK_R49 or LK_R54 or LK_R59 or LK_R64 or LK_R67 or LK_R70 or LK_R72 or LK_R75 or LK_R4 or LK_R47 or LK_R51 or LK_R53 or LK_R57 or LK_R61 or LK_R63 or LK_R66 or LK_R68 or LK_R69 or LK_R71 or LK_R73 or LK_R74 or LK_R19 or LK_R21 or LK_R50 or LK_R55 or LK_R60 or LK_R65 or LK_R13 or LK_R24 or LK_R27 or LK_R34 or LK_R37 or LK_R41 or LK_R45) and (not RLS_11_13DG)  # 11-13DG firmly locked
        N_U_11_13DG = (U_11_13DG or NU_11_13DG_1 or NU_11_13DG_2 or NU_11_13DG_3 or NU_11_13DG_4) and (not RLS_11_13DG)  # 11-13DG used by a train (R9)
        N_P_11_13DG = (P_11_13DG or (U_11_13DG and OCC_11_13DG and (NU_21DG_1 or NU_7DG_1 or NU_9_15DG_1 or NU_9_15DG_2))) and (not RLS_11_13DG)  # 11-13DG: the train went on (R9)
        N_D_11_13DG = (D_11_13DG or ((not VALID) and (L_11_13DG_1 or L_11_13DG_2 or L_11_13DG_3 or L_11_13DG_4 or L_11_13DG_5 or L_11_13DG_6)) or G_R57 or G_R59 or G_R60 or G_R61 or G_R63 or G_R64 or G_R65 or G_R71 or G_R72 or G_R73 or G_R74 or G_R75) and (not RLS_11_13DG)  # 11-13DG: detection is not relied on, inputs were lost or a train is called on
        N_K_17_23DG = K_17_23DG and (not RLS_17_23DG)  # 17-23DG: restart lock (R16)
        N_L_17_23DG_1 = (L_17_23DG_1 or GW_17_23DG_1) and (not RLS_17_23DG)  # 17-23DG locked from 17-23DG|19-27DG@x17.0 to 17-23DG|9-15DG@15.toe
        N_L_17_23DG_2 = (L_17_23DG_2 or GW_17_23DG_2) and (not RLS_17_23DG)  # 17-23DG locked from 17-23DG|25DG@x23.0 to 17-23DG|9-15DG@15.toe
        N_L_17_23DG_3 = (L_17_23DG_3 or GW_17_23DG_3) and (not RLS_17_23DG)  # 17-23DG locked from 17-23DG|9-15DG@15.toe to 17-23DG|19-27DG@x17.0
        N_L_17_23DG_4 = (L_17_23DG_4 or GW_17_23DG_4) and (not RLS_17_23DG)  # 17-23DG locked from 17-23DG|9-15DG@15.toe to 17-23DG|25DG@x23.0
        N_L_17_23DG_5 = (L_17_23DG_5 or GW_17_23DG_5) and (not RLS_17_23DG)  # 17-23DG locked from 17-23DG|9-15DG@15.toe to 17-23DG|IG@tI.0
        N_L_17_23DG_6 = (L_17_23DG_6 or GW_17_23DG_6) and (not RLS_17_23DG)  # 17-23DG locked from 17-23DG|IG@tI.0 to 17-23DG|9-15DG@15.toe
        N_M_17_23DG = (M_17_23DG or G_R23 or G_R24 or G_R33 or G_R34 or G_R38 or G_R41 or G_R52 or G_R53 or G_R62 or G_R63 or G_R69 or G_R74 or G_R48 or G_R51 or G_R58 or G_R61 or G_R68 or G_R73 or G_R46 or G_R47 or G_R56 or G_R57 or G_R66 or G_R71) and (not RLS_17_23DG)  # 17-23DG locked for a train movement
        N_F_17_23DG = (F_17_23DG or LK_R23 or LK_R24 or LK_R26 or LK_R27 or LK_R33 or LK_R34 or LK_R36 or LK_R37 or LK_R38 or LK_R41 or LK_R42 or LK_R45 or LK_R6 or LK_R8 or LK_R52 or LK_R53 or LK_R62 or LK_R63 or LK_R69 or LK_R74 or LK_R9 or LK_R48 or LK_R51 or LK_R58 or LK_R61 or LK_R68 or LK_R73 or LK_R7 or LK_R46 or LK_R47 or LK_R56 or LK_R57 or LK_R66 or LK_R71 or LK_R12 or LK_R13) and (not RLS_17_23DG)  # 17-23DG firmly locked
        N_U_17_23DG = (U_17_23DG or NU_17_23DG_1 or NU_17_23DG_2 or NU_17_23DG_3 or NU_17_23DG_4) and (not RLS_17_23DG)  # 17-23DG used by a train (R9)
        N_P_17_23DG = (P_17_23DG or (U_17_23DG and OCC_17_23DG and (NU_19_27DG_2 or NU_25DG_1 or NU_9_15DG_3 or NU_IG_1))) and (not RLS_17_23DG)  # 17-23DG: the train went on (R9)
        N_D_17_23DG = (D_17_23DG or ((not VALID) and (L_17_23DG_1 or L_17_23DG_2 or L_17_23DG_3 or L_17_23DG_4 or L_17_23DG_5 or L_17_23DG_6)) or G_R56 or G_R57 or G_R58 or G_R61 or G_R62 or G_R63 or G_R71 or G_R73 or G_R74) and (not RLS_17_23DG)  # 17-23DG: detection is not relied on, inputs were lost or a train is called on
        N_K_19_27DG = K_19_27DG and (not RLS_19_27DG)  # 19-27DG: restart lock (R16)
        N_L_19_27DG_1 = (L_19_27DG_1 or GW_19_27DG_1) and (not RLS_19_27DG)  # 19-27DG locked from 1/19WG|19-27DG@19.normal to 19-27DG|4G@t4.0
        N_L_19_27DG_2 = (L_19_27DG_2 or GW_19_27DG_2) and (not RLS_19_27DG)  # 19-27DG locked from 1/19WG|19-27DG@19.normal to 19-27DG|IIG@tII.0
        N_L_19_27DG_3 = (L_19_27DG_3 or GW_19_27DG_3) and (not RLS_19_27DG)  # 19-27DG locked from 17-23DG|19-27DG@x17.0 to 19-27DG|4G@t4.0
        N_L_19_27DG_4 = (L_19_27DG_4 or GW_19_27DG_4) and (not RLS_19_27DG)  # 19-27DG locked from 17-23DG|19-27DG@x17.0 to 19-27DG|IIG@tII.0
        N_L_19_27DG_5 = (L_19_27DG_5 or GW_19_27DG_5) and (not RLS_19_27DG)  # 19-27DG locked from 19-27DG|4G@t4.0 to 1/19WG|19-27DG@19.normal
        N_L_19_27DG_6 = (L_19_27DG_6 or GW_19_27DG_6) and (not RLS_19_27DG)  # 19-27DG locked from 19-27DG|4G@t4.0 to 17-23DG|19-27DG@x17.0
        N_L_19_27DG_7 = (L_19_27DG_7 or GW_19_27DG_7) and (not RLS_19_27DG)  # 19-27DG locked from 19-27DG|IIG@tII.0 to 1/19WG|19-27DG@19.normal
        N_L_19_27DG_8 = (L_19_27DG_8 or GW_19_27DG_8) and (not RLS_19_27DG)  # 19-27DG locked from 19-27DG|IIG@tII.0 to 17-23DG|19-27DG@x17.0
        N_M_19_27DG = (M_19_27DG or G_R52 or G_R53 or G_R62 or G_R63 or G_R69 or G_R74 or G_R22 or G_R23 or G_R24 or G_R32 or G_R33 or G_R34) and (not RLS_19_27DG)  # 19-27DG locked for a train movement
        N_F_19_27DG = (F_19_27DG or LK_R10 or LK_R11 or LK_R6 or LK_R52 or LK_R53 or LK_R62 or LK_R63 or LK_R69 or LK_R74 or LK_R8 or LK_R22 or LK_R25 or LK_R23 or LK_R24 or LK_R26 or LK_R27 or LK_R32 or LK_R35 or LK_R33 or LK_R34 or LK_R36 or LK_R37) and (not RLS_19_27DG)  # 19-27DG firmly locked
        N_U_19_27DG = (U_19_27DG or NU_19_27DG_1 or NU_19_27DG_2 or NU_19_27DG_3 or NU_19_27DG_4) and (not RLS_19_27DG)  # 19-27DG used by a train (R9)
        N_P_19_27DG = (P_19_27DG or (U_19_27DG and OCC_19_27DG and (NU_1_19WG_1 or NU_17_23DG_1 or NU_4G_1 or NU_IIG_1))) and (not RLS_19_27DG)  # 19-27DG: the train went on (R9)
        N_D_19_27DG = (D_19_27DG or ((not VALID) and (L_19_27DG_1 or L_19_27DG_2 or L_19_27DG_3 or L_19_27DG_4 or L_19_27DG_5 or L_19_27DG_6 or L_19_27DG_7 or L_19_27DG_8)) or G_R62 or G_R63 or G_R74) and (not RLS_19_27DG)  # 19-27DG: detection is not relied on, inputs were lost or a train is called on
        N_K_1DG = K_1DG and (not RLS_1DG)  # 1DG: restart lock (R16)
        N_L_1DG_1 = (L_1DG_1 or GW_1DG_1) and (not RLS_1DG)  # 1DG locked from 1/19WG|1DG@WG.0 to 1DG|IIAG@1.toe
        N_L_1DG_2 = (L_1DG_2 or GW_1DG_2) and (not RLS_1DG)  # 1DG locked from 1DG|3DG@x1.0 to 1DG|IIAG@1.toe
        N_L_1DG_3 = (L_1DG_3 or GW_1DG_3) and (not RLS_1DG)  # 1DG locked from 1DG|IIAG@1.toe to 1/19WG|1DG@WG.0
        N_L_1DG_4 = (L_1DG_4 or GW_1DG_4) and (not RLS_1DG)  # 1DG locked from 1DG|IIAG@1.toe to 1DG|3DG@x1.0
        N_M_1DG = (M_1DG or G_R22 or G_R32 or G_R23 or G_R28 or G_R33 or G_R38 or G_R39) and (not RLS_1DG)  # 1DG locked for a train movement
        N_F_1DG = (F_1DG or LK_R16 or LK_R22 or LK_R32 or LK_R18 or LK_R23 or LK_R28 or LK_R33 or LK_R38 or LK_R39 or LK_R1 or LK_R2) and (not RLS_1DG)  # 1DG firmly locked
        N_U_1DG = (U_1DG or NU_1DG_1 or NU_1DG_2 or NU_1DG_3) and (not RLS_1DG)  # 1DG used by a train (R9)
        N_P_1DG = (P_1DG or (U_1DG and OCC_1DG and (NU_1_19WG_2 or NU_3DG_1 or NU_IIAG_1))) and (not RLS_1DG)  # 1DG: the train went on (R9)
        N_D_1DG = (D_1DG or ((not VALID) and (L_1DG_1 or L_1DG_2 or L_1DG_3 or L_1DG_4))) and (not RLS_1DG)  # 1DG: detection is not relied on, inputs were lost or a train is called on
        N_K_21DG = K_21DG and (not RLS_21DG)  # 21DG: restart lock (R16)
        N_L_21DG_1 = (L_21DG_1 or GW_21DG_1) and (not RLS_21DG)  # 21DG locked from 11-13DG|21DG@11.toe to 21DG|25DG@21.normal
        N_L_21DG_2 = (L_21DG_2 or GW_21DG_2) and (not RLS_21DG)  # 21DG locked from 11-13DG|21DG@11.toe to 21DG|5G@t5.0
        N_L_21DG_3 = (L_21DG_3 or GW_21DG_3) and (not RLS_21DG)  # 21DG locked from 21DG|25DG@21.normal to 11-13DG|21DG@11.toe
        N_L_21DG_4 = (L_21DG_4 or GW_21DG_4) and (not RLS_21DG)  # 21DG locked from 21DG|5G@t5.0 to 11-13DG|21DG@11.toe
        N_M_21DG = (M_21DG or G_R49 or G_R50 or G_R59 or G_R60 or G_R67 or G_R72 or G_R54 or G_R55 or G_R64 or G_R65 or G_R70 or G_R75 or G_R39 or G_R40 or G_R28 or G_R29) and (not RLS_21DG)  # 21DG locked for a train movement
        N_F_21DG = (F_21DG or LK_R5 or LK_R21 or LK_R49 or LK_R50 or LK_R59 or LK_R60 or LK_R67 or LK_R72 or LK_R3 or LK_R19 or LK_R54 or LK_R55 or LK_R64 or LK_R65 or LK_R70 or LK_R75 or LK_R39 or LK_R40 or LK_R43 or LK_R44 or LK_R28 or LK_R29 or LK_R30 or LK_R31) and (not RLS_21DG)  # 21DG firmly locked
        N_U_21DG = (U_21DG or NU_21DG_1 or NU_21DG_2 or NU_21DG_3) and (not RLS_21DG)  # 21DG used by a train (R9)
        N_P_21DG = (P_21DG or (U_21DG and OCC_21DG and (NU_11_13DG_1 or NU_25DG_2 or NU_5G_1))) and (not RLS_21DG)  # 21DG: the train went on (R9)
        N_D_21DG = (D_21DG or ((not VALID) and (L_21DG_1 or L_21DG_2 or L_21DG_3 or L_21DG_4)) or G_R59 or G_R60 or G_R64 or G_R65 or G_R72 or G_R75) and (not RLS_21DG)  # 21DG: detection is not relied on, inputs were lost or a train is called on
        N_K_25DG = K_25DG and (not RLS_25DG)  # 25DG: restart lock (R16)
        N_L_25DG_1 = (L_25DG_1 or GW_25DG_1) and (not RLS_25DG)  # 25DG locked from 17-23DG|25DG@x23.0 to 25DG|IIIG@tIII.0
        N_L_25DG_2 = (L_25DG_2 or GW_25DG_2) and (not RLS_25DG)  # 25DG locked from 21DG|25DG@21.normal to 25DG|IIIG@tIII.0
        N_L_25DG_3 = (L_25DG_3 or GW_25DG_3) and (not RLS_25DG)  # 25DG locked from 25DG|IIIG@tIII.0 to 17-23DG|25DG@x23.0
        N_L_25DG_4 = (L_25DG_4 or GW_25DG_4) and (not RLS_25DG)  # 25DG locked from 25DG|IIIG@tIII.0 to 21DG|25DG@21.normal
        N_M_25DG = (M_25DG or G_R48 or G_R51 or G_R58 or G_R61 or G_R68 or G_R73 or G_R49 or G_R50 or G_R59 or G_R60 or G_R67 or G_R72 or G_R38 or G_R41 or G_R39 or G_R40) and (not RLS_25DG)  # 25DG locked for a train movement
        N_F_25DG = (F_25DG or LK_R9 or LK_R48 or LK_R51 or LK_R58 or LK_R61 or LK_R68 or LK_R73 or LK_R5 or LK_R21 or LK_R49 or LK_R50 or LK_R59 or LK_R60 or LK_R67 or LK_R72 or LK_R38 or LK_R41 or LK_R42 or LK_R45 or LK_R39 or LK_R40 or LK_R43 or LK_R44) and (not RLS_25DG)  # 25DG firmly locked
        N_U_25DG = (U_25DG or NU_25DG_1 or NU_25DG_2 or NU_25DG_3) and (not RLS_25DG)  # 25DG used by a train (R9)
        N_P_25DG = (P_25DG or (U_25DG and OCC_25DG and (NU_17_23DG_2 or NU_21DG_2 or NU_IIIG_1))) and (not RLS_25DG)  # 25DG: the train went on (R9)
        N_D_25DG = (D_25DG or ((not VALID) and (L_25DG_1 or L_25DG_2 or L_25DG_3 or L_25DG_4)) or G_R58 or G_R59 or G_R60 or G_R61 or G_R72 or G_R73) and (not RLS_25DG)  # 25DG: detection is not relied on, inputs were lost or a train is called on
        N_K_3DG = K_3DG and (not RLS_3DG)  # 3DG: restart lock (R16)
        N_L_3DG_1 = (L_3DG_1 or GW_3DG_1) and (not RLS_3DG)  # 3DG locked from 1DG|3DG@x1.0 to 3DG|9-15DG@3-9.end
        N_L_3DG_2 = (L_3DG_2 or GW_3DG_2) and (not RLS_3DG)  # 3DG locked from 3DG|5DG@3.normal to 3DG|9-15DG@3-9.end
        N_L_3DG_3 = (L_3DG_3 or GW_3DG_3) and (not RLS_3DG)  # 3DG locked from 3DG|9-15DG@3-9.end to 1DG|3DG@x1.0
        N_L_3DG_4 = (L_3DG_4 or GW_3DG_4) and (not RLS_3DG)  # 3DG locked from 3DG|9-15DG@3-9.end to 3DG|5DG@3.normal
        N_M_3DG = (M_3DG or G_R46 or G_R48 or G_R50 or G_R52 or G_R55 or G_R56 or G_R58 or G_R60 or G_R62 or G_R65 or G_R23 or G_R28 or G_R33 or G_R38 or G_R39) and (not RLS_3DG)  # 3DG locked for a train movement
        N_F_3DG = (F_3DG or LK_R2 or LK_R15 or LK_R46 or LK_R48 or LK_R50 or LK_R52 or LK_R55 or LK_R56 or LK_R58 or LK_R60 or LK_R62 or LK_R65 or LK_R18 or LK_R23 or LK_R28 or LK_R33 or LK_R38 or LK_R39 or LK_R17) and (not RLS_3DG)  # 3DG firmly locked
        N_U_3DG = (U_3DG or NU_3DG_1 or NU_3DG_2 or NU_3DG_3) and (not RLS_3DG)  # 3DG used by a train (R9)
        N_P_3DG = (P_3DG or (U_3DG and OCC_3DG and (NU_1DG_2 or NU_5DG_1 or NU_9_15DG_4))) and (not RLS_3DG)  # 3DG: the train went on (R9)
        N_D_3DG = (D_3DG or ((not VALID) and (L_3DG_1 or L_3DG_2 or L_3DG_3 or L_3DG_4)) or G_R56 or G_R58 or G_R60 or G_R62 or G_R65) and (not RLS_3DG)  # 3DG: detection is not relied on, inputs were lost or a train is called on
        N_K_4G = K_4G and (not RLS_4G)  # 4G: restart lock (R16)
        N_L_4G_1 = (L_4G_1 or GW_4G_1 or (GB_4G_1 and FREE_4G)) and (not RLS_4G)  # 4G locked from 19-27DG|4G@t4.0 to E4
        N_M_4G = (M_4G or G_R52 or G_R53 or G_R62 or G_R63 or G_R69 or G_R74) and (not RLS_4G) and (not AR_4G)  # 4G locked for a train movement
        N_F_4G = (F_4G or (LK_R6 and L_4G_1) or (LK_R10 and L_4G_1) or LK_R52 or LK_R53 or LK_R62 or LK_R63 or LK_R69 or LK_R74) and (not RLS_4G)  # 4G firmly locked
        N_U_4G = (U_4G or NU_4G_1) and (not RLS_4G)  # 4G used by a train (R9)
        N_P_4G = (P_4G or (U_4G and OCC_4G and NU_19_27DG_3)) and (not RLS_4G)  # 4G: the train went on (R9)
        N_D_4G = (D_4G or ((not VALID) and L_4G_1) or G_R62 or G_R63 or G_R74) and (not RLS_4G)  # 4G: detection is not relied on, inputs were lost or a train is called on
        N_K_5DG = K_5DG and (not RLS_5DG)  # 5DG: restart lock (R16)
        N_L_5DG_1 = (L_5DG_1 or GW_5DG_1) and (not RLS_5DG)  # 5DG locked from 3DG|5DG@3.normal to 5DG|IAG@5.toe
        N_L_5DG_2 = (L_5DG_2 or GW_5DG_2) and (not RLS_5DG)  # 5DG locked from 5DG|7DG@x5.0 to 5DG|IAG@5.toe
        N_L_5DG_3 = (L_5DG_3 or GW_5DG_3) and (not RLS_5DG)  # 5DG locked from 5DG|IAG@5.toe to 3DG|5DG@3.normal
        N_L_5DG_4 = (L_5DG_4 or GW_5DG_4) and (not RLS_5DG)  # 5DG locked from 5DG|IAG@5.toe to 5DG|7DG@x5.0
        N_M_5DG = (M_5DG or G_R46 or G_R48 or G_R50 or G_R52 or G_R55 or G_R56 or G_R58 or G_R60 or G_R62 or G_R65 or G_R47 or G_R49 or G_R51 or G_R53 or G_R54 or G_R57 or G_R59 or G_R61 or G_R63 or G_R64) and (not RLS_5DG)  # 5DG locked for a train movement
        N_F_5DG = (F_5DG or LK_R17 or LK_R13 or LK_R27 or LK_R31 or LK_R37 or LK_R44 or LK_R45 or LK_R15 or LK_R46 or LK_R48 or LK_R50 or LK_R52 or LK_R55 or LK_R56 or LK_R58 or LK_R60 or LK_R62 or LK_R65 or LK_R14 or LK_R47 or LK_R49 or LK_R51 or LK_R53 or LK_R54 or LK_R57 or LK_R59 or LK_R61 or LK_R63 or LK_R64) and (not RLS_5DG)  # 5DG firmly locked
        N_U_5DG = (U_5DG or NU_5DG_1 or NU_5DG_2 or NU_5DG_3) and (not RLS_5DG)  # 5DG used by a train (R9)
        N_P_5DG = (P_5DG or (U_5DG and OCC_5DG and (NU_3DG_2 or NU_7DG_2 or NU_IAG_1))) and (not RLS_5DG)  # 5DG: the train went on (R9)
        N_D_5DG = (D_5DG or ((not VALID) and (L_5DG_1 or L_5DG_2 or L_5DG_3 or L_5DG_4)) or G_R56 or G_R57 or G_R58 or G_R59 or G_R60 or G_R61 or G_R62 or G_R63 or G_R64 or G_R65) and (not RLS_5DG)  # 5DG: detection is not relied on, inputs were lost or a train is called on
        N_K_5G = K_5G and (not RLS_5G)  # 5G: restart lock (R16)
        N_L_5G_1 = (L_5G_1 or GW_5G_1 or (GB_5G_1 and FREE_5G)) and (not RLS_5G)  # 5G locked from 21DG|5G@t5.0 to E5
        N_M_5G = (M_5G or G_R54 or G_R55 or G_R64 or G_R65 or G_R70 or G_R75) and (not RLS_5G) and (not AR_5G)  # 5G locked for a train movement
        N_F_5G = (F_5G or (LK_R3 and L_5G_1) or (LK_R19 and L_5G_1) or LK_R54 or LK_R55 or LK_R64 or LK_R65 or LK_R70 or LK_R75) and (not RLS_5G)  # 5G firmly locked
        N_U_5G = (U_5G or NU_5G_1) and (not RLS_5G)  # 5G used by a train (R9)
        N_P_5G = (P_5G or (U_5G and OCC_5G and NU_21DG_3)) and (not RLS_5G)  # 5G: the train went on (R9)
        N_D_5G = (D_5G or ((not VALID) and L_5G_1) or G_R64 or G_R65 or G_R75) and (not RLS_5G)  # 5G: detection is not relied on, inputs were lost or a train is called on
        N_K_7DG = K_7DG and (not RLS_7DG)  # 7DG: restart lock (R16)
        N_L_7DG_1 = (L_7DG_1 or GW_7DG_1) and (not RLS_7DG)  # 7DG locked from 11-13DG|7DG@13.toe to 5DG|7DG@x5.0
        N_L_7DG_2 = (L_7DG_2 or GW_7DG_2) and (not RLS_7DG)  # 7DG locked from 11-13DG|7DG@13.toe to DJ
        N_L_7DG_3 = (L_7DG_3 or GW_7DG_3) and (not RLS_7DG)  # 7DG locked from 5DG|7DG@x5.0 to 11-13DG|7DG@13.toe
        N_L_7DG_4 = (L_7DG_4 or GW_7DG_4) and (not RLS_7DG)  # 7DG locked from DJ to 11-13DG|7DG@13.toe
        N_M_7DG = (M_7DG or G_R24 or G_R29 or G_R34 or G_R40 or G_R41 or G_R47 or G_R49 or G_R51 or G_R53 or G_R54 or G_R57 or G_R59 or G_R61 or G_R63 or G_R64 or G_R66 or G_R67 or G_R68 or G_R69 or G_R70 or G_R71 or G_R72 or G_R73 or G_R74 or G_R75) and (not RLS_7DG)  # 7DG locked for a train movement
        N_F_7DG = (F_7DG or LK_R13 or LK_R27 or LK_R31 or LK_R37 or LK_R44 or LK_R45 or LK_R24 or LK_R29 or LK_R34 or LK_R40 or LK_R41 or LK_R14 or LK_R47 or LK_R49 or LK_R51 or LK_R53 or LK_R54 or LK_R57 or LK_R59 or LK_R61 or LK_R63 or LK_R64 or LK_R66 or LK_R67 or LK_R68 or LK_R69 or LK_R70 or LK_R71 or LK_R72 or LK_R73 or LK_R74 or LK_R75) and (not RLS_7DG)  # 7DG firmly locked
        N_U_7DG = (U_7DG or NU_7DG_1 or NU_7DG_2 or NU_7DG_3) and (not RLS_7DG)  # 7DG used by a train (R9)
        N_P_7DG = (P_7DG or (U_7DG and OCC_7DG and (NU_11_13DG_2 or NU_5DG_2))) and (not RLS_7DG)  # 7DG: the train went on (R9)
        N_D_7DG = (D_7DG or ((not VALID) and (L_7DG_1 or L_7DG_2 or L_7DG_3 or L_7DG_4)) or G_R57 or G_R59 or G_R61 or G_R63 or G_R64 or G_R71 or G_R72 or G_R73 or G_R74 or G_R75) and (not RLS_7DG)  # 7DG: detection is not relied on, inputs were lost or a train is called on
        N_K_9_15DG = K_9_15DG and (not RLS_9_15DG)  # 9-15DG: restart lock (R16)
        N_L_9_15DG_1 = (L_9_15DG_1 or GW_9_15DG_1) and (not RLS_9_15DG)  # 9-15DG locked from 11-13DG|9-15DG@11.reverse to 3DG|9-15DG@3-9.end
        N_L_9_15DG_2 = (L_9_15DG_2 or GW_9_15DG_2) and (not RLS_9_15DG)  # 9-15DG locked from 11-13DG|9-15DG@15.reverse to 17-23DG|9-15DG@15.toe
        N_L_9_15DG_3 = (L_9_15DG_3 or GW_9_15DG_3) and (not RLS_9_15DG)  # 9-15DG locked from 17-23DG|9-15DG@15.toe to 11-13DG|9-15DG@15.reverse
        N_L_9_15DG_4 = (L_9_15DG_4 or GW_9_15DG_4) and (not RLS_9_15DG)  # 9-15DG locked from 17-23DG|9-15DG@15.toe to 3DG|9-15DG@3-9.end
        N_L_9_15DG_5 = (L_9_15DG_5 or GW_9_15DG_5) and (not RLS_9_15DG)  # 9-15DG locked from 3DG|9-15DG@3-9.end to 11-13DG|9-15DG@11.reverse
        N_L_9_15DG_6 = (L_9_15DG_6 or GW_9_15DG_6) and (not RLS_9_15DG)  # 9-15DG locked from 3DG|9-15DG@3-9.end to 17-23DG|9-15DG@15.toe
        N_M_9_15DG = (M_9_15DG or G_R28 or G_R39 or G_R47 or G_R51 or G_R53 or G_R57 or G_R61 or G_R63 or G_R66 or G_R68 or G_R69 or G_R71 or G_R73 or G_R74 or G_R24 or G_R34 or G_R41 or G_R23 or G_R33 or G_R38 or G_R50 or G_R55 or G_R60 or G_R65 or G_R46 or G_R48 or G_R52 or G_R56 or G_R58 or G_R62) and (not RLS_9_15DG)  # 9-15DG locked for a train movement
        N_F_9_15DG = (F_9_15DG or LK_R28 or LK_R30 or LK_R39 or LK_R43 or LK_R4 or LK_R47 or LK_R51 or LK_R53 or LK_R57 or LK_R61 or LK_R63 or LK_R66 or LK_R68 or LK_R69 or LK_R71 or LK_R73 or LK_R74 or LK_R13 or LK_R24 or LK_R27 or LK_R34 or LK_R37 or LK_R41 or LK_R45 or LK_R12 or LK_R23 or LK_R26 or LK_R33 or LK_R36 or LK_R38 or LK_R42 or LK_R19 or LK_R21 or LK_R50 or LK_R55 or LK_R60 or LK_R65 or LK_R20 or LK_R46 or LK_R48 or LK_R52 or LK_R56 or LK_R58 or LK_R62) and (not RLS_9_15DG)  # 9-15DG firmly locked
        N_U_9_15DG = (U_9_15DG or NU_9_15DG_1 or NU_9_15DG_2 or NU_9_15DG_3 or NU_9_15DG_4) and (not RLS_9_15DG)  # 9-15DG used by a train (R9)
        N_P_9_15DG = (P_9_15DG or (U_9_15DG and OCC_9_15DG and (NU_11_13DG_3 or NU_11_13DG_4 or NU_17_23DG_3 or NU_3DG_3))) and (not RLS_9_15DG)  # 9-15DG: the train went on (R9)
        N_D_9_15DG = (D_9_15DG or ((not VALID) and (L_9_15DG_1 or L_9_15DG_2 or L_9_15DG_3 or L_9_15DG_4 or L_9_15DG_5 or L_9_15DG_6)) or G_R56 or G_R57 or G_R58 or G_R60 or G_R61 or G_R62 or G_R63 or G_R65 or G_R71 or G_R73 or G_R74) and (not RLS_9_15DG)  # 9-15DG: detection is not relied on, inputs were lost or a train is called on
        N_K_IAG = K_IAG and (not RLS_IAG)  # IAG: restart lock (R16)
        N_L_IAG_1 = (L_IAG_1 or (GB_IAG_1 and FREE_IAG)) and (not RLS_IAG)  # IAG locked from 5DG|IAG@5.toe to BX
        N_L_IAG_2 = (L_IAG_2 or GW_IAG_2) and (not RLS_IAG)  # IAG locked from BX to 5DG|IAG@5.toe
        N_M_IAG = (M_IAG or G_R46 or G_R47 or G_R48 or G_R49 or G_R50 or G_R51 or G_R52 or G_R53 or G_R54 or G_R55 or G_R56 or G_R57 or G_R58 or G_R59 or G_R60 or G_R61 or G_R62 or G_R63 or G_R64 or G_R65) and (not RLS_IAG) and (not AR_IAG)  # IAG locked for a train movement
        N_F_IAG = (F_IAG or (LK_R13 and (L_IAG_1 or L_IAG_2)) or (LK_R17 and (L_IAG_1 or L_IAG_2)) or (LK_R27 and (L_IAG_1 or L_IAG_2)) or (LK_R31 and (L_IAG_1 or L_IAG_2)) or (LK_R37 and (L_IAG_1 or L_IAG_2)) or (LK_R44 and (L_IAG_1 or L_IAG_2)) or (LK_R45 and (L_IAG_1 or L_IAG_2)) or LK_R46 or LK_R47 or LK_R48 or LK_R49 or LK_R50 or LK_R51 or LK_R52 or LK_R53 or LK_R54 or LK_R55 or LK_R56 or LK_R57 or LK_R58 or LK_R59 or LK_R60 or LK_R61 or LK_R62 or LK_R63 or LK_R64 or LK_R65) and (not RLS_IAG)  # IAG firmly locked
        N_U_IAG = (U_IAG or NU_IAG_1 or NU_IAG_2) and (not RLS_IAG)  # IAG used by a train (R9)
        N_P_IAG = (P_IAG or (U_IAG and OCC_IAG and NU_5DG_3)) and (not RLS_IAG)  # IAG: the train went on (R9)
        N_D_IAG = (D_IAG or ((not VALID) and (L_IAG_1 or L_IAG_2)) or G_R56 or G_R57 or G_R58 or G_R59 or G_R60 or G_R61 or G_R62 or G_R63 or G_R64 or G_R65) and (not RLS_IAG)  # IAG: detection is not relied on, inputs were lost or a train is called on
        N_K_IG = K_IG and (not RLS_IG)  # IG: restart lock (R16)
        N_L_IG_1 = (L_IG_1 or GW_IG_1 or (GB_IG_1 and FREE_IG)) and (not RLS_IG)  # IG locked from 17-23DG|IG@tI.0 to E1
        N_M_IG = (M_IG or G_R46 or G_R47 or G_R56 or G_R57 or G_R66 or G_R71) and (not RLS_IG) and (not AR_IG)  # IG locked for a train movement
        N_F_IG = (F_IG or (LK_R7 and L_IG_1) or LK_R46 or LK_R47 or LK_R56 or LK_R57 or LK_R66 or LK_R71) and (not RLS_IG)  # IG firmly locked
        N_U_IG = (U_IG or NU_IG_1) and (not RLS_IG)  # IG used by a train (R9)
        N_P_IG = (P_IG or (U_IG and OCC_IG and NU_17_23DG_4)) and (not RLS_IG)  # IG: the train went on (R9)
        N_D_IG = (D_IG or ((not VALID) and L_IG_1) or G_R56 or G_R57 or G_R71) and (not RLS_IG)  # IG: detection is not relied on, inputs were lost or a train is called on
        N_K_IIAG = K_IIAG and (not RLS_IIAG)  # IIAG: restart lock (R16)
        N_L_IIAG_1 = (L_IIAG_1 or GW_IIAG_1 or (GB_IIAG_1 and FREE_IIAG)) and (not RLS_IIAG)  # IIAG locked from 1DG|IIAG@1.toe to BS
        N_M_IIAG = (M_IIAG or G_R22 or G_R23 or G_R28 or G_R32 or G_R33 or G_R38 or G_R39) and (not RLS_IIAG) and (not AR_IIAG)  # IIAG locked for a train movement
        N_F_IIAG = (F_IIAG or (LK_R16 and L_IIAG_1) or (LK_R18 and L_IIAG_1) or LK_R22 or LK_R23 or LK_R28 or LK_R32 or LK_R33 or LK_R38 or LK_R39) and (not RLS_IIAG)  # IIAG firmly locked
        N_U_IIAG = (U_IIAG or NU_IIAG_1) and (not RLS_IIAG)  # IIAG used by a train (R9)
        N_P_IIAG = (P_IIAG or (U_IIAG and OCC_IIAG and NU_1DG_3)) and (not RLS_IIAG)  # IIAG: the train went on (R9)
        N_D_IIAG = (D_IIAG or ((not VALID) and L_IIAG_1)) and (not RLS_IIAG)  # IIAG: detection is not relied on, inputs were lost or a train is called on
        N_K_IIG = K_IIG and (not RLS_IIG)  # IIG: restart lock (R16)
        N_L_IIG_1 = (L_IIG_1 or (GB_IIG_1 and FREE_IIG)) and (not RLS_IIG)  # IIG locked from 19-27DG|IIG@tII.0 to E2
        N_M_IIG = M_IIG and (not RLS_IIG) and (not AR_IIG)  # IIG locked for a train movement
        N_F_IIG = (F_IIG or (LK_R8 and L_IIG_1) or (LK_R11 and L_IIG_1)) and (not RLS_IIG)  # IIG firmly locked
        N_U_IIG = (U_IIG or NU_IIG_1) and (not RLS_IIG)  # IIG used by a train (R9)
        N_P_IIG = (P_IIG or (U_IIG and OCC_IIG and NU_19_27DG_4)) and (not RLS_IIG)  # IIG: the train went on (R9)
        N_D_IIG = (D_IIG or ((not VALID) and L_IIG_1)) and (not RLS_IIG)  # IIG: detection is not relied on, inputs were lost or a train is called on
        N_K_IIIG = K_IIIG and (not RLS_IIIG)  # IIIG: restart lock (R16)
        N_L_IIIG_1 = (L_IIIG_1 or GW_IIIG_1 or (GB_IIIG_1 and FREE_IIIG)) and (not RLS_IIIG)  # IIIG locked from 25DG|IIIG@tIII.0 to E3
        N_M_IIIG = (M_IIIG or G_R48 or G_R49 or G_R50 or G_R51 or G_R58 or G_R59 or G_R60 or G_R61 or G_R67 or G_R68 or G_R72 or G_R73) and (not RLS_IIIG) and (not AR_IIIG)  # IIIG locked for a train movement
        N_F_IIIG = (F_IIIG or (LK_R5 and L_IIIG_1) or (LK_R9 and L_IIIG_1) or (LK_R21 and L_IIIG_1) or LK_R48 or LK_R49 or LK_R50 or LK_R51 or LK_R58 or LK_R59 or LK_R60 or LK_R61 or LK_R67 or LK_R68 or LK_R72 or LK_R73) and (not RLS_IIIG)  # IIIG firmly locked
        N_U_IIIG = (U_IIIG or NU_IIIG_1) and (not RLS_IIIG)  # IIIG used by a train (R9)
        N_P_IIIG = (P_IIIG or (U_IIIG and OCC_IIIG and NU_25DG_3)) and (not RLS_IIIG)  # IIIG: the train went on (R9)
        N_D_IIIG = (D_IIIG or ((not VALID) and L_IIIG_1) or G_R58 or G_R59 or G_R60 or G_R61 or G_R72 or G_R73) and (not RLS_IIIG)  # IIIG: detection is not relied on, inputs were lost or a train is called on
        N_C_S4 = (PR_R22 or PR_R23 or PR_R24) and (PR_R22 or PR_R23 or PR_R24) and GL_S4  # S4 shows clear
        N_C_S5 = (PR_R28 or PR_R29) and (PR_R28 or PR_R29) and GL_S5  # S5 shows clear
        N_C_SII = (PR_R32 or PR_R33 or PR_R34) and (PR_R32 or PR_R33 or PR_R34) and GL_SII  # SII shows clear
        N_C_SIII = (PR_R38 or PR_R39 or PR_R40 or PR_R41) and (PR_R38 or PR_R39 or PR_R40 or PR_R41) and GL_SIII  # SIII shows clear
        N_C_X = (PR_R46 or PR_R47 or PR_R48 or PR_R49 or PR_R50 or PR_R51 or PR_R52 or PR_R53 or PR_R54 or PR_R55) and False and GL_X  # X shows clear
        N_C_XD = (PR_R66 or PR_R67 or PR_R68 or PR_R69 or PR_R70) and False and GL_XD  # XD shows clear
        self.state = {
            'CN_1_3': bool(N_CN_1_3),
            'CR_1_3': bool(N_CR_1_3),
            'CN_13_15': bool(N_CN_13_15),
            'CR_13_15': bool(N_CR_13_15),
            'CN_17_19': bool(N_CN_17_19),
            'CR_17_19': bool(N_CR_17_19),
            'CN_21': bool(N_CN_21),
            'CR_21': bool(N_CR_21),
            'CN_23_25': bool(N_CN_23_25),
            'CR_23_25': bool(N_CR_23_25),
            'CN_27': bool(N_CN_27),
            'CR_27': bool(N_CR_27),
            'CN_5_7': bool(N_CN_5_7),
            'CR_5_7': bool(N_CR_5_7),
            'CN_9_11': bool(N_CN_9_11),
            'CR_9_11': bool(N_CR_9_11),
            'AL_1_3': bool(N_AL_1_3),
            'AL_13_15': bool(N_AL_13_15),
            'AL_17_19': bool(N_AL_17_19),
            'AL_21': bool(N_AL_21),
            'AL_23_25': bool(N_AL_23_25),
            'AL_27': bool(N_AL_27),
            'AL_5_7': bool(N_AL_5_7),
            'AL_9_11': bool(N_AL_9_11),
            'TH_1_3': bool(N_TH_1_3),
            'TR_1_3': bool(N_TR_1_3),
            'TH_13_15': bool(N_TH_13_15),
            'TR_13_15': bool(N_TR_13_15),
            'TH_17_19': bool(N_TH_17_19),
            'TR_17_19': bool(N_TR_17_19),
            'TH_21': bool(N_TH_21),
            'TR_21': bool(N_TR_21),
            'TH_23_25': bool(N_TH_23_25),
            'TR_23_25': bool(N_TR_23_25),
            'TH_27': bool(N_TH_27),
            'TR_27': bool(N_TR_27),
            'TH_5_7': bool(N_TH_5_7),
            'TR_5_7': bool(N_TR_5_7),
            'TH_9_11': bool(N_TH_9_11),
            'TR_9_11': bool(N_TR_9_11),
            'Z_1_3': bool(N_Z_1_3),
            'Z_13_15': bool(N_Z_13_15),
            'Z_17_19': bool(N_Z_17_19),
            'Z_21': bool(N_Z_21),
            'Z_23_25': bool(N_Z_23_25),
            'Z_27': bool(N_Z_27),
            'Z_5_7': bool(N_Z_5_7),
            'Z_9_11': bool(N_Z_9_11),
            'SG': bool(N_SG),
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
            'PA_R17': bool(N_PA_R17),
            'S_R17': bool(N_S_R17),
            'H_R17': bool(N_H_R17),
            'A_R18': bool(N_A_R18),
            'B_R18': bool(N_B_R18),
            'W_R18': bool(N_W_R18),
            'PA_R18': bool(N_PA_R18),
            'S_R18': bool(N_S_R18),
            'H_R18': bool(N_H_R18),
            'A_R19': bool(N_A_R19),
            'B_R19': bool(N_B_R19),
            'W_R19': bool(N_W_R19),
            'PA_R19': bool(N_PA_R19),
            'S_R19': bool(N_S_R19),
            'H_R19': bool(N_H_R19),
            'A_R20': bool(N_A_R20),
            'B_R20': bool(N_B_R20),
            'W_R20': bool(N_W_R20),
            'PA_R20': bool(N_PA_R20),
            'S_R20': bool(N_S_R20),
            'H_R20': bool(N_H_R20),
            'A_R21': bool(N_A_R21),
            'B_R21': bool(N_B_R21),
            'W_R21': bool(N_W_R21),
            'PA_R21': bool(N_PA_R21),
            'S_R21': bool(N_S_R21),
            'H_R21': bool(N_H_R21),
            'A_R22': bool(N_A_R22),
            'B_R22': bool(N_B_R22),
            'W_R22': bool(N_W_R22),
            'S_R22': bool(N_S_R22),
            'H_R22': bool(N_H_R22),
            'A_R23': bool(N_A_R23),
            'B_R23': bool(N_B_R23),
            'W_R23': bool(N_W_R23),
            'S_R23': bool(N_S_R23),
            'H_R23': bool(N_H_R23),
            'A_R24': bool(N_A_R24),
            'B_R24': bool(N_B_R24),
            'W_R24': bool(N_W_R24),
            'S_R24': bool(N_S_R24),
            'H_R24': bool(N_H_R24),
            'A_R25': bool(N_A_R25),
            'B_R25': bool(N_B_R25),
            'W_R25': bool(N_W_R25),
            'S_R25': bool(N_S_R25),
            'H_R25': bool(N_H_R25),
            'A_R26': bool(N_A_R26),
            'B_R26': bool(N_B_R26),
            'W_R26': bool(N_W_R26),
            'S_R26': bool(N_S_R26),
            'H_R26': bool(N_H_R26),
            'A_R27': bool(N_A_R27),
            'B_R27': bool(N_B_R27),
            'W_R27': bool(N_W_R27),
            'S_R27': bool(N_S_R27),
            'H_R27': bool(N_H_R27),
            'A_R28': bool(N_A_R28),
            'B_R28': bool(N_B_R28),
            'W_R28': bool(N_W_R28),
            'S_R28': bool(N_S_R28),
            'H_R28': bool(N_H_R28),
            'A_R29': bool(N_A_R29),
            'B_R29': bool(N_B_R29),
            'W_R29': bool(N_W_R29),
            'S_R29': bool(N_S_R29),
            'H_R29': bool(N_H_R29),
            'A_R30': bool(N_A_R30),
            'B_R30': bool(N_B_R30),
            'W_R30': bool(N_W_R30),
            'S_R30': bool(N_S_R30),
            'H_R30': bool(N_H_R30),
            'A_R31': bool(N_A_R31),
            'B_R31': bool(N_B_R31),
            'W_R31': bool(N_W_R31),
            'S_R31': bool(N_S_R31),
            'H_R31': bool(N_H_R31),
            'A_R32': bool(N_A_R32),
            'B_R32': bool(N_B_R32),
            'W_R32': bool(N_W_R32),
            'S_R32': bool(N_S_R32),
            'H_R32': bool(N_H_R32),
            'A_R33': bool(N_A_R33),
            'B_R33': bool(N_B_R33),
            'W_R33': bool(N_W_R33),
            'S_R33': bool(N_S_R33),
            'H_R33': bool(N_H_R33),
            'A_R34': bool(N_A_R34),
            'B_R34': bool(N_B_R34),
            'W_R34': bool(N_W_R34),
            'S_R34': bool(N_S_R34),
            'H_R34': bool(N_H_R34),
            'A_R35': bool(N_A_R35),
            'B_R35': bool(N_B_R35),
            'W_R35': bool(N_W_R35),
            'S_R35': bool(N_S_R35),
            'H_R35': bool(N_H_R35),
            'A_R36': bool(N_A_R36),
            'B_R36': bool(N_B_R36),
            'W_R36': bool(N_W_R36),
            'S_R36': bool(N_S_R36),
            'H_R36': bool(N_H_R36),
            'A_R37': bool(N_A_R37),
            'B_R37': bool(N_B_R37),
            'W_R37': bool(N_W_R37),
            'S_R37': bool(N_S_R37),
            'H_R37': bool(N_H_R37),
            'A_R38': bool(N_A_R38),
            'B_R38': bool(N_B_R38),
            'W_R38': bool(N_W_R38),
            'S_R38': bool(N_S_R38),
            'H_R38': bool(N_H_R38),
            'A_R39': bool(N_A_R39),
            'B_R39': bool(N_B_R39),
            'W_R39': bool(N_W_R39),
            'S_R39': bool(N_S_R39),
            'H_R39': bool(N_H_R39),
            'A_R40': bool(N_A_R40),
            'B_R40': bool(N_B_R40),
            'W_R40': bool(N_W_R40),
            'S_R40': bool(N_S_R40),
            'H_R40': bool(N_H_R40),
            'A_R41': bool(N_A_R41),
            'B_R41': bool(N_B_R41),
            'W_R41': bool(N_W_R41),
            'S_R41': bool(N_S_R41),
            'H_R41': bool(N_H_R41),
            'A_R42': bool(N_A_R42),
            'B_R42': bool(N_B_R42),
            'W_R42': bool(N_W_R42),
            'S_R42': bool(N_S_R42),
            'H_R42': bool(N_H_R42),
            'A_R43': bool(N_A_R43),
            'B_R43': bool(N_B_R43),
            'W_R43': bool(N_W_R43),
            'S_R43': bool(N_S_R43),
            'H_R43': bool(N_H_R43),
            'A_R44': bool(N_A_R44),
            'B_R44': bool(N_B_R44),
            'W_R44': bool(N_W_R44),
            'S_R44': bool(N_S_R44),
            'H_R44': bool(N_H_R44),
            'A_R45': bool(N_A_R45),
            'B_R45': bool(N_B_R45),
            'W_R45': bool(N_W_R45),
            'S_R45': bool(N_S_R45),
            'H_R45': bool(N_H_R45),
            'A_R46': bool(N_A_R46),
            'B_R46': bool(N_B_R46),
            'W_R46': bool(N_W_R46),
            'S_R46': bool(N_S_R46),
            'H_R46': bool(N_H_R46),
            'A_R47': bool(N_A_R47),
            'B_R47': bool(N_B_R47),
            'W_R47': bool(N_W_R47),
            'S_R47': bool(N_S_R47),
            'H_R47': bool(N_H_R47),
            'A_R48': bool(N_A_R48),
            'B_R48': bool(N_B_R48),
            'W_R48': bool(N_W_R48),
            'S_R48': bool(N_S_R48),
            'H_R48': bool(N_H_R48),
            'A_R49': bool(N_A_R49),
            'B_R49': bool(N_B_R49),
            'W_R49': bool(N_W_R49),
            'S_R49': bool(N_S_R49),
            'H_R49': bool(N_H_R49),
            'A_R50': bool(N_A_R50),
            'B_R50': bool(N_B_R50),
            'W_R50': bool(N_W_R50),
            'S_R50': bool(N_S_R50),
            'H_R50': bool(N_H_R50),
            'A_R51': bool(N_A_R51),
            'B_R51': bool(N_B_R51),
            'W_R51': bool(N_W_R51),
            'S_R51': bool(N_S_R51),
            'H_R51': bool(N_H_R51),
            'A_R52': bool(N_A_R52),
            'B_R52': bool(N_B_R52),
            'W_R52': bool(N_W_R52),
            'S_R52': bool(N_S_R52),
            'H_R52': bool(N_H_R52),
            'A_R53': bool(N_A_R53),
            'B_R53': bool(N_B_R53),
            'W_R53': bool(N_W_R53),
            'S_R53': bool(N_S_R53),
            'H_R53': bool(N_H_R53),
            'A_R54': bool(N_A_R54),
            'B_R54': bool(N_B_R54),
            'W_R54': bool(N_W_R54),
            'S_R54': bool(N_S_R54),
            'H_R54': bool(N_H_R54),
            'A_R55': bool(N_A_R55),
            'B_R55': bool(N_B_R55),
            'W_R55': bool(N_W_R55),
            'S_R55': bool(N_S_R55),
            'H_R55': bool(N_H_R55),
            'A_R56': bool(N_A_R56),
            'B_R56': bool(N_B_R56),
            'W_R56': bool(N_W_R56),
            'S_R56': bool(N_S_R56),
            'H_R56': bool(N_H_R56),
            'A_R57': bool(N_A_R57),
            'B_R57': bool(N_B_R57),
            'W_R57': bool(N_W_R57),
            'S_R57': bool(N_S_R57),
            'H_R57': bool(N_H_R57),
            'A_R58': bool(N_A_R58),
            'B_R58': bool(N_B_R58),
            'W_R58': bool(N_W_R58),
            'S_R58': bool(N_S_R58),
            'H_R58': bool(N_H_R58),
            'A_R59': bool(N_A_R59),
            'B_R59': bool(N_B_R59),
            'W_R59': bool(N_W_R59),
            'S_R59': bool(N_S_R59),
            'H_R59': bool(N_H_R59),
            'A_R60': bool(N_A_R60),
            'B_R60': bool(N_B_R60),
            'W_R60': bool(N_W_R60),
            'S_R60': bool(N_S_R60),
            'H_R60': bool(N_H_R60),
            'A_R61': bool(N_A_R61),
            'B_R61': bool(N_B_R61),
            'W_R61': bool(N_W_R61),
            'S_R61': bool(N_S_R61),
            'H_R61': bool(N_H_R61),
            'A_R62': bool(N_A_R62),
            'B_R62': bool(N_B_R62),
            'W_R62': bool(N_W_R62),
            'S_R62': bool(N_S_R62),
            'H_R62': bool(N_H_R62),
            'A_R63': bool(N_A_R63),
            'B_R63': bool(N_B_R63),
            'W_R63': bool(N_W_R63),
            'S_R63': bool(N_S_R63),
            'H_R63': bool(N_H_R63),
            'A_R64': bool(N_A_R64),
            'B_R64': bool(N_B_R64),
            'W_R64': bool(N_W_R64),
            'S_R64': bool(N_S_R64),
            'H_R64': bool(N_H_R64),
            'A_R65': bool(N_A_R65),
            'B_R65': bool(N_B_R65),
            'W_R65': bool(N_W_R65),
            'S_R65': bool(N_S_R65),
            'H_R65': bool(N_H_R65),
            'A_R66': bool(N_A_R66),
            'B_R66': bool(N_B_R66),
            'W_R66': bool(N_W_R66),
            'S_R66': bool(N_S_R66),
            'H_R66': bool(N_H_R66),
            'A_R67': bool(N_A_R67),
            'B_R67': bool(N_B_R67),
            'W_R67': bool(N_W_R67),
            'S_R67': bool(N_S_R67),
            'H_R67': bool(N_H_R67),
            'A_R68': bool(N_A_R68),
            'B_R68': bool(N_B_R68),
            'W_R68': bool(N_W_R68),
            'S_R68': bool(N_S_R68),
            'H_R68': bool(N_H_R68),
            'A_R69': bool(N_A_R69),
            'B_R69': bool(N_B_R69),
            'W_R69': bool(N_W_R69),
            'S_R69': bool(N_S_R69),
            'H_R69': bool(N_H_R69),
            'A_R70': bool(N_A_R70),
            'B_R70': bool(N_B_R70),
            'W_R70': bool(N_W_R70),
            'S_R70': bool(N_S_R70),
            'H_R70': bool(N_H_R70),
            'A_R71': bool(N_A_R71),
            'B_R71': bool(N_B_R71),
            'W_R71': bool(N_W_R71),
            'S_R71': bool(N_S_R71),
            'H_R71': bool(N_H_R71),
            'A_R72': bool(N_A_R72),
            'B_R72': bool(N_B_R72),
            'W_R72': bool(N_W_R72),
            'S_R72': bool(N_S_R72),
            'H_R72': bool(N_H_R72),
            'A_R73': bool(N_A_R73),
            'B_R73': bool(N_B_R73),
            'W_R73': bool(N_W_R73),
            'S_R73': bool(N_S_R73),
            'H_R73': bool(N_H_R73),
            'A_R74': bool(N_A_R74),
            'B_R74': bool(N_B_R74),
            'W_R74': bool(N_W_R74),
            'S_R74': bool(N_S_R74),
            'H_R74': bool(N_H_R74),
            'A_R75': bool(N_A_R75),
            'B_R75': bool(N_B_R75),
            'W_R75': bool(N_W_R75),
            'S_R75': bool(N_S_R75),
            'H_R75': bool(N_H_R75),
            'X_D1': bool(N_X_D1),
            'X_D11': bool(N_X_D11),
            'X_D13': bool(N_X_D13),
            'X_D15': bool(N_X_D15),
            'X_D17': bool(N_X_D17),
            'X_D3': bool(N_X_D3),
            'X_D5': bool(N_X_D5),
            'X_D7': bool(N_X_D7),
            'X_D9': bool(N_X_D9),
            'X_S4': bool(N_X_S4),
            'X_S5': bool(N_X_S5),
            'X_SII': bool(N_X_SII),
            'X_SIII': bool(N_X_SIII),
            'X_X': bool(N_X_X),
            'X_XD': bool(N_X_XD),
            'N_R2': bool(N_N_R2),
            'T_R2': bool(N_T_R2),
            'N_R7': bool(N_N_R7),
            'T_R7': bool(N_T_R7),
            'N_R20': bool(N_N_R20),
            'T_R20': bool(N_T_R20),
            'K_1_19WG': bool(N_K_1_19WG),
            'L_1_19WG_1': bool(N_L_1_19WG_1),
            'L_1_19WG_2': bool(N_L_1_19WG_2),
            'M_1_19WG': bool(N_M_1_19WG),
            'F_1_19WG': bool(N_F_1_19WG),
            'U_1_19WG': bool(N_U_1_19WG),
            'P_1_19WG': bool(N_P_1_19WG),
            'D_1_19WG': bool(N_D_1_19WG),
            'K_11_13DG': bool(N_K_11_13DG),
            'L_11_13DG_1': bool(N_L_11_13DG_1),
            'L_11_13DG_2': bool(N_L_11_13DG_2),
            'L_11_13DG_3': bool(N_L_11_13DG_3),
            'L_11_13DG_4': bool(N_L_11_13DG_4),
            'L_11_13DG_5': bool(N_L_11_13DG_5),
            'L_11_13DG_6': bool(N_L_11_13DG_6),
            'M_11_13DG': bool(N_M_11_13DG),
            'F_11_13DG': bool(N_F_11_13DG),
            'U_11_13DG': bool(N_U_11_13DG),
            'P_11_13DG': bool(N_P_11_13DG),
            'D_11_13DG': bool(N_D_11_13DG),
            'K_17_23DG': bool(N_K_17_23DG),
            'L_17_23DG_1': bool(N_L_17_23DG_1),
            'L_17_23DG_2': bool(N_L_17_23DG_2),
            'L_17_23DG_3': bool(N_L_17_23DG_3),
            'L_17_23DG_4': bool(N_L_17_23DG_4),
            'L_17_23DG_5': bool(N_L_17_23DG_5),
            'L_17_23DG_6': bool(N_L_17_23DG_6),
            'M_17_23DG': bool(N_M_17_23DG),
            'F_17_23DG': bool(N_F_17_23DG),
            'U_17_23DG': bool(N_U_17_23DG),
            'P_17_23DG': bool(N_P_17_23DG),
            'D_17_23DG': bool(N_D_17_23DG),
            'K_19_27DG': bool(N_K_19_27DG),
            'L_19_27DG_1': bool(N_L_19_27DG_1),
            'L_19_27DG_2': bool(N_L_19_27DG_2),
            'L_19_27DG_3': bool(N_L_19_27DG_3),
            'L_19_27DG_4': bool(N_L_19_27DG_4),
            'L_19_27DG_5': bool(N_L_19_27DG_5),
            'L_19_27DG_6': bool(N_L_19_27DG_6),
            'L_19_27DG_7': bool(N_L_19_27DG_7),
            'L_19_27DG_8': bool(N_L_19_27DG_8),
            'M_19_27DG': bool(N_M_19_27DG),
            'F_19_27DG': bool(N_F_19_27DG),
            'U_19_27DG': bool(N_U_19_27DG),
            'P_19_27DG': bool(N_P_19_27DG),
            'D_19_27DG': bool(N_D_19_27DG),
            'K_1DG': bool(N_K_1DG),
            'L_1DG_1': bool(N_L_1DG_1),
            'L_1DG_2': bool(N_L_1DG_2),
            'L_1DG_3': bool(N_L_1DG_3),
            'L_1DG_4': bool(N_L_1DG_4),
            'M_1DG': bool(N_M_1DG),
            'F_1DG': bool(N_F_1DG),
            'U_1DG': bool(N_U_1DG),
            'P_1DG': bool(N_P_1DG),
            'D_1DG': bool(N_D_1DG),
            'K_21DG': bool(N_K_21DG),
            'L_21DG_1': bool(N_L_21DG_1),
            'L_21DG_2': bool(N_L_21DG_2),
            'L_21DG_3': bool(N_L_21DG_3),
            'L_21DG_4': bool(N_L_21DG_4),
            'M_21DG': bool(N_M_21DG),
            'F_21DG': bool(N_F_21DG),
            'U_21DG': bool(N_U_21DG),
            'P_21DG': bool(N_P_21DG),
            'D_21DG': bool(N_D_21DG),
            'K_25DG': bool(N_K_25DG),
            'L_25DG_1': bool(N_L_25DG_1),
            'L_25DG_2': bool(N_L_25DG_2),
            'L_25DG_3': bool(N_L_25DG_3),
            'L_25DG_4': bool(N_L_25DG_4),
            'M_25DG': bool(N_M_25DG),
            'F_25DG': bool(N_F_25DG),
            'U_25DG': bool(N_U_25DG),
            'P_25DG': bool(N_P_25DG),
            'D_25DG': bool(N_D_25DG),
            'K_3DG': bool(N_K_3DG),
            'L_3DG_1': bool(N_L_3DG_1),
            'L_3DG_2': bool(N_L_3DG_2),
            'L_3DG_3': bool(N_L_3DG_3),
            'L_3DG_4': bool(N_L_3DG_4),
            'M_3DG': bool(N_M_3DG),
            'F_3DG': bool(N_F_3DG),
            'U_3DG': bool(N_U_3DG),
            'P_3DG': bool(N_P_3DG),
            'D_3DG': bool(N_D_3DG),
            'K_4G': bool(N_K_4G),
            'L_4G_1': bool(N_L_4G_1),
            'M_4G': bool(N_M_4G),
            'F_4G': bool(N_F_4G),
            'U_4G': bool(N_U_4G),
            'P_4G': bool(N_P_4G),
            'D_4G': bool(N_D_4G),
            'K_5DG': bool(N_K_5DG),
            'L_5DG_1': bool(N_L_5DG_1),
            'L_5DG_2': bool(N_L_5DG_2),
            'L_5DG_3': bool(N_L_5DG_3),
            'L_5DG_4': bool(N_L_5DG_4),
            'M_5DG': bool(N_M_5DG),
            'F_5DG': bool(N_F_5DG),
            'U_5DG': bool(N_U_5DG),
            'P_5DG': bool(N_P_5DG),
            'D_5DG': bool(N_D_5DG),
            'K_5G': bool(N_K_5G),
            'L_5G_1': bool(N_L_5G_1),
            'M_5G': bool(N_M_5G),
            'F_5G': bool(N_F_5G),
            'U_5G': bool(N_U_5G),
            'P_5G': bool(N_P_5G),
            'D_5G': bool(N_D_5G),
            'K_7DG': bool(N_K_7DG),
            'L_7DG_1': bool(N_L_7DG_1),
            'L_7DG_2': bool(N_L_7DG_2),
            'L_7DG_3': bool(N_L_7DG_3),
            'L_7DG_4': bool(N_L_7DG_4),
            'M_7DG': bool(N_M_7DG),
            'F_7DG': bool(N_F_7DG),
            'U_7DG': bool(N_U_7DG),
            'P_7DG': bool(N_P_7DG),
            'D_7DG': bool(N_D_7DG),
            'K_9_15DG': bool(N_K_9_15DG),
            'L_9_15DG_1': bool(N_L_9_15DG_1),
            'L_9_15DG_2': bool(N_L_9_15DG_2),
            'L_9_15DG_3': bool(N_L_9_15DG_3),
            'L_9_15DG_4': bool(N_L_9_15DG_4),
            'L_9_15DG_5': bool(N_L_9_15DG_5),
            'L_9_15DG_6': bool(N_L_9_15DG_6),
            'M_9_15DG': bool(N_M_9_15DG),
            'F_9_15DG': bool(N_F_9_15DG),
            'U_9_15DG': bool(N_U_9_15DG),
            'P_9_15DG': bool(N_P_9_15DG),
            'D_9_15DG': bool(N_D_9_15DG),
            'K_IAG': bool(N_K_IAG),
            'L_IAG_1': bool(N_L_IAG_1),
            'L_IAG_2': bool(N_L_IAG_2),
            'M_IAG': bool(N_M_IAG),
            'F_IAG': bool(N_F_IAG),
            'U_IAG': bool(N_U_IAG),
            'P_IAG': bool(N_P_IAG),
            'D_IAG': bool(N_D_IAG),
            'K_IG': bool(N_K_IG),
            'L_IG_1': bool(N_L_IG_1),
            'M_IG': bool(N_M_IG),
            'F_IG': bool(N_F_IG),
            'U_IG': bool(N_U_IG),
            'P_IG': bool(N_P_IG),
            'D_IG': bool(N_D_IG),
            'K_IIAG': bool(N_K_IIAG),
            'L_IIAG_1': bool(N_L_IIAG_1),
            'M_IIAG': bool(N_M_IIAG),
            'F_IIAG': bool(N_F_IIAG),
            'U_IIAG': bool(N_U_IIAG),
            'P_IIAG': bool(N_P_IIAG),
            'D_IIAG': bool(N_D_IIAG),
            'K_IIG': bool(N_K_IIG),
            'L_IIG_1': bool(N_L_IIG_1),
            'M_IIG': bool(N_M_IIG),
            'F_IIG': bool(N_F_IIG),
            'U_IIG': bool(N_U_IIG),
            'P_IIG': bool(N_P_IIG),
            'D_IIG': bool(N_D_IIG),
            'K_IIIG': bool(N_K_IIIG),
            'L_IIIG_1': bool(N_L_IIIG_1),
            'M_IIIG': bool(N_M_IIIG),
            'F_IIIG': bool(N_F_IIIG),
            'U_IIIG': bool(N_U_IIIG),
            'P_IIIG': bool(N_P_IIIG),
            'D_IIIG': bool(N_D_IIIG),
            'C_S4': bool(N_C_S4),
            'C_S5': bool(N_C_S5),
            'C_SII': bool(N_C_SII),
            'C_SIII': bool(N_C_SIII),
            'C_X': bool(N_C_X),
            'C_XD': bool(N_C_XD),
        }
        CN_1_3 = self.state['CN_1_3']
        CR_1_3 = self.state['CR_1_3']
        CN_13_15 = self.state['CN_13_15']
        CR_13_15 = self.state['CR_13_15']
        CN_17_19 = self.state['CN_17_19']
        CR_17_19 = self.state['CR_17_19']
        CN_21 = self.state['CN_21']
        CR_21 = self.state['CR_21']
        CN_23_25 = self.state['CN_23_25']
        CR_23_25 = self.state['CR_23_25']
        CN_27 = self.state['CN_27']
        CR_27 = self.state['CR_27']
        CN_5_7 = self.state['CN_5_7']
        CR_5_7 = self.state['CR_5_7']
        CN_9_11 = self.state['CN_9_11']
        CR_9_11 = self.state['CR_9_11']
        AL_1_3 = self.state['AL_1_3']
        AL_13_15 = self.state['AL_13_15']
        AL_17_19 = self.state['AL_17_19']
        AL_21 = self.state['AL_21']
        AL_23_25 = self.state['AL_23_25']
        AL_27 = self.state['AL_27']
        AL_5_7 = self.state['AL_5_7']
        AL_9_11 = self.state['AL_9_11']
        TH_1_3 = self.state['TH_1_3']
        TR_1_3 = self.state['TR_1_3']
        TH_13_15 = self.state['TH_13_15']
        TR_13_15 = self.state['TR_13_15']
        TH_17_19 = self.state['TH_17_19']
        TR_17_19 = self.state['TR_17_19']
        TH_21 = self.state['TH_21']
        TR_21 = self.state['TR_21']
        TH_23_25 = self.state['TH_23_25']
        TR_23_25 = self.state['TR_23_25']
        TH_27 = self.state['TH_27']
        TR_27 = self.state['TR_27']
        TH_5_7 = self.state['TH_5_7']
        TR_5_7 = self.state['TR_5_7']
        TH_9_11 = self.state['TH_9_11']
        TR_9_11 = self.state['TR_9_11']
        Z_1_3 = self.state['Z_1_3']
        Z_13_15 = self.state['Z_13_15']
        Z_17_19 = self.state['Z_17_19']
        Z_21 = self.state['Z_21']
        Z_23_25 = self.state['Z_23_25']
        Z_27 = self.state['Z_27']
        Z_5_7 = self.state['Z_5_7']
        Z_9_11 = self.state['Z_9_11']
        SG = self.state['SG']
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
        PA_R17 = self.state['PA_R17']
        S_R17 = self.state['S_R17']
        H_R17 = self.state['H_R17']
        A_R18 = self.state['A_R18']
        B_R18 = self.state['B_R18']
        W_R18 = self.state['W_R18']
        PA_R18 = self.state['PA_R18']
        S_R18 = self.state['S_R18']
        H_R18 = self.state['H_R18']
        A_R19 = self.state['A_R19']
        B_R19 = self.state['B_R19']
        W_R19 = self.state['W_R19']
        PA_R19 = self.state['PA_R19']
        S_R19 = self.state['S_R19']
        H_R19 = self.state['H_R19']
        A_R20 = self.state['A_R20']
        B_R20 = self.state['B_R20']
        W_R20 = self.state['W_R20']
        PA_R20 = self.state['PA_R20']
        S_R20 = self.state['S_R20']
        H_R20 = self.state['H_R20']
        A_R21 = self.state['A_R21']
        B_R21 = self.state['B_R21']
        W_R21 = self.state['W_R21']
        PA_R21 = self.state['PA_R21']
        S_R21 = self.state['S_R21']
        H_R21 = self.state['H_R21']
        A_R22 = self.state['A_R22']
        B_R22 = self.state['B_R22']
        W_R22 = self.state['W_R22']
        S_R22 = self.state['S_R22']
        H_R22 = self.state['H_R22']
        A_R23 = self.state['A_R23']
        B_R23 = self.state['B_R23']
        W_R23 = self.state['W_R23']
        S_R23 = self.state['S_R23']
        H_R23 = self.state['H_R23']
        A_R24 = self.state['A_R24']
        B_R24 = self.state['B_R24']
        W_R24 = self.state['W_R24']
        S_R24 = self.state['S_R24']
        H_R24 = self.state['H_R24']
        A_R25 = self.state['A_R25']
        B_R25 = self.state['B_R25']
        W_R25 = self.state['W_R25']
        S_R25 = self.state['S_R25']
        H_R25 = self.state['H_R25']
        A_R26 = self.state['A_R26']
        B_R26 = self.state['B_R26']
        W_R26 = self.state['W_R26']
        S_R26 = self.state['S_R26']
        H_R26 = self.state['H_R26']
        A_R27 = self.state['A_R27']
        B_R27 = self.state['B_R27']
        W_R27 = self.state['W_R27']
        S_R27 = self.state['S_R27']
        H_R27 = self.state['H_R27']
        A_R28 = self.state['A_R28']
        B_R28 = self.state['B_R28']
        W_R28 = self.state['W_R28']
        S_R28 = self.state['S_R28']
        H_R28 = self.state['H_R28']
        A_R29 = self.state['A_R29']
        B_R29 = self.state['B_R29']
        W_R29 = self.state['W_R29']
        S_R29 = self.state['S_R29']
        H_R29 = self.state['H_R29']
        A_R30 = self.state['A_R30']
        B_R30 = self.state['B_R30']
        W_R30 = self.state['W_R30']
        S_R30 = self.state['S_R30']
        H_R30 = self.state['H_R30']
        A_R31 = self.state['A_R31']
        B_R31 = self.state['B_R31']
        W_R31 = self.state['W_R31']
        S_R31 = self.state['S_R31']
        H_R31 = self.state['H_R31']
        A_R32 = self.state['A_R32']
        B_R32 = self.state['B_R32']
        W_R32 = self.state['W_R32']
        S_R32 = self.state['S_R32']
        H_R32 = self.state['H_R32']
        A_R33 = self.state['A_R33']
        B_R33 = self.state['B_R33']
        W_R33 = self.state['W_R33']
        S_R33 = self.state['S_R33']
        H_R33 = self.state['H_R33']
        A_R34 = self.state['A_R34']
        B_R34 = self.state['B_R34']
        W_R34 = self.state['W_R34']
        S_R34 = self.state['S_R34']
        H_R34 = self.state['H_R34']
        A_R35 = self.state['A_R35']
        B_R35 = self.state['B_R35']
        W_R35 = self.state['W_R35']
        S_R35 = self.state['S_R35']
        H_R35 = self.state['H_R35']
        A_R36 = self.state['A_R36']
        B_R36 = self.state['B_R36']
        W_R36 = self.state['W_R36']
        S_R36 = self.state['S_R36']
        H_R36 = self.state['H_R36']
        A_R37 = self.state['A_R37']
        B_R37 = self.state['B_R37']
        W_R37 = self.state['W_R37']
        S_R37 = self.state['S_R37']
        H_R37 = self.state['H_R37']
        A_R38 = self.state['A_R38']
        B_R38 = self.state['B_R38']
        W_R38 = self.state['W_R38']
        S_R38 = self.state['S_R38']
        H_R38 = self.state['H_R38']
        A_R39 = self.state['A_R39']
        B_R39 = self.state['B_R39']
        W_R39 = self.state['W_R39']
        S_R39 = self.state['S_R39']
        H_R39 = self.state['H_R39']
        A_R40 = self.state['A_R40']
        B_R40 = self.state['B_R40']
        W_R40 = self.state['W_R40']
        S_R40 = self.state['S_R40']
        H_R40 = self.state['H_R40']
        A_R41 = self.state['A_R41']
        B_R41 = self.state['B_R41']
        W_R41 = self.state['W_R41']
        S_R41 = self.state['S_R41']
        H_R41 = self.state['H_R41']
        A_R42 = self.state['A_R42']
        B_R42 = self.state['B_R42']
        W_R42 = self.state['W_R42']
        S_R42 = self.state['S_R42']
        H_R42 = self.state['H_R42']
        A_R43 = self.state['A_R43']
        B_R43 = self.state['B_R43']
        W_R43 = self.state['W_R43']
        S_R43 = self.state['S_R43']
        H_R43 = self.state['H_R43']
        A_R44 = self.state['A_R44']
        B_R44 = self.state['B_R44']
        W_R44 = self.state['W_R44']
        S_R44 = self.state['S_R44']
        H_R44 = self.state['H_R44']
        A_R45 = self.state['A_R45']
        B_R45 = self.state['B_R45']
        W_R45 = self.state['W_R45']
        S_R45 = self.state['S_R45']
        H_R45 = self.state['H_R45']
        A_R46 = self.state['A_R46']
        B_R46 = self.state['B_R46']
        W_R46 = self.state['W_R46']
        S_R46 = self.state['S_R46']
        H_R46 = self.state['H_R46']
        A_R47 = self.state['A_R47']
        B_R47 = self.state['B_R47']
        W_R47 = self.state['W_R47']
        S_R47 = self.state['S_R47']
        H_R47 = self.state['H_R47']
        A_R48 = self.state['A_R48']
        B_R48 = self.state['B_R48']
        W_R48 = self.state['W_R48']
        S_R48 = self.state['S_R48']
        H_R48 = self.state['H_R48']
        A_R49 = self.state['A_R49']
        B_R49 = self.state['B_R49']
        W_R49 = self.state['W_R49']
        S_R49 = self.state['S_R49']
        H_R49 = self.state['H_R49']
        A_R50 = self.state['A_R50']
        B_R50 = self.state['B_R50']
        W_R50 = self.state['W_R50']
        S_R50 = self.state['S_R50']
        H_R50 = self.state['H_R50']
        A_R51 = self.state['A_R51']
        B_R51 = self.state['B_R51']
        W_R51 = self.state['W_R51']
        S_R51 = self.state['S_R51']
        H_R51 = self.state['H_R51']
        A_R52 = self.state['A_R52']
        B_R52 = self.state['B_R52']
        W_R52 = self.state['W_R52']
        S_R52 = self.state['S_R52']
        H_R52 = self.state['H_R52']
        A_R53 = self.state['A_R53']
        B_R53 = self.state['B_R53']
        W_R53 = self.state['W_R53']
        S_R53 = self.state['S_R53']
        H_R53 = self.state['H_R53']
        A_R54 = self.state['A_R54']
        B_R54 = self.state['B_R54']
        W_R54 = self.state['W_R54']
        S_R54 = self.state['S_R54']
        H_R54 = self.state['H_R54']
        A_R55 = self.state['A_R55']
        B_R55 = self.state['B_R55']
        W_R55 = self.state['W_R55']
        S_R55 = self.state['S_R55']
        H_R55 = self.state['H_R55']
        A_R56 = self.state['A_R56']
        B_R56 = self.state['B_R56']
        W_R56 = self.state['W_R56']
        S_R56 = self.state['S_R56']
        H_R56 = self.state['H_R56']
        A_R57 = self.state['A_R57']
        B_R57 = self.state['B_R57']
        W_R57 = self.state['W_R57']
        S_R57 = self.state['S_R57']
        H_R57 = self.state['H_R57']
        A_R58 = self.state['A_R58']
        B_R58 = self.state['B_R58']
        W_R58 = self.state['W_R58']
        S_R58 = self.state['S_R58']
        H_R58 = self.state['H_R58']
        A_R59 = self.state['A_R59']
        B_R59 = self.state['B_R59']
        W_R59 = self.state['W_R59']
        S_R59 = self.state['S_R59']
        H_R59 = self.state['H_R59']
        A_R60 = self.state['A_R60']
        B_R60 = self.state['B_R60']
        W_R60 = self.state['W_R60']
        S_R60 = self.state['S_R60']
        H_R60 = self.state['H_R60']
        A_R61 = self.state['A_R61']
        B_R61 = self.state['B_R61']
        W_R61 = self.state['W_R61']
        S_R61 = self.state['S_R61']
        H_R61 = self.state['H_R61']
        A_R62 = self.state['A_R62']
        B_R62 = self.state['B_R62']
        W_R62 = self.state['W_R62']
        S_R62 = self.state['S_R62']
        H_R62 = self.state['H_R62']
        A_R63 = self.state['A_R63']
        B_R63 = self.state['B_R63']
        W_R63 = self.state['W_R63']
        S_R63 = self.state['S_R63']
        H_R63 = self.state['H_R63']
        A_R64 = self.state['A_R64']
        B_R64 = self.state['B_R64']
        W_R64 = self.state['W_R64']
        S_R64 = self.state['S_R64']
        H_R64 = self.state['H_R64']
        A_R65 = self.state['A_R65']
        B_R65 = self.state['B_R65']
        W_R65 = self.state['W_R65']
        S_R65 = self.state['S_R65']
        H_R65 = self.state['H_R65']
        A_R66 = self.state['A_R66']
        B_R66 = self.state['B_R66']
        W_R66 = self.state['W_R66']
        S_R66 = self.state['S_R66']
        H_R66 = self.state['H_R66']
        A_R67 = self.state['A_R67']
        B_R67 = self.state['B_R67']
        W_R67 = self.state['W_R67']
        S_R67 = self.state['S_R67']
        H_R67 = self.state['H_R67']
        A_R68 = self.state['A_R68']
        B_R68 = self.state['B_R68']
        W_R68 = self.state['W_R68']
        S_R68 = self.state['S_R68']
        H_R68 = self.state['H_R68']
        A_R69 = self.state['A_R69']
        B_R69 = self.state['B_R69']
        W_R69 = self.state['W_R69']
        S_R69 = self.state['S_R69']
        H_R69 = self.state['H_R69']
        A_R70 = self.state['A_R70']
        B_R70 = self.state['B_R70']
        W_R70 = self.state['W_R70']
        S_R70 = self.state['S_R70']
        H_R70 = self.state['H_R70']
        A_R71 = self.state['A_R71']
        B_R71 = self.state['B_R71']
        W_R71 = self.state['W_R71']
        S_R71 = self.state['S_R71']
        H_R71 = self.state['H_R71']
        A_R72 = self.state['A_R72']
        B_R72 = self.state['B_R72']
        W_R72 = self.state['W_R72']
        S_R72 = self.state['S_R72']
        H_R72 = self.state['H_R72']
        A_R73 = self.state['A_R73']
        B_R73 = self.state['B_R73']
        W_R73 = self.state['W_R73']
        S_R73 = self.state['S_R73']
        H_R73 = self.state['H_R73']
        A_R74 = self.state['A_R74']
        B_R74 = self.state['B_R74']
        W_R74 = self.state['W_R74']
        S_R74 = self.state['S_R74']
        H_R74 = self.state['H_R74']
        A_R75 = self.state['A_R75']
        B_R75 = self.state['B_R75']
        W_R75 = self.state['W_R75']
        S_R75 = self.state['S_R75']
        H_R75 = self.state['H_R75']
        X_D1 = self.state['X_D1']
        X_D11 = self.state['X_D11']
        X_D13 = self.state['X_D13']
        X_D15 = self.state['X_D15']
        X_D17 = self.state['X_D17']
        X_D3 = self.state['X_D3']
        X_D5 = self.state['X_D5']
        X_D7 = self.state['X_D7']
        X_D9 = self.state['X_D9']
        X_S4 = self.state['X_S4']
        X_S5 = self.state['X_S5']
        X_SII = self.state['X_SII']
        X_SIII = self.state['X_SIII']
        X_X = self.state['X_X']
        X_XD = self.state['X_XD']
        N_R2 = self.state['N_R2']
        T_R2 = self.state['T_R2']
        N_R7 = self.state['N_R7']
        T_R7 = self.state['T_R7']
        N_R20 = self.state['N_R20']
        T_R20 = self.state['T_R20']
        K_1_19WG = self.state['K_1_19WG']
        L_1_19WG_1 = self.state['L_1_19WG_1']
        L_1_19WG_2 = self.state['L_1_19WG_2']
        M_1_19WG = self.state['M_1_19WG']
        F_1_19WG = self.state['F_1_19WG']
        U_1_19WG = self.state['U_1_19WG']
        P_1_19WG = self.state['P_1_19WG']
        D_1_19WG = self.state['D_1_19WG']
        K_11_13DG = self.state['K_11_13DG']
        L_11_13DG_1 = self.state['L_11_13DG_1']
        L_11_13DG_2 = self.state['L_11_13DG_2']
        L_11_13DG_3 = self.state['L_11_13DG_3']
        L_11_13DG_4 = self.state['L_11_13DG_4']
        L_11_13DG_5 = self.state['L_11_13DG_5']
        L_11_13DG_6 = self.state['L_11_13DG_6']
        M_11_13DG = self.state['M_11_13DG']
        F_11_13DG = self.state['F_11_13DG']
        U_11_13DG = self.state['U_11_13DG']
        P_11_13DG = self.state['P_11_13DG']
        D_11_13DG = self.state['D_11_13DG']
        K_17_23DG = self.state['K_17_23DG']
        L_17_23DG_1 = self.state['L_17_23DG_1']
        L_17_23DG_2 = self.state['L_17_23DG_2']
        L_17_23DG_3 = self.state['L_17_23DG_3']
        L_17_23DG_4 = self.state['L_17_23DG_4']
        L_17_23DG_5 = self.state['L_17_23DG_5']
        L_17_23DG_6 = self.state['L_17_23DG_6']
        M_17_23DG = self.state['M_17_23DG']
        F_17_23DG = self.state['F_17_23DG']
        U_17_23DG = self.state['U_17_23DG']
        P_17_23DG = self.state['P_17_23DG']
        D_17_23DG = self.state['D_17_23DG']
        K_19_27DG = self.state['K_19_27DG']
        L_19_27DG_1 = self.state['L_19_27DG_1']
        L_19_27DG_2 = self.state['L_19_27DG_2']
        L_19_27DG_3 = self.state['L_19_27DG_3']
        L_19_27DG_4 = self.state['L_19_27DG_4']
        L_19_27DG_5 = self.state['L_19_27DG_5']
        L_19_27DG_6 = self.state['L_19_27DG_6']
        L_19_27DG_7 = self.state['L_19_27DG_7']
        L_19_27DG_8 = self.state['L_19_27DG_8']
        M_19_27DG = self.state['M_19_27DG']
        F_19_27DG = self.state['F_19_27DG']
        U_19_27DG = self.state['U_19_27DG']
        P_19_27DG = self.state['P_19_27DG']
        D_19_27DG = self.state['D_19_27DG']
        K_1DG = self.state['K_1DG']
        L_1DG_1 = self.state['L_1DG_1']
        L_1DG_2 = self.state['L_1DG_2']
        L_1DG_3 = self.state['L_1DG_3']
        L_1DG_4 = self.state['L_1DG_4']
        M_1DG = self.state['M_1DG']
        F_1DG = self.state['F_1DG']
        U_1DG = self.state['U_1DG']
        P_1DG = self.state['P_1DG']
        D_1DG = self.state['D_1DG']
        K_21DG = self.state['K_21DG']
        L_21DG_1 = self.state['L_21DG_1']
        L_21DG_2 = self.state['L_21DG_2']
        L_21DG_3 = self.state['L_21DG_3']
        L_21DG_4 = self.state['L_21DG_4']
        M_21DG = self.state['M_21DG']
        F_21DG = self.state['F_21DG']
        U_21DG = self.state['U_21DG']
        P_21DG = self.state['P_21DG']
        D_21DG = self.state['D_21DG']
        K_25DG = self.state['K_25DG']
        L_25DG_1 = self.state['L_25DG_1']
        L_25DG_2 = self.state['L_25DG_2']
        L_25DG_3 = self.state['L_25DG_3']
        L_25DG_4 = self.state['L_25DG_4']
        M_25DG = self.state['M_25DG']
        F_25DG = self.state['F_25DG']
        U_25DG = self.state['U_25DG']
        P_25DG = self.state['P_25DG']
        D_25DG = self.state['D_25DG']
        K_3DG = self.state['K_3DG']
        L_3DG_1 = self.state['L_3DG_1']
        L_3DG_2 = self.state['L_3DG_2']
        L_3DG_3 = self.state['L_3DG_3']
        L_3DG_4 = self.state['L_3DG_4']
        M_3DG = self.state['M_3DG']
        F_3DG = self.state['F_3DG']
        U_3DG = self.state['U_3DG']
        P_3DG = self.state['P_3DG']
        D_3DG = self.state['D_3DG']
        K_4G = self.state['K_4G']
        L_4G_1 = self.state['L_4G_1']
        M_4G = self.state['M_4G']
        F_4G = self.state['F_4G']
        U_4G = self.state['U_4G']
        P_4G = self.state['P_4G']
        D_4G = self.state['D_4G']
        K_5DG = self.state['K_5DG']
        L_5DG_1 = self.state['L_5DG_1']
        L_5DG_2 = self.state['L_5DG_2']
        L_5DG_3 = self.state['L_5DG_3']
        L_5DG_4 = self.state['L_5DG_4']
        M_5DG = self.state['M_5DG']
        F_5DG = self.state['F_5DG']
        U_5DG = self.state['U_5DG']
        P_5DG = self.state['P_5DG']
        D_5DG = self.state['D_5DG']
        K_5G = self.state['K_5G']
        L_5G_1 = self.state['L_5G_1']
        M_5G = self.state['M_5G']
        F_5G = self.state['F_5G']
        U_5G = self.state['U_5G']
        P_5G = self.state['P_5G']
        D_5G = self.state['D_5G']
        K_7DG = self.state['K_7DG']
        L_7DG_1 = self.state['L_7DG_1']
        L_7DG_2 = self.state['L_7DG_2']
        L_7DG_3 = self.state['L_7DG_3']
        L_7DG_4 = self.state['L_7DG_4']
        M_7DG = self.state['M_7DG']
        F_7DG = self.state['F_7DG']
        U_7DG = self.state['U_7DG']
        P_7DG = self.state['P_7DG']
        D_7DG = self.state['D_7DG']
        K_9_15DG = self.state['K_9_15DG']
        L_9_15DG_1 = self.state['L_9_15DG_1']
        L_9_15DG_2 = self.state['L_9_15DG_2']
        L_9_15DG_3 = self.state['L_9_15DG_3']
        L_9_15DG_4 = self.state['L_9_15DG_4']
        L_9_15DG_5 = self.state['L_9_15DG_5']
        L_9_15DG_6 = self.state['L_9_15DG_6']
        M_9_15DG = self.state['M_9_15DG']
        F_9_15DG = self.state['F_9_15DG']
        U_9_15DG = self.state['U_9_15DG']
        P_9_15DG = self.state['P_9_15DG']
        D_9_15DG = self.state['D_9_15DG']
        K_IAG = self.state['K_IAG']
        L_IAG_1 = self.state['L_IAG_1']
        L_IAG_2 = self.state['L_IAG_2']
        M_IAG = self.state['M_IAG']
        F_IAG = self.state['F_IAG']
        U_IAG = self.state['U_IAG']
        P_IAG = self.state['P_IAG']
        D_IAG = self.state['D_IAG']
        K_IG = self.state['K_IG']
        L_IG_1 = self.state['L_IG_1']
        M_IG = self.state['M_IG']
        F_IG = self.state['F_IG']
        U_IG = self.state['U_IG']
        P_IG = self.state['P_IG']
        D_IG = self.state['D_IG']
        K_IIAG = self.state['K_IIAG']
        L_IIAG_1 = self.state['L_IIAG_1']
        M_IIAG = self.state['M_IIAG']
        F_IIAG = self.state['F_IIAG']
        U_IIAG = self.state['U_IIAG']
        P_IIAG = self.state['P_IIAG']
        D_IIAG = self.state['D_IIAG']
        K_IIG = self.state['K_IIG']
        L_IIG_1 = self.state['L_IIG_1']
        M_IIG = self.state['M_IIG']
        F_IIG = self.state['F_IIG']
        U_IIG = self.state['U_IIG']
        P_IIG = self.state['P_IIG']
        D_IIG = self.state['D_IIG']
        K_IIIG = self.state['K_IIIG']
        L_IIIG_1 = self.state['L_IIIG_1']
        M_IIIG = self.state['M_IIIG']
        F_IIIG = self.state['F_IIIG']
        U_IIIG = self.state['U_IIIG']
        P_IIIG = self.state['P_IIIG']
        D_IIIG = self.state['D_IIIG']
        C_S4 = self.state['C_S4']
        C_S5 = self.state['C_S5']
        C_SII = self.state['C_SII']
        C_SIII = self.state['C_SIII']
        C_X = self.state['C_X']
        C_XD = self.state['C_XD']
        return {
            'YN_1_3': bool(CN_1_3 and Z_1_3),
            'YR_1_3': bool(CR_1_3 and Z_1_3),
            'YN_13_15': bool(CN_13_15 and Z_13_15),
            'YR_13_15': bool(CR_13_15 and Z_13_15),
            'YN_17_19': bool(CN_17_19 and Z_17_19),
            'YR_17_19': bool(CR_17_19 and Z_17_19),
            'YN_21': bool(CN_21 and Z_21),
            'YR_21': bool(CR_21 and Z_21),
            'YN_23_25': bool(CN_23_25 and Z_23_25),
            'YR_23_25': bool(CR_23_25 and Z_23_25),
            'YN_27': bool(CN_27 and Z_27),
            'YR_27': bool(CR_27 and Z_27),
            'YN_5_7': bool(CN_5_7 and Z_5_7),
            'YR_5_7': bool(CR_5_7 and Z_5_7),
            'YN_9_11': bool(CN_9_11 and Z_9_11),
            'YR_9_11': bool(CR_9_11 and Z_9_11),
            'YA_1_3': bool(AL_1_3),
            'YA_13_15': bool(AL_13_15),
            'YA_17_19': bool(AL_17_19),
            'YA_21': bool(AL_21),
            'YA_23_25': bool(AL_23_25),
            'YA_27': bool(AL_27),
            'YA_5_7': bool(AL_5_7),
            'YA_9_11': bool(AL_9_11),
            'YT_1_3': bool(TR_1_3),
            'YT_13_15': bool(TR_13_15),
            'YT_17_19': bool(TR_17_19),
            'YT_21': bool(TR_21),
            'YT_23_25': bool(TR_23_25),
            'YT_27': bool(TR_27),
            'YT_5_7': bool(TR_5_7),
            'YT_9_11': bool(TR_9_11),
            'YL_1_19WG': bool(K_1_19WG or L_1_19WG_1 or L_1_19WG_2),
            'YL_11_13DG': bool(K_11_13DG or L_11_13DG_1 or L_11_13DG_2 or L_11_13DG_3 or L_11_13DG_4 or L_11_13DG_5 or L_11_13DG_6),
            'YL_17_23DG': bool(K_17_23DG or L_17_23DG_1 or L_17_23DG_2 or L_17_23DG_3 or L_17_23DG_4 or L_17_23DG_5 or L_17_23DG_6),
            'YL_19_27DG': bool(K_19_27DG or L_19_27DG_1 or L_19_27DG_2 or L_19_27DG_3 or L_19_27DG_4 or L_19_27DG_5 or L_19_27DG_6 or L_19_27DG_7 or L_19_27DG_8),
            'YL_1DG': bool(K_1DG or L_1DG_1 or L_1DG_2 or L_1DG_3 or L_1DG_4),
            'YL_21DG': bool(K_21DG or L_21DG_1 or L_21DG_2 or L_21DG_3 or L_21DG_4),
            'YL_25DG': bool(K_25DG or L_25DG_1 or L_25DG_2 or L_25DG_3 or L_25DG_4),
            'YL_3DG': bool(K_3DG or L_3DG_1 or L_3DG_2 or L_3DG_3 or L_3DG_4),
            'YL_4G': bool(K_4G or L_4G_1),
            'YL_5DG': bool(K_5DG or L_5DG_1 or L_5DG_2 or L_5DG_3 or L_5DG_4),
            'YL_5G': bool(K_5G or L_5G_1),
            'YL_7DG': bool(K_7DG or L_7DG_1 or L_7DG_2 or L_7DG_3 or L_7DG_4),
            'YL_9_15DG': bool(K_9_15DG or L_9_15DG_1 or L_9_15DG_2 or L_9_15DG_3 or L_9_15DG_4 or L_9_15DG_5 or L_9_15DG_6),
            'YL_IAG': bool(K_IAG or L_IAG_1 or L_IAG_2),
            'YL_IG': bool(K_IG or L_IG_1),
            'YL_IIAG': bool(K_IIAG or L_IIAG_1),
            'YL_IIG': bool(K_IIG or L_IIG_1),
            'YL_IIIG': bool(K_IIIG or L_IIIG_1),
            'YW_D1': bool(S_R1 or S_R2),
            'YS_D1': bool((not (S_R1 or S_R2))),
            'YW_D11': bool(S_R3 or S_R4 or S_R5 or PA_R3 or PA_R4 or PA_R5),
            'YS_D11': bool((not (S_R3 or S_R4 or S_R5 or PA_R3 or PA_R4 or PA_R5))),
            'YW_D13': bool(S_R6 or S_R7 or S_R8 or S_R9 or PA_R6 or PA_R7 or PA_R8 or PA_R9),
            'YS_D13': bool((not (S_R6 or S_R7 or S_R8 or S_R9 or PA_R6 or PA_R7 or PA_R8 or PA_R9))),
            'YW_D15': bool(S_R10 or S_R11),
            'YS_D15': bool((not (S_R10 or S_R11))),
            'YW_D17': bool(S_R12 or S_R13),
            'YS_D17': bool((not (S_R12 or S_R13))),
            'YW_D3': bool(S_R14 or S_R15),
            'YS_D3': bool((not (S_R14 or S_R15))),
            'YW_D5': bool(S_R16),
            'YS_D5': bool((not S_R16)),
            'YW_D7': bool(S_R17 or S_R18 or PA_R17 or PA_R18),
            'YS_D7': bool((not (S_R17 or S_R18 or PA_R17 or PA_R18))),
            'YW_D9': bool(S_R19 or S_R20 or S_R21 or PA_R19 or PA_R20 or PA_R21),
            'YS_D9': bool((not (S_R19 or S_R20 or S_R21 or PA_R19 or PA_R20 or PA_R21))),
            'YP_S4': bool(C_S4),
            'YY_S4': bool((S_R22 or S_R23 or S_R24) and (not C_S4)),
            'YW_S4': bool(S_R25 or S_R26 or S_R27),
            'YS_S4': bool((not (S_R22 or S_R23 or S_R24 or S_R25 or S_R26 or S_R27))),
            'YP_S5': bool(C_S5),
            'YY_S5': bool((S_R28 or S_R29) and (not C_S5)),
            'YW_S5': bool(S_R30 or S_R31),
            'YS_S5': bool((not (S_R28 or S_R29 or S_R30 or S_R31))),
            'YP_SII': bool(C_SII),
            'YY_SII': bool((S_R32 or S_R33 or S_R34) and (not C_SII)),
            'YW_SII': bool(S_R35 or S_R36 or S_R37),
            'YS_SII': bool((not (S_R32 or S_R33 or S_R34 or S_R35 or S_R36 or S_R37))),
            'YP_SIII': bool(C_SIII),
            'YY_SIII': bool((S_R38 or S_R39 or S_R40 or S_R41) and (not C_SIII)),
            'YW_SIII': bool(S_R42 or S_R43 or S_R44 or S_R45),
            'YS_SIII': bool((not (S_R38 or S_R39 or S_R40 or S_R41 or S_R42 or S_R43 or S_R44 or S_R45))),
            'YP_X': bool(C_X),
            'YY_X': bool((S_R46 or S_R47 or S_R48 or S_R49 or S_R50 or S_R51 or S_R52 or S_R53 or S_R54 or S_R55) and (not C_X)),
            'YO_X': bool(S_R56 or S_R57 or S_R58 or S_R59 or S_R60 or S_R61 or S_R62 or S_R63 or S_R64 or S_R65),
            'YS_X': bool((not (S_R46 or S_R47 or S_R48 or S_R49 or S_R50 or S_R51 or S_R52 or S_R53 or S_R54 or S_R55))),
            'YP_XD': bool(C_XD),
            'YY_XD': bool((S_R66 or S_R67 or S_R68 or S_R69 or S_R70) and (not C_XD)),
            'YO_XD': bool(S_R71 or S_R72 or S_R73 or S_R74 or S_R75),
            'YS_XD': bool((not (S_R66 or S_R67 or S_R68 or S_R69 or S_R70))),
        }
