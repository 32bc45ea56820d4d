# Interlocking slip_junction, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout ae8b90778b1b5deb9c15917108fd682e755bf21252f31ec3957b575445c837f9
# claims 38114b333f3c5162cd598ee2e8142a206e0105f79fb17c050fdef27d2b790d58
"""Interlocking slip_junction: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_G2': (0, 2),  # operator: cancel the route from G2
    'CAN_G3': (0, 2),  # operator: cancel the route from G3
    'CAN_S1': (0, 2),  # operator: cancel the route from S1
    'CAN_S1J': (0, 2),  # operator: cancel the route from S1J
    'CAN_S2': (0, 2),  # operator: cancel the route from S2
    'CAN_S2J': (0, 2),  # operator: cancel the route from S2J
    'CAN_S4': (0, 2),  # operator: cancel the route from S4
    'CAN_S4J': (0, 2),  # operator: cancel the route from S4J
    'CAN_SG': (0, 2),  # operator: cancel the route from SG
    'CAN_SGJ': (0, 2),  # operator: cancel the route from SGJ
    'REQ': (0, 21),  # operator: set route number, 0 = none
    'CLR_AA': (0, 2),  # section AA reported clear
    'CLR_AB': (0, 2),  # section AB reported clear
    'CLR_AC': (0, 2),  # section AC reported clear
    'CLR_AD': (0, 2),  # section AD reported clear
    'CLR_BA': (0, 2),  # section BA reported clear
    'CLR_BB': (0, 2),  # section BB reported clear
    'CLR_BC': (0, 2),  # section BC reported clear
    'CLR_BD': (0, 2),  # section BD reported clear
    'CLR_BE': (0, 2),  # section BE reported clear
    'CLR_CA': (0, 2),  # section CA reported clear
    'CLR_CB': (0, 2),  # section CB reported clear
    'CLR_CD': (0, 2),  # section CD reported clear
    'CLR_GA': (0, 2),  # section GA reported clear
    'CLR_GB': (0, 2),  # section GB reported clear
    'CLR_GX': (0, 2),  # section GX reported clear
    'CLR_SC': (0, 2),  # section SC reported clear
    'REL_AB': (0, 2),  # operator: release section AB (hold until released)
    'REL_AC': (0, 2),  # operator: release section AC (hold until released)
    'REL_AD': (0, 2),  # operator: release section AD (hold until released)
    'REL_BB': (0, 2),  # operator: release section BB (hold until released)
    'REL_BC': (0, 2),  # operator: release section BC (hold until released)
    'REL_BD': (0, 2),  # operator: release section BD (hold until released)
    'REL_BE': (0, 2),  # operator: release section BE (hold until released)
    'REL_CB': (0, 2),  # operator: release section CB (hold until released)
    'REL_CD': (0, 2),  # operator: release section CD (hold until released)
    'REL_GA': (0, 2),  # operator: release section GA (hold until released)
    'REL_GB': (0, 2),  # operator: release section GB (hold until released)
    'REL_SC': (0, 2),  # operator: release section SC (hold until released)
    'BLK_AB': (1, 2),  # operator: section AB is blocked
    'BLK_AC': (1, 2),  # operator: section AC is blocked
    'BLK_AD': (1, 2),  # operator: section AD is blocked
    'BLK_BB': (1, 2),  # operator: section BB is blocked
    'BLK_BC': (1, 2),  # operator: section BC is blocked
    'BLK_BD': (1, 2),  # operator: section BD is blocked
    'BLK_BE': (1, 2),  # operator: section BE is blocked
    'BLK_CB': (1, 2),  # operator: section CB is blocked
    'BLK_CD': (1, 2),  # operator: section CD is blocked
    'BLK_GA': (1, 2),  # operator: section GA is blocked
    'BLK_GB': (1, 2),  # operator: section GB is blocked
    'BLK_SC': (1, 2),  # operator: section SC is blocked
    'RELALL': (0, 2),  # operator: release all clear sections after a restart
    'DN_101': (0, 2),  # machine 101 detected normal
    'DR_101': (0, 2),  # machine 101 detected reverse
    'MN_101': (0, 2),  # operator: move machine 101 normal
    'MR_101': (0, 2),  # operator: move machine 101 reverse
    'TC_101': (0, 2),  # operator: machine 101 has been looked at after it was trailed
    'DN_102': (0, 2),  # machine 102 detected normal
    'DR_102': (0, 2),  # machine 102 detected reverse
    'MN_102': (0, 2),  # operator: move machine 102 normal
    'MR_102': (0, 2),  # operator: move machine 102 reverse
    'TC_102': (0, 2),  # operator: machine 102 has been looked at after it was trailed
    'DN_201a': (0, 2),  # machine 201a detected normal
    'DR_201a': (0, 2),  # machine 201a detected reverse
    'MN_201a': (0, 2),  # operator: move machine 201a normal
    'MR_201a': (0, 2),  # operator: move machine 201a reverse
    'TC_201a': (0, 2),  # operator: machine 201a has been looked at after it was trailed
    'DN_201b': (0, 2),  # machine 201b detected normal
    'DR_201b': (0, 2),  # machine 201b detected reverse
    'MN_201b': (0, 2),  # operator: move machine 201b normal
    'MR_201b': (0, 2),  # operator: move machine 201b reverse
    'TC_201b': (0, 2),  # operator: machine 201b has been looked at after it was trailed
    'DN_210a': (0, 2),  # machine 210a detected normal
    'DR_210a': (0, 2),  # machine 210a detected reverse
    'MN_210a': (0, 2),  # operator: move machine 210a normal
    'MR_210a': (0, 2),  # operator: move machine 210a reverse
    'TC_210a': (0, 2),  # operator: machine 210a has been looked at after it was trailed
    'DN_210b': (0, 2),  # machine 210b detected normal
    'DR_210b': (0, 2),  # machine 210b detected reverse
    'MN_210b': (0, 2),  # operator: move machine 210b normal
    'MR_210b': (0, 2),  # operator: move machine 210b reverse
    'TC_210b': (0, 2),  # operator: machine 210b has been looked at after it was trailed
}
# name: value at a restart, meaning
STATE = {
    'CN_101': False,  # machine 101 commanded N
    'CR_101': False,  # machine 101 commanded R
    'CN_102': False,  # machine 102 commanded N
    'CR_102': False,  # machine 102 commanded R
    'CN_201a': False,  # machine 201a commanded N
    'CR_201a': False,  # machine 201a commanded R
    'CN_201b': False,  # machine 201b commanded N
    'CR_201b': False,  # machine 201b commanded R
    'CN_210a': False,  # machine 210a commanded N
    'CR_210a': False,  # machine 210a commanded R
    'CN_210b': False,  # machine 210b commanded N
    'CR_210b': False,  # machine 210b commanded R
    'AL_101': False,  # alarm: machine 101 not detected
    'AL_102': False,  # alarm: machine 102 not detected
    'AL_201a': False,  # alarm: machine 201a not detected
    'AL_201b': False,  # alarm: machine 201b not detected
    'AL_210a': False,  # alarm: machine 210a not detected
    'AL_210b': False,  # alarm: machine 210b not detected
    'TH_101': False,  # machine 101 was detected where it is commanded
    'TR_101': False,  # machine 101 was trailed
    'TH_102': False,  # machine 102 was detected where it is commanded
    'TR_102': False,  # machine 102 was trailed
    'TH_201a': False,  # machine 201a was detected where it is commanded
    'TR_201a': False,  # machine 201a was trailed
    'TH_201b': False,  # machine 201b was detected where it is commanded
    'TR_201b': False,  # machine 201b was trailed
    'TH_210a': False,  # machine 210a was detected where it is commanded
    'TR_210a': False,  # machine 210a was trailed
    'TH_210b': False,  # machine 210b was detected where it is commanded
    'TR_210b': False,  # machine 210b was trailed
    'A_R1': False,  # route G2-G3 active
    'B_R1': False,  # route G2-G3 locked
    'W_R1': False,  # route G2-G3: proceed wanted
    'S_R1': False,  # route G2-G3: proceed
    'H_R1': False,  # route G2-G3: signal has been open
    'A_R2': False,  # route G3-G active
    'B_R2': False,  # route G3-G locked
    'W_R2': False,  # route G3-G: proceed wanted
    'S_R2': False,  # route G3-G: proceed
    'H_R2': False,  # route G3-G: signal has been open
    'A_R3': False,  # route S1-S1J active
    'B_R3': False,  # route S1-S1J locked
    'W_R3': False,  # route S1-S1J: proceed wanted
    'S_R3': False,  # route S1-S1J: proceed
    'H_R3': False,  # route S1-S1J: signal has been open
    'A_R4': False,  # route S1J-DB active
    'B_R4': False,  # route S1J-DB locked
    'W_R4': False,  # route S1J-DB: proceed wanted
    'S_R4': False,  # route S1J-DB: proceed
    'H_R4': False,  # route S1J-DB: signal has been open
    'A_R5': False,  # route S1J-DM2 active
    'B_R5': False,  # route S1J-DM2 locked
    'W_R5': False,  # route S1J-DM2: proceed wanted
    'S_R5': False,  # route S1J-DM2: proceed
    'H_R5': False,  # route S1J-DM2: signal has been open
    'A_R6': False,  # route S1J-GN active
    'B_R6': False,  # route S1J-GN locked
    'W_R6': False,  # route S1J-GN: proceed wanted
    'S_R6': False,  # route S1J-GN: proceed
    'H_R6': False,  # route S1J-GN: signal has been open
    'A_R7': False,  # route S1J-UM2 active
    'B_R7': False,  # route S1J-UM2 locked
    'W_R7': False,  # route S1J-UM2: proceed wanted
    'S_R7': False,  # route S1J-UM2: proceed
    'H_R7': False,  # route S1J-UM2: signal has been open
    'A_R8': False,  # route S2-S2J active
    'B_R8': False,  # route S2-S2J locked
    'W_R8': False,  # route S2-S2J: proceed wanted
    'S_R8': False,  # route S2-S2J: proceed
    'H_R8': False,  # route S2-S2J: signal has been open
    'A_R9': False,  # route S2-S2J.o2 active
    'B_R9': False,  # route S2-S2J.o2 locked
    'W_R9': False,  # route S2-S2J.o2: proceed wanted
    'S_R9': False,  # route S2-S2J.o2: proceed
    'H_R9': False,  # route S2-S2J.o2: signal has been open
    'A_R10': False,  # route S2-S2J.o3 active
    'B_R10': False,  # route S2-S2J.o3 locked
    'W_R10': False,  # route S2-S2J.o3: proceed wanted
    'S_R10': False,  # route S2-S2J.o3: proceed
    'H_R10': False,  # route S2-S2J.o3: signal has been open
    'A_R11': False,  # route S2J-G3 active
    'B_R11': False,  # route S2J-G3 locked
    'W_R11': False,  # route S2J-G3: proceed wanted
    'S_R11': False,  # route S2J-G3: proceed
    'H_R11': False,  # route S2J-G3: signal has been open
    'A_R12': False,  # route S2J-UM active
    'B_R12': False,  # route S2J-UM locked
    'W_R12': False,  # route S2J-UM: proceed wanted
    'S_R12': False,  # route S2J-UM: proceed
    'H_R12': False,  # route S2J-UM: signal has been open
    'A_R13': False,  # route S4-S4J active
    'B_R13': False,  # route S4-S4J locked
    'W_R13': False,  # route S4-S4J: proceed wanted
    'S_R13': False,  # route S4-S4J: proceed
    'H_R13': False,  # route S4-S4J: signal has been open
    'A_R14': False,  # route S4J-UM active
    'B_R14': False,  # route S4J-UM locked
    'W_R14': False,  # route S4J-UM: proceed wanted
    'S_R14': False,  # route S4J-UM: proceed
    'H_R14': False,  # route S4J-UM: signal has been open
    'A_R15': False,  # route SG-SGJ active
    'B_R15': False,  # route SG-SGJ locked
    'W_R15': False,  # route SG-SGJ: proceed wanted
    'S_R15': False,  # route SG-SGJ: proceed
    'H_R15': False,  # route SG-SGJ: signal has been open
    'A_R16': False,  # route SGJ-DB active
    'B_R16': False,  # route SGJ-DB locked
    'W_R16': False,  # route SGJ-DB: proceed wanted
    'S_R16': False,  # route SGJ-DB: proceed
    'H_R16': False,  # route SGJ-DB: signal has been open
    'A_R17': False,  # route SGJ-DM2 active
    'B_R17': False,  # route SGJ-DM2 locked
    'W_R17': False,  # route SGJ-DM2: proceed wanted
    'S_R17': False,  # route SGJ-DM2: proceed
    'H_R17': False,  # route SGJ-DM2: signal has been open
    'A_R18': False,  # route SGJ-GN active
    'B_R18': False,  # route SGJ-GN locked
    'W_R18': False,  # route SGJ-GN: proceed wanted
    'S_R18': False,  # route SGJ-GN: proceed
    'H_R18': False,  # route SGJ-GN: signal has been open
    'A_R19': False,  # route SGJ-UM2 active
    'B_R19': False,  # route SGJ-UM2 locked
    'W_R19': False,  # route SGJ-UM2: proceed wanted
    'S_R19': False,  # route SGJ-UM2: proceed
    'H_R19': False,  # route SGJ-UM2: signal has been open
    'A_R20': False,  # route SGJ-GN.s active
    'B_R20': False,  # route SGJ-GN.s locked
    'W_R20': False,  # route SGJ-GN.s: proceed wanted
    'S_R20': False,  # route SGJ-GN.s: proceed
    'H_R20': False,  # route SGJ-GN.s: signal has been open
    'X_G2': False,  # G2: cancelling
    'X_G3': False,  # G3: cancelling
    'X_S1': False,  # S1: cancelling
    'X_S1J': False,  # S1J: cancelling
    'X_S2': False,  # S2: cancelling
    'X_S2J': False,  # S2J: cancelling
    'X_S4': False,  # S4: cancelling
    'X_S4J': False,  # S4J: cancelling
    'X_SG': False,  # SG: cancelling
    'X_SGJ': False,  # SGJ: cancelling
    'K_AB': True,  # AB: restart lock (R16)
    'L_AB_1': False,  # AB locked from AB|SC@210.1a to DM
    'L_AB_2': False,  # AB locked from DM to AB|SC@210.1a
    'M_AB': False,  # AB locked for a train movement
    'F_AB': False,  # AB firmly locked
    'U_AB': True,  # AB used by a train (R9)
    'P_AB': False,  # AB: the train went on (R9)
    'D_AB': False,  # AB: detection is not relied on, inputs were lost or a train is called on
    'K_AC': True,  # AC: restart lock (R16)
    'L_AC_2': False,  # AC locked from AC|BC@101.reverse to AC|SC@101.toe
    'L_AC_3': False,  # AC locked from AC|SC@101.toe to AC|AD@101.normal
    'L_AC_4': False,  # AC locked from AC|SC@101.toe to AC|BC@101.reverse
    'M_AC': False,  # AC locked for a train movement
    'F_AC': False,  # AC firmly locked
    'U_AC': True,  # AC used by a train (R9)
    'P_AC': False,  # AC: the train went on (R9)
    'D_AC': False,  # AC: detection is not relied on, inputs were lost or a train is called on
    'K_AD': True,  # AD: restart lock (R16)
    'L_AD_1': False,  # AD locked from AC|AD@101.normal to DM2
    'M_AD': False,  # AD locked for a train movement
    'F_AD': False,  # AD firmly locked
    'U_AD': True,  # AD used by a train (R9)
    'P_AD': False,  # AD: the train went on (R9)
    'D_AD': False,  # AD: detection is not relied on, inputs were lost or a train is called on
    'K_BB': True,  # BB: restart lock (R16)
    'L_BB_1': False,  # BB locked from BB|BC@201.2b to UM2
    'L_BB_2': False,  # BB locked from UM2 to BB|BC@201.2b
    'M_BB': False,  # BB locked for a train movement
    'F_BB': False,  # BB firmly locked
    'U_BB': True,  # BB used by a train (R9)
    'P_BB': False,  # BB: the train went on (R9)
    'D_BB': False,  # BB: detection is not relied on, inputs were lost or a train is called on
    'K_BC': True,  # BC: restart lock (R16)
    'L_BC_1': False,  # BC locked from AC|BC@101.reverse to BB|BC@201.2b
    'L_BC_2': False,  # BC locked from AC|BC@101.reverse to BC|CD@201.1b
    'L_BC_3': False,  # BC locked from BB|BC@201.2b to AC|BC@101.reverse
    'L_BC_4': False,  # BC locked from BB|BC@201.2b to BC|BE@102.normal
    'M_BC': False,  # BC locked for a train movement
    'F_BC': False,  # BC firmly locked
    'U_BC': True,  # BC used by a train (R9)
    'P_BC': False,  # BC: the train went on (R9)
    'D_BC': False,  # BC: detection is not relied on, inputs were lost or a train is called on
    'K_BD': True,  # BD: restart lock (R16)
    'L_BD_1': False,  # BD locked from BD|BE@102.toe to UM
    'M_BD': False,  # BD locked for a train movement
    'F_BD': False,  # BD firmly locked
    'U_BD': True,  # BD used by a train (R9)
    'P_BD': False,  # BD: the train went on (R9)
    'D_BD': False,  # BD: detection is not relied on, inputs were lost or a train is called on
    'K_BE': True,  # BE: restart lock (R16)
    'L_BE_1': False,  # BE locked from BC|BE@102.normal to BD|BE@102.toe
    'L_BE_4': False,  # BE locked from BE|CB@102.reverse to BD|BE@102.toe
    'M_BE': False,  # BE locked for a train movement
    'F_BE': False,  # BE firmly locked
    'U_BE': True,  # BE used by a train (R9)
    'P_BE': False,  # BE: the train went on (R9)
    'D_BE': False,  # BE: detection is not relied on, inputs were lost or a train is called on
    'K_CB': True,  # CB: restart lock (R16)
    'L_CB_2': False,  # CB locked from UB to BE|CB@102.reverse
    'M_CB': False,  # CB locked for a train movement
    'F_CB': False,  # CB firmly locked
    'U_CB': True,  # CB used by a train (R9)
    'P_CB': False,  # CB: the train went on (R9)
    'D_CB': False,  # CB: detection is not relied on, inputs were lost or a train is called on
    'K_CD': True,  # CD: restart lock (R16)
    'L_CD_1': False,  # CD locked from BC|CD@201.1b to DB
    'M_CD': False,  # CD locked for a train movement
    'F_CD': False,  # CD firmly locked
    'U_CD': True,  # CD used by a train (R9)
    'P_CD': False,  # CD: the train went on (R9)
    'D_CD': False,  # CD: detection is not relied on, inputs were lost or a train is called on
    'K_GA': True,  # GA: restart lock (R16)
    'L_GA_1': False,  # GA locked from G to GA|SC@210.2a
    'L_GA_2': False,  # GA locked from GA|SC@210.2a to G
    'M_GA': False,  # GA locked for a train movement
    'F_GA': False,  # GA firmly locked
    'U_GA': True,  # GA used by a train (R9)
    'P_GA': False,  # GA: the train went on (R9)
    'D_GA': False,  # GA: detection is not relied on, inputs were lost or a train is called on
    'K_GB': True,  # GB: restart lock (R16)
    'L_GB_1': False,  # GB locked from GB|SC@210.2b to GN
    'M_GB': False,  # GB locked for a train movement
    'F_GB': False,  # GB firmly locked
    'U_GB': True,  # GB used by a train (R9)
    'P_GB': False,  # GB: the train went on (R9)
    'D_GB': False,  # GB: detection is not relied on, inputs were lost or a train is called on
    'K_SC': True,  # SC: restart lock (R16)
    'L_SC_1': False,  # SC locked from AB|SC@210.1a to AC|SC@101.toe
    'L_SC_2': False,  # SC locked from AB|SC@210.1a to GB|SC@210.2b
    'L_SC_3': False,  # SC locked from AC|SC@101.toe to AB|SC@210.1a
    'L_SC_4': False,  # SC locked from AC|SC@101.toe to GA|SC@210.2a
    'L_SC_5': False,  # SC locked from GA|SC@210.2a to AC|SC@101.toe
    'L_SC_6': False,  # SC locked from GA|SC@210.2a to GB|SC@210.2b
    'L_SC_8': False,  # SC locked from GB|SC@210.2b to GA|SC@210.2a
    'M_SC': False,  # SC locked for a train movement
    'F_SC': False,  # SC firmly locked
    'U_SC': True,  # SC used by a train (R9)
    'P_SC': False,  # SC: the train went on (R9)
    'D_SC': False,  # SC: detection is not relied on, inputs were lost or a train is called on
    'V_G3_1': False,  # overlap 1 of G3 held
    'V_S2J_1': False,  # overlap 1 of S2J held
    'V_S2J_2': False,  # overlap 2 of S2J held
    'V_S2J_3': False,  # overlap 3 of S2J held
    'VF_G3': False,  # overlap of G3 firmly held
    'VF_S2J': False,  # overlap of S2J firmly held
    'C_G3': False,  # G3 shows clear
    'C_S1': False,  # S1 shows clear
    'C_S1J': False,  # S1J shows clear
    'C_S2': False,  # S2 shows clear
    'C_S2J': False,  # S2J shows clear
    'C_S4': False,  # S4 shows clear
    'C_S4J': False,  # S4J shows clear
    'C_SG': False,  # SG shows clear
    'C_SGJ': False,  # SGJ shows clear
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_G2': 30000,  # G2: approach locking delay (R8)
    'AT_G3': 120000,  # G3: approach locking delay (R8)
    'AT_S1': 120000,  # S1: approach locking delay (R8)
    'AT_S1J': 120000,  # S1J: approach locking delay (R8)
    'AT_S2': 120000,  # S2: approach locking delay (R8)
    'AT_S2J': 120000,  # S2J: approach locking delay (R8)
    'AT_S4': 120000,  # S4: approach locking delay (R8)
    'AT_S4J': 120000,  # S4J: approach locking delay (R8)
    'AT_SG': 120000,  # SG: approach locking delay (R8)
    'AT_SGJ': 120000,  # SGJ: approach locking delay (R8)
    'RT_AB': 3000,  # AB: release delay (R9)
    'RT_AC': 3000,  # AC: release delay (R9)
    'RT_AD': 3000,  # AD: release delay (R9)
    'RT_BB': 3000,  # BB: release delay (R9)
    'RT_BC': 3000,  # BC: release delay (R9)
    'RT_BD': 3000,  # BD: release delay (R9)
    'RT_BE': 3000,  # BE: release delay (R9)
    'RT_CB': 3000,  # CB: release delay (R9)
    'RT_CD': 3000,  # CD: release delay (R9)
    'RT_GA': 3000,  # GA: release delay (R9)
    'RT_GB': 3000,  # GB: release delay (R9)
    'RT_SC': 3000,  # SC: release delay (R9)
    'OT_G3': 60000,  # G3: the train before it stands (R4)
    'OT_S2J': 60000,  # S2J: the train before it stands (R4)
    'ST_101': 13000,  # machine 101: time-out
    'ST_102': 13000,  # machine 102: time-out
    'ST_201a': 13000,  # machine 201a: time-out
    'ST_201b': 13000,  # machine 201b: time-out
    'ST_210a': 13000,  # machine 210a: time-out
    'ST_210b': 13000,  # machine 210b: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_101': False,  # machine 101: normal
    'YR_101': False,  # machine 101: reverse
    'YN_102': False,  # machine 102: normal
    'YR_102': False,  # machine 102: reverse
    'YN_201a': False,  # machine 201a: normal
    'YR_201a': False,  # machine 201a: reverse
    'YN_201b': False,  # machine 201b: normal
    'YR_201b': False,  # machine 201b: reverse
    'YN_210a': False,  # machine 210a: normal
    'YR_210a': False,  # machine 210a: reverse
    'YN_210b': False,  # machine 210b: normal
    'YR_210b': False,  # machine 210b: reverse
    'YA_101': False,  # alarm: machine 101 not detected in time
    'YA_102': False,  # alarm: machine 102 not detected in time
    'YA_201a': False,  # alarm: machine 201a not detected in time
    'YA_201b': False,  # alarm: machine 201b not detected in time
    'YA_210a': False,  # alarm: machine 210a not detected in time
    'YA_210b': False,  # alarm: machine 210b not detected in time
    'YT_101': False,  # alarm: machine 101 was trailed
    'YT_102': False,  # alarm: machine 102 was trailed
    'YT_201a': False,  # alarm: machine 201a was trailed
    'YT_201b': False,  # alarm: machine 201b was trailed
    'YT_210a': False,  # alarm: machine 210a was trailed
    'YT_210b': False,  # alarm: machine 210b was trailed
    'YL_AB': True,  # indication: AB is locked
    'YL_AC': True,  # indication: AC is locked
    'YL_AD': True,  # indication: AD is locked
    'YL_BB': True,  # indication: BB is locked
    'YL_BC': True,  # indication: BC is locked
    'YL_BD': True,  # indication: BD is locked
    'YL_BE': True,  # indication: BE is locked
    'YL_CB': True,  # indication: CB is locked
    'YL_CD': True,  # indication: CD is locked
    'YL_GA': True,  # indication: GA is locked
    'YL_GB': True,  # indication: GB is locked
    'YL_SC': True,  # indication: SC is locked
    'YW_G2': False,  # signal G2: shunt (white)
    'YS_G2': True,  # signal G2: stop
    'YP_G3': False,  # signal G3: clear (green)
    'YY_G3': False,  # signal G3: caution (yellow)
    'YS_G3': True,  # signal G3: stop
    'YP_S1': False,  # signal S1: clear (green)
    'YY_S1': False,  # signal S1: caution (yellow)
    'YS_S1': True,  # signal S1: stop
    'YP_S1J': False,  # signal S1J: clear (green)
    'YY_S1J': False,  # signal S1J: caution (yellow)
    'YS_S1J': True,  # signal S1J: stop
    'YP_S2': False,  # signal S2: clear (green)
    'YY_S2': False,  # signal S2: caution (yellow)
    'YS_S2': True,  # signal S2: stop
    'YP_S2J': False,  # signal S2J: clear (green)
    'YY_S2J': False,  # signal S2J: caution (yellow)
    'YS_S2J': True,  # signal S2J: stop
    'YP_S4': False,  # signal S4: clear (green)
    'YY_S4': False,  # signal S4: caution (yellow)
    'YS_S4': True,  # signal S4: stop
    'YP_S4J': False,  # signal S4J: clear (green)
    'YY_S4J': False,  # signal S4J: caution (yellow)
    'YS_S4J': True,  # signal S4J: stop
    'YP_SG': False,  # signal SG: clear (green)
    'YY_SG': False,  # signal SG: caution (yellow)
    'YS_SG': True,  # signal SG: stop
    'YP_SGJ': False,  # signal SGJ: clear (green)
    'YY_SGJ': False,  # signal SGJ: caution (yellow)
    'YW_SGJ': False,  # signal SGJ: shunt (white)
    'YS_SGJ': True,  # signal SGJ: stop
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
        CAN_G2 = read['CAN_G2']
        CAN_G3 = read['CAN_G3']
        CAN_S1 = read['CAN_S1']
        CAN_S1J = read['CAN_S1J']
        CAN_S2 = read['CAN_S2']
        CAN_S2J = read['CAN_S2J']
        CAN_S4 = read['CAN_S4']
        CAN_S4J = read['CAN_S4J']
        CAN_SG = read['CAN_SG']
        CAN_SGJ = read['CAN_SGJ']
        REQ = read['REQ']
        CLR_AA = read['CLR_AA']
        CLR_AB = read['CLR_AB']
        CLR_AC = read['CLR_AC']
        CLR_AD = read['CLR_AD']
        CLR_BA = read['CLR_BA']
        CLR_BB = read['CLR_BB']
        CLR_BC = read['CLR_BC']
        CLR_BD = read['CLR_BD']
        CLR_BE = read['CLR_BE']
        CLR_CA = read['CLR_CA']
        CLR_CB = read['CLR_CB']
        CLR_CD = read['CLR_CD']
        CLR_GA = read['CLR_GA']
        CLR_GB = read['CLR_GB']
        CLR_GX = read['CLR_GX']
        CLR_SC = read['CLR_SC']
        REL_AB = read['REL_AB']
        REL_AC = read['REL_AC']
        REL_AD = read['REL_AD']
        REL_BB = read['REL_BB']
        REL_BC = read['REL_BC']
        REL_BD = read['REL_BD']
        REL_BE = read['REL_BE']
        REL_CB = read['REL_CB']
        REL_CD = read['REL_CD']
        REL_GA = read['REL_GA']
        REL_GB = read['REL_GB']
        REL_SC = read['REL_SC']
        BLK_AB = read['BLK_AB']
        BLK_AC = read['BLK_AC']
        BLK_AD = read['BLK_AD']
        BLK_BB = read['BLK_BB']
        BLK_BC = read['BLK_BC']
        BLK_BD = read['BLK_BD']
        BLK_BE = read['BLK_BE']
        BLK_CB = read['BLK_CB']
        BLK_CD = read['BLK_CD']
        BLK_GA = read['BLK_GA']
        BLK_GB = read['BLK_GB']
        BLK_SC = read['BLK_SC']
        RELALL = read['RELALL']
        DN_101 = read['DN_101']
        DR_101 = read['DR_101']
        MN_101 = read['MN_101']
        MR_101 = read['MR_101']
        TC_101 = read['TC_101']
        DN_102 = read['DN_102']
        DR_102 = read['DR_102']
        MN_102 = read['MN_102']
        MR_102 = read['MR_102']
        TC_102 = read['TC_102']
        DN_201a = read['DN_201a']
        DR_201a = read['DR_201a']
        MN_201a = read['MN_201a']
        MR_201a = read['MR_201a']
        TC_201a = read['TC_201a']
        DN_201b = read['DN_201b']
        DR_201b = read['DR_201b']
        MN_201b = read['MN_201b']
        MR_201b = read['MR_201b']
        TC_201b = read['TC_201b']
        DN_210a = read['DN_210a']
        DR_210a = read['DR_210a']
        MN_210a = read['MN_210a']
        MR_210a = read['MR_210a']
        TC_210a = read['TC_210a']
        DN_210b = read['DN_210b']
        DR_210b = read['DR_210b']
        MN_210b = read['MN_210b']
        MR_210b = read['MR_210b']
        TC_210b = read['TC_210b']
        CN_101 = old['CN_101']
        CR_101 = old['CR_101']
        CN_102 = old['CN_102']
        CR_102 = old['CR_102']
        CN_201a = old['CN_201a']
        CR_201a = old['CR_201a']
        CN_201b = old['CN_201b']
        CR_201b = old['CR_201b']
        CN_210a = old['CN_210a']
        CR_210a = old['CR_210a']
        CN_210b = old['CN_210b']
        CR_210b = old['CR_210b']
        AL_101 = old['AL_101']
        AL_102 = old['AL_102']
        AL_201a = old['AL_201a']
        AL_201b = old['AL_201b']
        AL_210a = old['AL_210a']
        AL_210b = old['AL_210b']
        TH_101 = old['TH_101']
        TR_101 = old['TR_101']
        TH_102 = old['TH_102']
        TR_102 = old['TR_102']
        TH_201a = old['TH_201a']
        TR_201a = old['TR_201a']
        TH_201b = old['TH_201b']
        TR_201b = old['TR_201b']
        TH_210a = old['TH_210a']
        TR_210a = old['TR_210a']
        TH_210b = old['TH_210b']
        TR_210b = old['TR_210b']
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
        A_R18 = old['A_R18']
        B_R18 = old['B_R18']
        W_R18 = old['W_R18']
        S_R18 = old['S_R18']
        H_R18 = old['H_R18']
        A_R19 = old['A_R19']
        B_R19 = old['B_R19']
        W_R19 = old['W_R19']
        S_R19 = old['S_R19']
        H_R19 = old['H_R19']
        A_R20 = old['A_R20']
        B_R20 = old['B_R20']
        W_R20 = old['W_R20']
        S_R20 = old['S_R20']
        H_R20 = old['H_R20']
        X_G2 = old['X_G2']
        X_G3 = old['X_G3']
        X_S1 = old['X_S1']
        X_S1J = old['X_S1J']
        X_S2 = old['X_S2']
        X_S2J = old['X_S2J']
        X_S4 = old['X_S4']
        X_S4J = old['X_S4J']
        X_SG = old['X_SG']
        X_SGJ = old['X_SGJ']
        K_AB = old['K_AB']
        L_AB_1 = old['L_AB_1']
        L_AB_2 = old['L_AB_2']
        M_AB = old['M_AB']
        F_AB = old['F_AB']
        U_AB = old['U_AB']
        P_AB = old['P_AB']
        D_AB = old['D_AB']
        K_AC = old['K_AC']
        L_AC_2 = old['L_AC_2']
        L_AC_3 = old['L_AC_3']
        L_AC_4 = old['L_AC_4']
        M_AC = old['M_AC']
        F_AC = old['F_AC']
        U_AC = old['U_AC']
        P_AC = old['P_AC']
        D_AC = old['D_AC']
        K_AD = old['K_AD']
        L_AD_1 = old['L_AD_1']
        M_AD = old['M_AD']
        F_AD = old['F_AD']
        U_AD = old['U_AD']
        P_AD = old['P_AD']
        D_AD = old['D_AD']
        K_BB = old['K_BB']
        L_BB_1 = old['L_BB_1']
        L_BB_2 = old['L_BB_2']
        M_BB = old['M_BB']
        F_BB = old['F_BB']
        U_BB = old['U_BB']
        P_BB = old['P_BB']
        D_BB = old['D_BB']
        K_BC = old['K_BC']
        L_BC_1 = old['L_BC_1']
        L_BC_2 = old['L_BC_2']
        L_BC_3 = old['L_BC_3']
        L_BC_4 = old['L_BC_4']
        M_BC = old['M_BC']
        F_BC = old['F_BC']
        U_BC = old['U_BC']
        P_BC = old['P_BC']
        D_BC = old['D_BC']
        K_BD = old['K_BD']
        L_BD_1 = old['L_BD_1']
        M_BD = old['M_BD']
        F_BD = old['F_BD']
        U_BD = old['U_BD']
        P_BD = old['P_BD']
        D_BD = old['D_BD']
        K_BE = old['K_BE']
        L_BE_1 = old['L_BE_1']
        L_BE_4 = old['L_BE_4']
        M_BE = old['M_BE']
        F_BE = old['F_BE']
        U_BE = old['U_BE']
        P_BE = old['P_BE']
        D_BE = old['D_BE']
        K_CB = old['K_CB']
        L_CB_2 = old['L_CB_2']
        M_CB = old['M_CB']
        F_CB = old['F_CB']
        U_CB = old['U_CB']
        P_CB = old['P_CB']
        D_CB = old['D_CB']
        K_CD = old['K_CD']
        L_CD_1 = old['L_CD_1']
        M_CD = old['M_CD']
        F_CD = old['F_CD']
        U_CD = old['U_CD']
        P_CD = old['P_CD']
        D_CD = old['D_CD']
        K_GA = old['K_GA']
        L_GA_1 = old['L_GA_1']
        L_GA_2 = old['L_GA_2']
        M_GA = old['M_GA']
        F_GA = old['F_GA']
        U_GA = old['U_GA']
        P_GA = old['P_GA']
        D_GA = old['D_GA']
        K_GB = old['K_GB']
        L_GB_1 = old['L_GB_1']
        M_GB = old['M_GB']
        F_GB = old['F_GB']
        U_GB = old['U_GB']
        P_GB = old['P_GB']
        D_GB = old['D_GB']
        K_SC = old['K_SC']
        L_SC_1 = old['L_SC_1']
        L_SC_2 = old['L_SC_2']
        L_SC_3 = old['L_SC_3']
        L_SC_4 = old['L_SC_4']
        L_SC_5 = old['L_SC_5']
        L_SC_6 = old['L_SC_6']
        L_SC_8 = old['L_SC_8']
        M_SC = old['M_SC']
        F_SC = old['F_SC']
        U_SC = old['U_SC']
        P_SC = old['P_SC']
        D_SC = old['D_SC']
        V_G3_1 = old['V_G3_1']
        V_S2J_1 = old['V_S2J_1']
        V_S2J_2 = old['V_S2J_2']
        V_S2J_3 = old['V_S2J_3']
        VF_G3 = old['VF_G3']
        VF_S2J = old['VF_S2J']
        C_G3 = old['C_G3']
        C_S1 = old['C_S1']
        C_S1J = old['C_S1J']
        C_S2 = old['C_S2']
        C_S2J = old['C_S2J']
        C_S4 = old['C_S4']
        C_S4J = old['C_S4J']
        C_SG = old['C_SG']
        C_SGJ = old['C_SGJ']
        OCC_AA = (not CLR_AA) or (not VALID)  # AA counts as occupied
        OCC_AB = (not CLR_AB) or (not VALID)  # AB counts as occupied
        OCC_AC = (not CLR_AC) or (not VALID)  # AC counts as occupied
        OCC_AD = (not CLR_AD) or (not VALID)  # AD counts as occupied
        OCC_BA = (not CLR_BA) or (not VALID)  # BA counts as occupied
        OCC_BB = (not CLR_BB) or (not VALID)  # BB counts as occupied
        OCC_BC = (not CLR_BC) or (not VALID)  # BC counts as occupied
        OCC_BD = (not CLR_BD) or (not VALID)  # BD counts as occupied
        OCC_BE = (not CLR_BE) or (not VALID)  # BE counts as occupied
        OCC_CA = (not CLR_CA) or (not VALID)  # CA counts as occupied
        OCC_CB = (not CLR_CB) or (not VALID)  # CB counts as occupied
        OCC_CD = (not CLR_CD) or (not VALID)  # CD counts as occupied
        OCC_GA = (not CLR_GA) or (not VALID)  # GA counts as occupied
        OCC_GB = (not CLR_GB) or (not VALID)  # GB counts as occupied
        OCC_GX = (not CLR_GX) or (not VALID)  # GX counts as occupied
        OCC_SC = (not CLR_SC) or (not VALID)  # SC counts as occupied
        FREE_AB = (not K_AB) and (not L_AB_1) and (not L_AB_2) and (not V_S2J_2)  # AB is not locked by anybody
        FREE_AC = (not K_AC) and (not L_AC_2) and (not L_AC_3) and (not L_AC_4) and (not V_S2J_2) and (not V_S2J_3)  # AC is not locked by anybody
        FREE_AD = (not K_AD) and (not L_AD_1)  # AD is not locked by anybody
        FREE_BB = (not K_BB) and (not L_BB_1) and (not L_BB_2)  # BB is not locked by anybody
        FREE_BC = (not K_BC) and (not L_BC_1) and (not L_BC_2) and (not L_BC_3) and (not L_BC_4) and (not V_S2J_1) and (not V_S2J_2) and (not V_S2J_3)  # BC is not locked by anybody
        FREE_BD = (not K_BD) and (not L_BD_1) and (not V_S2J_1)  # BD is not locked by anybody
        FREE_BE = (not K_BE) and (not L_BE_1) and (not L_BE_4) and (not V_S2J_1)  # BE is not locked by anybody
        FREE_CB = (not K_CB) and (not L_CB_2)  # CB is not locked by anybody
        FREE_CD = (not K_CD) and (not L_CD_1)  # CD is not locked by anybody
        FREE_GA = (not K_GA) and (not L_GA_1) and (not L_GA_2) and (not V_G3_1) and (not V_S2J_3)  # GA is not locked by anybody
        FREE_GB = (not K_GB) and (not L_GB_1)  # GB is not locked by anybody
        FREE_SC = (not K_SC) and (not L_SC_1) and (not L_SC_2) and (not L_SC_3) and (not L_SC_4) and (not L_SC_5) and (not L_SC_6) and (not L_SC_8) and (not V_S2J_2) and (not V_S2J_3)  # SC is not locked by anybody
        QN_101 = VALID and DN_101 and (not DR_101)  # machine 101 lies N (R10)
        QR_101 = VALID and DR_101 and (not DN_101)  # machine 101 lies R (R10)
        QN_102 = VALID and DN_102 and (not DR_102)  # machine 102 lies N (R10)
        QR_102 = VALID and DR_102 and (not DN_102)  # machine 102 lies R (R10)
        QN_201a = VALID and DN_201a and (not DR_201a)  # machine 201a lies N (R10)
        QR_201a = VALID and DR_201a and (not DN_201a)  # machine 201a lies R (R10)
        QN_201b = VALID and DN_201b and (not DR_201b)  # machine 201b lies N (R10)
        QR_201b = VALID and DR_201b and (not DN_201b)  # machine 201b lies R (R10)
        QN_210a = VALID and DN_210a and (not DR_210a)  # machine 210a lies N (R10)
        QR_210a = VALID and DR_210a and (not DN_210a)  # machine 210a lies R (R10)
        QN_210b = VALID and DN_210b and (not DR_210b)  # machine 210b lies N (R10)
        QR_210b = VALID and DR_210b and (not DN_210b)  # machine 210b lies R (R10)
        MOV_101 = VALID and FREE_AC and (not OCC_AC) and (not (L_BC_4 or V_S2J_1)) and True  # machine 101 is free to move (R10)
        AVN_101 = CN_101 or MOV_101 or (QN_101 and (not CN_101) and (not CR_101))  # machine 101 can be demanded N
        AVR_101 = CR_101 or MOV_101 or (QR_101 and (not CN_101) and (not CR_101))  # machine 101 can be demanded R
        MOV_102 = VALID and FREE_BE and (not OCC_BE) and True and True  # machine 102 is free to move (R10)
        AVN_102 = CN_102 or MOV_102 or (QN_102 and (not CN_102) and (not CR_102))  # machine 102 can be demanded N
        AVR_102 = CR_102 or MOV_102 or (QR_102 and (not CN_102) and (not CR_102))  # machine 102 can be demanded R
        MOV_201a = VALID and FREE_BC and (not OCC_BC) and (not (L_BC_4 or V_S2J_1)) and True  # machine 201a is free to move (R10)
        AVN_201a = CN_201a or MOV_201a or (QN_201a and (not CN_201a) and (not CR_201a))  # machine 201a can be demanded N
        AVR_201a = CR_201a or MOV_201a or (QR_201a and (not CN_201a) and (not CR_201a))  # machine 201a can be demanded R
        MOV_201b = VALID and FREE_BC and (not OCC_BC) and (not (L_AC_3 or L_BC_2 or L_SC_2 or L_SC_6 or L_SC_8)) and (not L_BE_4)  # machine 201b is free to move (R10)
        AVN_201b = CN_201b or MOV_201b or (QN_201b and (not CN_201b) and (not CR_201b))  # machine 201b can be demanded N
        AVR_201b = CR_201b or MOV_201b or (QR_201b and (not CN_201b) and (not CR_201b))  # machine 201b can be demanded R
        MOV_210a = VALID and FREE_SC and (not OCC_SC) and True and True  # machine 210a is free to move (R10)
        AVN_210a = CN_210a or MOV_210a or (QN_210a and (not CN_210a) and (not CR_210a))  # machine 210a can be demanded N
        AVR_210a = CR_210a or MOV_210a or (QR_210a and (not CN_210a) and (not CR_210a))  # machine 210a can be demanded R
        MOV_210b = VALID and FREE_SC and (not OCC_SC) and True and True  # machine 210b is free to move (R10)
        AVN_210b = CN_210b or MOV_210b or (QN_210b and (not CN_210b) and (not CR_210b))  # machine 210b can be demanded N
        AVR_210b = CR_210b or MOV_210b or (QR_210b and (not CN_210b) and (not CR_210b))  # machine 210b can be demanded R
        WF_AB_2 = FREE_AB and (not OCC_AB) and (not BLK_AB)  # AB from DM to AB|SC@210.1a: free for a route (R6)
        WA_AC_2 = AVR_101 and (not TR_101)  # AC from AC|BC@101.reverse to AC|SC@101.toe: could be locked
        WF_AC_2 = FREE_AC and (not OCC_AC) and (not BLK_AC) and WA_AC_2  # AC from AC|BC@101.reverse to AC|SC@101.toe: free for a route (R6)
        WA_AC_3 = AVN_101 and AVN_201b and (not TR_101) and (not TR_201b)  # AC from AC|SC@101.toe to AC|AD@101.normal: could be locked
        WF_AC_3 = FREE_AC and (not OCC_AC) and (not BLK_AC) and WA_AC_3  # AC from AC|SC@101.toe to AC|AD@101.normal: free for a route (R6)
        WA_AC_4 = AVR_101 and (not TR_101)  # AC from AC|SC@101.toe to AC|BC@101.reverse: could be locked
        WF_AC_4 = FREE_AC and (not OCC_AC) and (not BLK_AC) and WA_AC_4  # AC from AC|SC@101.toe to AC|BC@101.reverse: free for a route (R6)
        WF_AD_1 = FREE_AD and (not OCC_AD) and (not BLK_AD)  # AD from AC|AD@101.normal to DM2: free for a route (R6)
        WF_BB_1 = FREE_BB and (not OCC_BB) and (not BLK_BB)  # BB from BB|BC@201.2b to UM2: free for a route (R6)
        WF_BB_2 = FREE_BB and (not OCC_BB) and (not BLK_BB)  # BB from UM2 to BB|BC@201.2b: free for a route (R6)
        WA_BC_1 = AVR_201a and AVR_201b and (not TR_201a) and (not TR_201b)  # BC from AC|BC@101.reverse to BB|BC@201.2b: could be locked
        WF_BC_1 = FREE_BC and (not OCC_BC) and (not BLK_BC) and WA_BC_1  # BC from AC|BC@101.reverse to BB|BC@201.2b: free for a route (R6)
        WA_BC_2 = AVN_201a and AVN_201b and (not TR_201a) and (not TR_201b)  # BC from AC|BC@101.reverse to BC|CD@201.1b: could be locked
        WF_BC_2 = FREE_BC and (not OCC_BC) and (not BLK_BC) and WA_BC_2  # BC from AC|BC@101.reverse to BC|CD@201.1b: free for a route (R6)
        WA_BC_3 = AVR_201b and AVR_201a and (not TR_201b) and (not TR_201a)  # BC from BB|BC@201.2b to AC|BC@101.reverse: could be locked
        WF_BC_3 = FREE_BC and (not OCC_BC) and (not BLK_BC) and WA_BC_3  # BC from BB|BC@201.2b to AC|BC@101.reverse: free for a route (R6)
        WA_BC_4 = AVN_201b and AVN_201a and AVN_101 and (not TR_201b) and (not TR_201a) and (not TR_101)  # BC from BB|BC@201.2b to BC|BE@102.normal: could be locked
        WF_BC_4 = FREE_BC and (not OCC_BC) and (not BLK_BC) and WA_BC_4  # BC from BB|BC@201.2b to BC|BE@102.normal: free for a route (R6)
        WF_BD_1 = FREE_BD and (not OCC_BD) and (not BLK_BD)  # BD from BD|BE@102.toe to UM: free for a route (R6)
        WA_BE_1 = AVN_102 and (not TR_102)  # BE from BC|BE@102.normal to BD|BE@102.toe: could be locked
        WF_BE_1 = FREE_BE and (not OCC_BE) and (not BLK_BE) and WA_BE_1  # BE from BC|BE@102.normal to BD|BE@102.toe: free for a route (R6)
        WA_BE_4 = AVR_102 and AVR_201b and (not TR_102) and (not TR_201b)  # BE from BE|CB@102.reverse to BD|BE@102.toe: could be locked
        WF_BE_4 = FREE_BE and (not OCC_BE) and (not BLK_BE) and WA_BE_4  # BE from BE|CB@102.reverse to BD|BE@102.toe: free for a route (R6)
        WF_CB_2 = FREE_CB and (not OCC_CB) and (not BLK_CB)  # CB from UB to BE|CB@102.reverse: free for a route (R6)
        WF_CD_1 = FREE_CD and (not OCC_CD) and (not BLK_CD)  # CD from BC|CD@201.1b to DB: free for a route (R6)
        WF_GA_1 = FREE_GA and (not OCC_GA) and (not BLK_GA)  # GA from G to GA|SC@210.2a: free for a route (R6)
        WF_GA_2 = FREE_GA and (not OCC_GA) and (not BLK_GA)  # GA from GA|SC@210.2a to G: free for a route (R6)
        WF_GB_1 = FREE_GB and (not OCC_GB) and (not BLK_GB)  # GB from GB|SC@210.2b to GN: free for a route (R6)
        WA_SC_1 = AVN_210a and AVN_210b and (not TR_210a) and (not TR_210b)  # SC from AB|SC@210.1a to AC|SC@101.toe: could be locked
        WF_SC_1 = FREE_SC and (not OCC_SC) and (not BLK_SC) and WA_SC_1  # SC from AB|SC@210.1a to AC|SC@101.toe: free for a route (R6)
        WA_SC_2 = AVN_210a and AVR_210b and AVN_201b and (not TR_210a) and (not TR_210b) and (not TR_201b)  # SC from AB|SC@210.1a to GB|SC@210.2b: could be locked
        WF_SC_2 = FREE_SC and (not OCC_SC) and (not BLK_SC) and WA_SC_2  # SC from AB|SC@210.1a to GB|SC@210.2b: free for a route (R6)
        WA_SC_3 = AVN_210b and AVN_210a and (not TR_210b) and (not TR_210a)  # SC from AC|SC@101.toe to AB|SC@210.1a: could be locked
        WA_SC_4 = AVN_210b and AVR_210a and (not TR_210b) and (not TR_210a)  # SC from AC|SC@101.toe to GA|SC@210.2a: could be locked
        WF_SC_4 = FREE_SC and (not OCC_SC) and (not BLK_SC) and WA_SC_4  # SC from AC|SC@101.toe to GA|SC@210.2a: free for a route (R6)
        WA_SC_5 = AVR_210a and AVN_210b and (not TR_210a) and (not TR_210b)  # SC from GA|SC@210.2a to AC|SC@101.toe: could be locked
        WF_SC_5 = FREE_SC and (not OCC_SC) and (not BLK_SC) and WA_SC_5  # SC from GA|SC@210.2a to AC|SC@101.toe: free for a route (R6)
        WA_SC_6 = AVR_210a and AVR_210b and AVN_201b and (not TR_210a) and (not TR_210b) and (not TR_201b)  # SC from GA|SC@210.2a to GB|SC@210.2b: could be locked
        WF_SC_6 = FREE_SC and (not OCC_SC) and (not BLK_SC) and WA_SC_6  # SC from GA|SC@210.2a to GB|SC@210.2b: free for a route (R6)
        WA_SC_8 = AVR_210b and AVR_210a and AVN_201b and (not TR_210b) and (not TR_210a) and (not TR_201b)  # SC from GB|SC@210.2b to GA|SC@210.2a: could be locked
        WF_SC_8 = FREE_SC and (not OCC_SC) and (not BLK_SC) and WA_SC_8  # SC from GB|SC@210.2b to GA|SC@210.2a: free for a route (R6)
        OF_G3_1 = ((not K_GA) and (not V_G3_1) and (not V_S2J_3) and (not L_GA_1) and ((not L_GA_2) or A_R2)) and (not OCC_GA) and (not BLK_GA)  # overlap 1 of G3 may be held (R4)
        OF_S2J_1 = ((not K_BC) and (not V_S2J_1) and (not V_S2J_2) and (not V_S2J_3) and (not L_BC_1) and (not L_BC_2) and (not L_BC_3) and ((not L_BC_4) or A_R12)) and (not OCC_BC) and (not BLK_BC) and WA_BC_4 and ((not K_BE) and (not V_S2J_1) and ((not L_BE_1) or A_R12) and (not L_BE_4)) and (not OCC_BE) and (not BLK_BE) and WA_BE_1 and ((not K_BD) and (not V_S2J_1) and ((not L_BD_1) or A_R12)) and (not OCC_BD) and (not BLK_BD)  # overlap 1 of S2J may be held (R4)
        OF_S2J_2 = ((not K_BC) and (not V_S2J_1) and (not V_S2J_2) and (not V_S2J_3) and (not L_BC_1) and (not L_BC_2) and ((not L_BC_3) or A_R11) and (not L_BC_4)) and (not OCC_BC) and (not BLK_BC) and WA_BC_3 and ((not K_AC) and (not V_S2J_2) and (not V_S2J_3) and ((not L_AC_2) or A_R11) and (not L_AC_3) and (not L_AC_4)) and (not OCC_AC) and (not BLK_AC) and WA_AC_2 and ((not K_SC) and (not V_S2J_2) and (not V_S2J_3) and (not L_SC_1) and (not L_SC_2) and (not L_SC_3) and (not L_SC_4) and (not L_SC_5) and (not L_SC_6) and (not L_SC_8)) and (not OCC_SC) and (not BLK_SC) and WA_SC_3 and ((not K_AB) and (not V_S2J_2) and (not L_AB_1) and (not L_AB_2)) and (not OCC_AB) and (not BLK_AB)  # overlap 2 of S2J may be held (R4)
        OF_S2J_3 = ((not K_BC) and (not V_S2J_1) and (not V_S2J_2) and (not V_S2J_3) and (not L_BC_1) and (not L_BC_2) and ((not L_BC_3) or A_R11) and (not L_BC_4)) and (not OCC_BC) and (not BLK_BC) and WA_BC_3 and ((not K_AC) and (not V_S2J_2) and (not V_S2J_3) and ((not L_AC_2) or A_R11) and (not L_AC_3) and (not L_AC_4)) and (not OCC_AC) and (not BLK_AC) and WA_AC_2 and ((not K_SC) and (not V_S2J_2) and (not V_S2J_3) and (not L_SC_1) and (not L_SC_2) and (not L_SC_3) and ((not L_SC_4) or A_R11) and (not L_SC_5) and (not L_SC_6) and (not L_SC_8)) and (not OCC_SC) and (not BLK_SC) and WA_SC_4 and ((not K_GA) and (not V_G3_1) and (not V_S2J_3) and (not L_GA_1) and (not L_GA_2)) and (not OCC_GA) and (not BLK_GA)  # overlap 3 of S2J may be held (R4)
        WL_AB_1 = (not OCC_AB)  # AB from AB|SC@210.1a to DM: lies and is clear
        WL_AB_2 = (not OCC_AB)  # AB from DM to AB|SC@210.1a: lies and is clear
        WP_AB_2 = WL_AB_2 and (not BLK_AB)  # AB from DM to AB|SC@210.1a: proceed may be shown over it (R3)
        WD_AC_2 = QR_101 and (not TR_101)  # AC from AC|BC@101.reverse to AC|SC@101.toe: its points lie, nothing is foul of it
        WL_AC_2 = (not OCC_AC) and WD_AC_2  # AC from AC|BC@101.reverse to AC|SC@101.toe: lies and is clear
        WP_AC_2 = WL_AC_2 and (not BLK_AC)  # AC from AC|BC@101.reverse to AC|SC@101.toe: proceed may be shown over it (R3)
        WD_AC_3 = QN_101 and QN_201b and (not TR_101) and (not TR_201b)  # AC from AC|SC@101.toe to AC|AD@101.normal: its points lie, nothing is foul of it
        WL_AC_3 = (not OCC_AC) and WD_AC_3  # AC from AC|SC@101.toe to AC|AD@101.normal: lies and is clear
        WP_AC_3 = WL_AC_3 and (not BLK_AC)  # AC from AC|SC@101.toe to AC|AD@101.normal: proceed may be shown over it (R3)
        WD_AC_4 = QR_101 and (not TR_101)  # AC from AC|SC@101.toe to AC|BC@101.reverse: its points lie, nothing is foul of it
        WL_AC_4 = (not OCC_AC) and WD_AC_4  # AC from AC|SC@101.toe to AC|BC@101.reverse: lies and is clear
        WP_AC_4 = WL_AC_4 and (not BLK_AC)  # AC from AC|SC@101.toe to AC|BC@101.reverse: proceed may be shown over it (R3)
        WL_AD_1 = (not OCC_AD)  # AD from AC|AD@101.normal to DM2: lies and is clear
        WP_AD_1 = WL_AD_1 and (not BLK_AD)  # AD from AC|AD@101.normal to DM2: proceed may be shown over it (R3)
        WL_BB_1 = (not OCC_BB)  # BB from BB|BC@201.2b to UM2: lies and is clear
        WP_BB_1 = WL_BB_1 and (not BLK_BB)  # BB from BB|BC@201.2b to UM2: proceed may be shown over it (R3)
        WL_BB_2 = (not OCC_BB)  # BB from UM2 to BB|BC@201.2b: lies and is clear
        WP_BB_2 = WL_BB_2 and (not BLK_BB)  # BB from UM2 to BB|BC@201.2b: proceed may be shown over it (R3)
        WD_BC_1 = QR_201a and QR_201b and (not TR_201a) and (not TR_201b)  # BC from AC|BC@101.reverse to BB|BC@201.2b: its points lie, nothing is foul of it
        WL_BC_1 = (not OCC_BC) and WD_BC_1  # BC from AC|BC@101.reverse to BB|BC@201.2b: lies and is clear
        WP_BC_1 = WL_BC_1 and (not BLK_BC)  # BC from AC|BC@101.reverse to BB|BC@201.2b: proceed may be shown over it (R3)
        WD_BC_2 = QN_201a and QN_201b and (not TR_201a) and (not TR_201b)  # BC from AC|BC@101.reverse to BC|CD@201.1b: its points lie, nothing is foul of it
        WL_BC_2 = (not OCC_BC) and WD_BC_2  # BC from AC|BC@101.reverse to BC|CD@201.1b: lies and is clear
        WP_BC_2 = WL_BC_2 and (not BLK_BC)  # BC from AC|BC@101.reverse to BC|CD@201.1b: proceed may be shown over it (R3)
        WD_BC_3 = QR_201b and QR_201a and (not TR_201b) and (not TR_201a)  # BC from BB|BC@201.2b to AC|BC@101.reverse: its points lie, nothing is foul of it
        WL_BC_3 = (not OCC_BC) and WD_BC_3  # BC from BB|BC@201.2b to AC|BC@101.reverse: lies and is clear
        WP_BC_3 = WL_BC_3 and (not BLK_BC)  # BC from BB|BC@201.2b to AC|BC@101.reverse: proceed may be shown over it (R3)
        WD_BC_4 = QN_201b and QN_201a and QN_101 and (not TR_201b) and (not TR_201a) and (not TR_101)  # BC from BB|BC@201.2b to BC|BE@102.normal: its points lie, nothing is foul of it
        WL_BC_4 = (not OCC_BC) and WD_BC_4  # BC from BB|BC@201.2b to BC|BE@102.normal: lies and is clear
        WP_BC_4 = WL_BC_4 and (not BLK_BC)  # BC from BB|BC@201.2b to BC|BE@102.normal: proceed may be shown over it (R3)
        WL_BD_1 = (not OCC_BD)  # BD from BD|BE@102.toe to UM: lies and is clear
        WP_BD_1 = WL_BD_1 and (not BLK_BD)  # BD from BD|BE@102.toe to UM: proceed may be shown over it (R3)
        WD_BE_1 = QN_102 and (not TR_102)  # BE from BC|BE@102.normal to BD|BE@102.toe: its points lie, nothing is foul of it
        WL_BE_1 = (not OCC_BE) and WD_BE_1  # BE from BC|BE@102.normal to BD|BE@102.toe: lies and is clear
        WP_BE_1 = WL_BE_1 and (not BLK_BE)  # BE from BC|BE@102.normal to BD|BE@102.toe: proceed may be shown over it (R3)
        WD_BE_4 = QR_102 and QR_201b and (not TR_102) and (not TR_201b)  # BE from BE|CB@102.reverse to BD|BE@102.toe: its points lie, nothing is foul of it
        WL_BE_4 = (not OCC_BE) and WD_BE_4  # BE from BE|CB@102.reverse to BD|BE@102.toe: lies and is clear
        WP_BE_4 = WL_BE_4 and (not BLK_BE)  # BE from BE|CB@102.reverse to BD|BE@102.toe: proceed may be shown over it (R3)
        WL_CB_2 = (not OCC_CB)  # CB from UB to BE|CB@102.reverse: lies and is clear
        WP_CB_2 = WL_CB_2 and (not BLK_CB)  # CB from UB to BE|CB@102.reverse: proceed may be shown over it (R3)
        WL_CD_1 = (not OCC_CD)  # CD from BC|CD@201.1b to DB: lies and is clear
        WP_CD_1 = WL_CD_1 and (not BLK_CD)  # CD from BC|CD@201.1b to DB: proceed may be shown over it (R3)
        WL_GA_1 = (not OCC_GA)  # GA from G to GA|SC@210.2a: lies and is clear
        WP_GA_1 = WL_GA_1 and (not BLK_GA)  # GA from G to GA|SC@210.2a: proceed may be shown over it (R3)
        WL_GA_2 = (not OCC_GA)  # GA from GA|SC@210.2a to G: lies and is clear
        WP_GA_2 = WL_GA_2 and (not BLK_GA)  # GA from GA|SC@210.2a to G: proceed may be shown over it (R3)
        WL_GB_1 = (not OCC_GB)  # GB from GB|SC@210.2b to GN: lies and is clear
        WP_GB_1 = WL_GB_1 and (not BLK_GB)  # GB from GB|SC@210.2b to GN: proceed may be shown over it (R3)
        WD_SC_1 = QN_210a and QN_210b and (not TR_210a) and (not TR_210b)  # SC from AB|SC@210.1a to AC|SC@101.toe: its points lie, nothing is foul of it
        WL_SC_1 = (not OCC_SC) and WD_SC_1  # SC from AB|SC@210.1a to AC|SC@101.toe: lies and is clear
        WP_SC_1 = WL_SC_1 and (not BLK_SC)  # SC from AB|SC@210.1a to AC|SC@101.toe: proceed may be shown over it (R3)
        WD_SC_2 = QN_210a and QR_210b and QN_201b and (not TR_210a) and (not TR_210b) and (not TR_201b)  # SC from AB|SC@210.1a to GB|SC@210.2b: its points lie, nothing is foul of it
        WL_SC_2 = (not OCC_SC) and WD_SC_2  # SC from AB|SC@210.1a to GB|SC@210.2b: lies and is clear
        WP_SC_2 = WL_SC_2 and (not BLK_SC)  # SC from AB|SC@210.1a to GB|SC@210.2b: proceed may be shown over it (R3)
        WD_SC_3 = QN_210b and QN_210a and (not TR_210b) and (not TR_210a)  # SC from AC|SC@101.toe to AB|SC@210.1a: its points lie, nothing is foul of it
        WL_SC_3 = (not OCC_SC) and WD_SC_3  # SC from AC|SC@101.toe to AB|SC@210.1a: lies and is clear
        WD_SC_4 = QN_210b and QR_210a and (not TR_210b) and (not TR_210a)  # SC from AC|SC@101.toe to GA|SC@210.2a: its points lie, nothing is foul of it
        WL_SC_4 = (not OCC_SC) and WD_SC_4  # SC from AC|SC@101.toe to GA|SC@210.2a: lies and is clear
        WP_SC_4 = WL_SC_4 and (not BLK_SC)  # SC from AC|SC@101.toe to GA|SC@210.2a: proceed may be shown over it (R3)
        WD_SC_5 = QR_210a and QN_210b and (not TR_210a) and (not TR_210b)  # SC from GA|SC@210.2a to AC|SC@101.toe: its points lie, nothing is foul of it
        WL_SC_5 = (not OCC_SC) and WD_SC_5  # SC from GA|SC@210.2a to AC|SC@101.toe: lies and is clear
        WP_SC_5 = WL_SC_5 and (not BLK_SC)  # SC from GA|SC@210.2a to AC|SC@101.toe: proceed may be shown over it (R3)
        WD_SC_6 = QR_210a and QR_210b and QN_201b and (not TR_210a) and (not TR_210b) and (not TR_201b)  # SC from GA|SC@210.2a to GB|SC@210.2b: its points lie, nothing is foul of it
        WL_SC_6 = (not OCC_SC) and WD_SC_6  # SC from GA|SC@210.2a to GB|SC@210.2b: lies and is clear
        WP_SC_6 = WL_SC_6 and (not BLK_SC)  # SC from GA|SC@210.2a to GB|SC@210.2b: proceed may be shown over it (R3)
        WD_SC_8 = QR_210b and QR_210a and QN_201b and (not TR_210b) and (not TR_210a) and (not TR_201b)  # SC from GB|SC@210.2b to GA|SC@210.2a: its points lie, nothing is foul of it
        WL_SC_8 = (not OCC_SC) and WD_SC_8  # SC from GB|SC@210.2b to GA|SC@210.2a: lies and is clear
        WP_SC_8 = WL_SC_8 and (not BLK_SC)  # SC from GB|SC@210.2b to GA|SC@210.2a: proceed may be shown over it (R3)
        G_R1 = (REQ == 1) and VALID and WF_SC_8  # grant of route G2-G3 (R6)
        G_R2 = (REQ == 2) and VALID and ((not K_GA) and (not L_GA_1) and (not L_GA_2) and (not V_S2J_3)) and (not OCC_GA) and (not BLK_GA)  # grant of route G3-G (R6)
        G_R3 = (REQ == 3) and VALID and WF_AB_2  # grant of route S1-S1J (R6)
        G_R4 = (REQ == 4) and VALID and WF_SC_1 and WF_AC_4 and WF_BC_2 and WF_CD_1  # grant of route S1J-DB (R6)
        G_R5 = (REQ == 5) and VALID and WF_SC_1 and WF_AC_3 and WF_AD_1  # grant of route S1J-DM2 (R6)
        G_R6 = (REQ == 6) and VALID and WF_SC_2 and WF_GB_1  # grant of route S1J-GN (R6)
        G_R7 = (REQ == 7) and VALID and WF_SC_1 and WF_AC_4 and WF_BC_1 and WF_BB_1  # grant of route S1J-UM2 (R6)
        G_R8 = (REQ == 8) and VALID and WF_BB_2 and OF_S2J_1  # grant of route S2-S2J (R6)
        G_R9 = (REQ == 9) and VALID and WF_BB_2 and OF_S2J_2  # grant of route S2-S2J.o2 (R6)
        G_R10 = (REQ == 10) and VALID and WF_BB_2 and OF_S2J_3  # grant of route S2-S2J.o3 (R6)
        G_R11 = (REQ == 11) and VALID and ((not K_BC) and (not L_BC_1) and (not L_BC_2) and (not L_BC_3) and (not L_BC_4) and (not V_S2J_1)) and (not OCC_BC) and (not BLK_BC) and WA_BC_3 and ((not K_AC) and (not L_AC_2) and (not L_AC_3) and (not L_AC_4)) and (not OCC_AC) and (not BLK_AC) and WA_AC_2 and ((not K_SC) and (not L_SC_1) and (not L_SC_2) and (not L_SC_3) and (not L_SC_4) and (not L_SC_5) and (not L_SC_6) and (not L_SC_8) and (not V_S2J_2)) and (not OCC_SC) and (not BLK_SC) and WA_SC_4 and OF_G3_1  # grant of route S2J-G3 (R6)
        G_R12 = (REQ == 12) and VALID and ((not K_BC) and (not L_BC_1) and (not L_BC_2) and (not L_BC_3) and (not L_BC_4) and (not V_S2J_2) and (not V_S2J_3)) and (not OCC_BC) and (not BLK_BC) and WA_BC_4 and ((not K_BE) and (not L_BE_1) and (not L_BE_4)) and (not OCC_BE) and (not BLK_BE) and WA_BE_1 and ((not K_BD) and (not L_BD_1)) and (not OCC_BD) and (not BLK_BD)  # grant of route S2J-UM (R6)
        G_R13 = (REQ == 13) and VALID and WF_CB_2  # grant of route S4-S4J (R6)
        G_R14 = (REQ == 14) and VALID and WF_BE_4 and WF_BD_1  # grant of route S4J-UM (R6)
        G_R15 = (REQ == 15) and VALID and WF_GA_1  # grant of route SG-SGJ (R6)
        G_R16 = (REQ == 16) and VALID and WF_SC_5 and WF_AC_4 and WF_BC_2 and WF_CD_1  # grant of route SGJ-DB (R6)
        G_R17 = (REQ == 17) and VALID and WF_SC_5 and WF_AC_3 and WF_AD_1  # grant of route SGJ-DM2 (R6)
        G_R18 = (REQ == 18) and VALID and WF_SC_6 and WF_GB_1  # grant of route SGJ-GN (R6)
        G_R19 = (REQ == 19) and VALID and WF_SC_5 and WF_AC_4 and WF_BC_1 and WF_BB_1  # grant of route SGJ-UM2 (R6)
        G_R20 = (REQ == 20) and VALID and WF_SC_6 and (not BLK_GB) and (not M_GB)  # grant of route SGJ-GN.s (R6)
        GW_AB_2 = G_R3  # AB from DM to AB|SC@210.1a: granted
        GW_AC_2 = G_R11  # AC from AC|BC@101.reverse to AC|SC@101.toe: granted
        GW_AC_3 = G_R5 or G_R17  # AC from AC|SC@101.toe to AC|AD@101.normal: granted
        GW_AC_4 = G_R4 or G_R7 or G_R16 or G_R19  # AC from AC|SC@101.toe to AC|BC@101.reverse: granted
        GW_AD_1 = G_R5 or G_R17  # AD from AC|AD@101.normal to DM2: granted
        GW_BB_1 = G_R7 or G_R19  # BB from BB|BC@201.2b to UM2: granted
        GW_BB_2 = G_R8 or G_R9 or G_R10  # BB from UM2 to BB|BC@201.2b: granted
        GW_BC_1 = G_R7 or G_R19  # BC from AC|BC@101.reverse to BB|BC@201.2b: granted
        GW_BC_2 = G_R4 or G_R16  # BC from AC|BC@101.reverse to BC|CD@201.1b: granted
        GW_BC_3 = G_R11  # BC from BB|BC@201.2b to AC|BC@101.reverse: granted
        GW_BC_4 = G_R12  # BC from BB|BC@201.2b to BC|BE@102.normal: granted
        GW_BD_1 = G_R12 or G_R14  # BD from BD|BE@102.toe to UM: granted
        GW_BE_1 = G_R12  # BE from BC|BE@102.normal to BD|BE@102.toe: granted
        GW_BE_4 = G_R14  # BE from BE|CB@102.reverse to BD|BE@102.toe: granted
        GW_CB_2 = G_R13  # CB from UB to BE|CB@102.reverse: granted
        GW_CD_1 = G_R4 or G_R16  # CD from BC|CD@201.1b to DB: granted
        GW_GA_1 = G_R15  # GA from G to GA|SC@210.2a: granted
        GW_GA_2 = G_R2  # GA from GA|SC@210.2a to G: granted
        GW_GB_1 = G_R6 or G_R18  # GB from GB|SC@210.2b to GN: granted
        GB_GB_1 = G_R20  # GB from GB|SC@210.2b to GN: granted
        GW_SC_1 = G_R4 or G_R5 or G_R7  # SC from AB|SC@210.1a to AC|SC@101.toe: granted
        GW_SC_2 = G_R6  # SC from AB|SC@210.1a to GB|SC@210.2b: granted
        GW_SC_4 = G_R11  # SC from AC|SC@101.toe to GA|SC@210.2a: granted
        GW_SC_5 = G_R16 or G_R17 or G_R19  # SC from GA|SC@210.2a to AC|SC@101.toe: granted
        GW_SC_6 = G_R18 or G_R20  # SC from GA|SC@210.2a to GB|SC@210.2b: granted
        GW_SC_8 = G_R1  # SC from GB|SC@210.2b to GA|SC@210.2a: granted
        GO_G3_1 = G_R11  # overlap 1 of G3: granted
        GO_S2J_1 = G_R8  # overlap 1 of S2J: granted
        GO_S2J_2 = G_R9  # overlap 2 of S2J: granted
        GO_S2J_3 = G_R10  # overlap 3 of S2J: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_G2) and (not CAN_G2) and WL_SC_8  # route G2-G3 becomes locked (R3)
        CO_R1 = VALID and WP_SC_8 and (not D_SC)  # conditions of proceed for route G2-G3 (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_G3) and (not CAN_G3) and WL_GA_2  # route G3-G becomes locked (R3)
        CO_R2 = VALID and WP_GA_2 and (not OCC_GX) and (not D_GA)  # conditions of proceed for route G3-G (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_S1) and (not CAN_S1) and WL_AB_2  # route S1-S1J becomes locked (R3)
        CO_R3 = VALID and WP_AB_2 and (not D_AB)  # conditions of proceed for route S1-S1J (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_S1J) and (not CAN_S1J) and WL_SC_1 and WL_AC_4 and WL_BC_2 and WL_CD_1  # route S1J-DB becomes locked (R3)
        CO_R4 = VALID and WP_SC_1 and WP_AC_4 and WP_BC_2 and WP_CD_1 and (not D_SC)  # conditions of proceed for route S1J-DB (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_S1J) and (not CAN_S1J) and WL_SC_1 and WL_AC_3 and WL_AD_1  # route S1J-DM2 becomes locked (R3)
        CO_R5 = VALID and WP_SC_1 and WP_AC_3 and WP_AD_1 and (not D_SC)  # conditions of proceed for route S1J-DM2 (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_S1J) and (not CAN_S1J) and WL_SC_2 and WL_GB_1  # route S1J-GN becomes locked (R3)
        CO_R6 = VALID and WP_SC_2 and WP_GB_1 and (not D_SC)  # conditions of proceed for route S1J-GN (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_S1J) and (not CAN_S1J) and WL_SC_1 and WL_AC_4 and WL_BC_1 and WL_BB_1  # route S1J-UM2 becomes locked (R3)
        CO_R7 = VALID and WP_SC_1 and WP_AC_4 and WP_BC_1 and WP_BB_1 and (not OCC_BA) and (not D_SC)  # conditions of proceed for route S1J-UM2 (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_S2) and (not CAN_S2) and WL_BB_2 and WL_BC_4 and WL_BE_1 and WL_BD_1  # route S2-S2J becomes locked (R3)
        CO_R8 = VALID and WP_BB_2 and WL_BC_4 and WL_BE_1 and WL_BD_1 and (not D_BB) and V_S2J_1  # conditions of proceed for route S2-S2J (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_S2) and (not CAN_S2) and WL_BB_2 and WL_BC_3 and WL_AC_2 and WL_SC_3 and WL_AB_1  # route S2-S2J.o2 becomes locked (R3)
        CO_R9 = VALID and WP_BB_2 and WL_BC_3 and WL_AC_2 and WL_SC_3 and WL_AB_1 and (not D_BB) and V_S2J_2  # conditions of proceed for route S2-S2J.o2 (R3)
        LK_R10 = A_R10 and (not B_R10) and VALID and (not X_S2) and (not CAN_S2) and WL_BB_2 and WL_BC_3 and WL_AC_2 and WL_SC_4 and WL_GA_2  # route S2-S2J.o3 becomes locked (R3)
        CO_R10 = VALID and WP_BB_2 and WL_BC_3 and WL_AC_2 and WL_SC_4 and WL_GA_2 and (not D_BB) and V_S2J_3  # conditions of proceed for route S2-S2J.o3 (R3)
        LK_R11 = A_R11 and (not B_R11) and VALID and (not X_S2J) and (not CAN_S2J) and WL_BC_3 and WL_AC_2 and WL_SC_4 and WL_GA_2  # route S2J-G3 becomes locked (R3)
        CO_R11 = VALID and WP_BC_3 and WP_AC_2 and WP_SC_4 and WL_GA_2 and (not D_BC) and V_G3_1  # conditions of proceed for route S2J-G3 (R3)
        LK_R12 = A_R12 and (not B_R12) and VALID and (not X_S2J) and (not CAN_S2J) and WL_BC_4 and WL_BE_1 and WL_BD_1  # route S2J-UM becomes locked (R3)
        CO_R12 = VALID and WP_BC_4 and WP_BE_1 and WP_BD_1 and (not D_BC)  # conditions of proceed for route S2J-UM (R3)
        LK_R13 = A_R13 and (not B_R13) and VALID and (not X_S4) and (not CAN_S4) and WL_CB_2  # route S4-S4J becomes locked (R3)
        CO_R13 = VALID and WP_CB_2 and (not D_CB)  # conditions of proceed for route S4-S4J (R3)
        LK_R14 = A_R14 and (not B_R14) and VALID and (not X_S4J) and (not CAN_S4J) and WL_BE_4 and WL_BD_1  # route S4J-UM becomes locked (R3)
        CO_R14 = VALID and WP_BE_4 and WP_BD_1 and (not D_BE)  # conditions of proceed for route S4J-UM (R3)
        LK_R15 = A_R15 and (not B_R15) and VALID and (not X_SG) and (not CAN_SG) and WL_GA_1  # route SG-SGJ becomes locked (R3)
        CO_R15 = VALID and WP_GA_1 and (not D_GA)  # conditions of proceed for route SG-SGJ (R3)
        LK_R16 = A_R16 and (not B_R16) and VALID and (not X_SGJ) and (not CAN_SGJ) and WL_SC_5 and WL_AC_4 and WL_BC_2 and WL_CD_1  # route SGJ-DB becomes locked (R3)
        CO_R16 = VALID and WP_SC_5 and WP_AC_4 and WP_BC_2 and WP_CD_1 and (not D_SC)  # conditions of proceed for route SGJ-DB (R3)
        LK_R17 = A_R17 and (not B_R17) and VALID and (not X_SGJ) and (not CAN_SGJ) and WL_SC_5 and WL_AC_3 and WL_AD_1  # route SGJ-DM2 becomes locked (R3)
        CO_R17 = VALID and WP_SC_5 and WP_AC_3 and WP_AD_1 and (not D_SC)  # conditions of proceed for route SGJ-DM2 (R3)
        LK_R18 = A_R18 and (not B_R18) and VALID and (not X_SGJ) and (not CAN_SGJ) and WL_SC_6 and WL_GB_1  # route SGJ-GN becomes locked (R3)
        CO_R18 = VALID and WP_SC_6 and WP_GB_1 and (not D_SC)  # conditions of proceed for route SGJ-GN (R3)
        LK_R19 = A_R19 and (not B_R19) and VALID and (not X_SGJ) and (not CAN_SGJ) and WL_SC_5 and WL_AC_4 and WL_BC_1 and WL_BB_1  # route SGJ-UM2 becomes locked (R3)
        CO_R19 = VALID and WP_SC_5 and WP_AC_4 and WP_BC_1 and WP_BB_1 and (not OCC_BA) and (not D_SC)  # conditions of proceed for route SGJ-UM2 (R3)
        LK_R20 = A_R20 and (not B_R20) and VALID and (not X_SGJ) and (not CAN_SGJ) and WL_SC_6  # route SGJ-GN.s becomes locked (R3)
        CO_R20 = VALID and WP_SC_6 and (not BLK_GB) and (not D_SC)  # conditions of proceed for route SGJ-GN.s (R3)
        NU_AB_1 = VALID and F_AB and (not D_AB) and (not U_AB) and L_AB_1 and OCC_AB and OCC_SC and (V_S2J_2 or U_SC) and (V_S2J_2 or L_SC_3)  # a train comes into AB at AB|SC@210.1a (R9)
        NU_AB_2 = VALID and F_AB and (not D_AB) and (not U_AB) and L_AB_2 and OCC_AB and OCC_AA  # a train comes into AB at DM (R9)
        NU_AC_2 = VALID and F_AC and (not D_AC) and (not U_AC) and L_AC_2 and OCC_AC and OCC_BC and (V_S2J_2 or V_S2J_3 or U_BC) and (V_S2J_2 or V_S2J_3 or L_BC_3)  # a train comes into AC at AC|BC@101.reverse (R9)
        NU_AC_3 = VALID and F_AC and (not D_AC) and (not U_AC) and (L_AC_3 or L_AC_4) and OCC_AC and OCC_SC and U_SC and (L_SC_1 or L_SC_5)  # a train comes into AC at AC|SC@101.toe (R9)
        NU_AD_1 = VALID and F_AD and (not D_AD) and (not U_AD) and L_AD_1 and OCC_AD and OCC_AC and U_AC and L_AC_3  # a train comes into AD at AC|AD@101.normal (R9)
        NU_BB_1 = VALID and F_BB and (not D_BB) and (not U_BB) and L_BB_1 and OCC_BB and OCC_BC and U_BC and L_BC_1  # a train comes into BB at BB|BC@201.2b (R9)
        NU_BB_2 = VALID and F_BB and (not D_BB) and (not U_BB) and L_BB_2 and OCC_BB and OCC_BA  # a train comes into BB at UM2 (R9)
        NU_BC_1 = VALID and F_BC and (not D_BC) and (not U_BC) and (L_BC_1 or L_BC_2) and OCC_BC and OCC_AC and U_AC and L_AC_4  # a train comes into BC at AC|BC@101.reverse (R9)
        NU_BC_2 = VALID and F_BC and (not D_BC) and (not U_BC) and (L_BC_3 or L_BC_4) and OCC_BC and OCC_BB  # a train comes into BC at BB|BC@201.2b (R9)
        NU_BD_1 = VALID and F_BD and (not D_BD) and (not U_BD) and L_BD_1 and OCC_BD and OCC_BE and (V_S2J_1 or U_BE) and (V_S2J_1 or L_BE_1 or L_BE_4)  # a train comes into BD at BD|BE@102.toe (R9)
        NU_BE_1 = VALID and F_BE and (not D_BE) and (not U_BE) and L_BE_1 and OCC_BE and OCC_BC and (V_S2J_1 or U_BC) and (V_S2J_1 or L_BC_4)  # a train comes into BE at BC|BE@102.normal (R9)
        NU_BE_3 = VALID and F_BE and (not D_BE) and (not U_BE) and L_BE_4 and OCC_BE and OCC_CB  # a train comes into BE at BE|CB@102.reverse (R9)
        NU_CB_2 = VALID and F_CB and (not D_CB) and (not U_CB) and L_CB_2 and OCC_CB and OCC_CA  # a train comes into CB at UB (R9)
        NU_CD_1 = VALID and F_CD and (not D_CD) and (not U_CD) and L_CD_1 and OCC_CD and OCC_BC and U_BC and L_BC_2  # a train comes into CD at BC|CD@201.1b (R9)
        NU_GA_1 = VALID and F_GA and (not D_GA) and (not U_GA) and L_GA_1 and OCC_GA and OCC_GX  # a train comes into GA at G (R9)
        NU_GA_2 = VALID and F_GA and (not D_GA) and (not U_GA) and L_GA_2 and OCC_GA and OCC_SC  # a train comes into GA at GA|SC@210.2a (R9)
        NU_GB_1 = VALID and F_GB and (not D_GB) and (not U_GB) and L_GB_1 and OCC_GB and OCC_SC and U_SC and (L_SC_2 or L_SC_6)  # a train comes into GB at GB|SC@210.2b (R9)
        NU_SC_1 = VALID and F_SC and (not D_SC) and (not U_SC) and (L_SC_1 or L_SC_2) and OCC_SC and OCC_AB  # a train comes into SC at AB|SC@210.1a (R9)
        NU_SC_2 = VALID and F_SC and (not D_SC) and (not U_SC) and (L_SC_3 or L_SC_4) and OCC_SC and OCC_AC and (V_S2J_2 or V_S2J_3 or U_AC) and (V_S2J_2 or V_S2J_3 or L_AC_2)  # a train comes into SC at AC|SC@101.toe (R9)
        NU_SC_3 = VALID and F_SC and (not D_SC) and (not U_SC) and (L_SC_5 or L_SC_6) and OCC_SC and OCC_GA  # a train comes into SC at GA|SC@210.2a (R9)
        NU_SC_4 = VALID and F_SC and (not D_SC) and (not U_SC) and L_SC_8 and OCC_SC and OCC_GB and ((not M_SC) or U_GB) and (not M_SC)  # a train comes into SC at GB|SC@210.2b (R9)
        ATI_G2 = X_G2 or ((not A_R1) and L_SC_8 and REL_SC)  # G2 at stop, waiting for a train that may still come (R8)
        ATI_G3 = X_G3 or ((not A_R2) and L_GA_2 and (REL_GA or (L_GA_2 and U_GA and (not OCC_GA))))  # G3 at stop, waiting for a train that may still come (R8)
        ATI_S1 = X_S1 or ((not A_R3) and L_AB_2 and REL_AB)  # S1 at stop, waiting for a train that may still come (R8)
        ATI_S1J = X_S1J or ((not (A_R4 or A_R5 or A_R6 or A_R7)) and (L_SC_1 or L_SC_2) and (REL_SC or (L_SC_2 and (not M_SC) and U_SC and (not OCC_SC))))  # S1J at stop, waiting for a train that may still come (R8)
        ATI_S2 = X_S2 or ((not (A_R8 or A_R9 or A_R10)) and L_BB_2 and REL_BB)  # S2 at stop, waiting for a train that may still come (R8)
        ATI_S2J = X_S2J or ((not (A_R11 or A_R12)) and (L_BC_3 or L_BC_4) and REL_BC)  # S2J at stop, waiting for a train that may still come (R8)
        ATI_S4 = X_S4 or ((not A_R13) and L_CB_2 and REL_CB)  # S4 at stop, waiting for a train that may still come (R8)
        ATI_S4J = X_S4J or ((not A_R14) and L_BE_4 and REL_BE)  # S4J at stop, waiting for a train that may still come (R8)
        ATI_SG = X_SG or ((not A_R15) and L_GA_1 and REL_GA)  # SG at stop, waiting for a train that may still come (R8)
        ATI_SGJ = X_SGJ or ((not (A_R16 or A_R17 or A_R18 or A_R19 or A_R20)) and (L_SC_5 or L_SC_6) and (REL_SC or (L_SC_6 and (not M_SC) and U_SC and (not OCC_SC))))  # SGJ at stop, waiting for a train that may still come (R8)
        AT_G2 = self._timer('AT_G2', ATI_G2, dt_ms)  # G2: approach locking delay (R8)
        AT_G3 = self._timer('AT_G3', ATI_G3, dt_ms)  # G3: approach locking delay (R8)
        AT_S1 = self._timer('AT_S1', ATI_S1, dt_ms)  # S1: approach locking delay (R8)
        AT_S1J = self._timer('AT_S1J', ATI_S1J, dt_ms)  # S1J: approach locking delay (R8)
        AT_S2 = self._timer('AT_S2', ATI_S2, dt_ms)  # S2: approach locking delay (R8)
        AT_S2J = self._timer('AT_S2J', ATI_S2J, dt_ms)  # S2J: approach locking delay (R8)
        AT_S4 = self._timer('AT_S4', ATI_S4, dt_ms)  # S4: approach locking delay (R8)
        AT_S4J = self._timer('AT_S4J', ATI_S4J, dt_ms)  # S4J: approach locking delay (R8)
        AT_SG = self._timer('AT_SG', ATI_SG, dt_ms)  # SG: approach locking delay (R8)
        AT_SGJ = self._timer('AT_SGJ', ATI_SGJ, dt_ms)  # SGJ: approach locking delay (R8)
        CD_G2 = X_G2 and A_R1 and VALID and (not OCC_SC) and ((not OCC_GB) or AT_G2 or (not H_R1))  # the route from G2 is cancelled (R8)
        CD_G3 = X_G3 and A_R2 and VALID and (not OCC_GA) and ((not OCC_SC) or AT_G3 or (not H_R2))  # the route from G3 is cancelled (R8)
        CD_S1 = X_S1 and A_R3 and VALID and (not OCC_AB) and ((not OCC_AA) or AT_S1 or (not H_R3))  # the route from S1 is cancelled (R8)
        CD_S1J = X_S1J and (A_R4 or A_R5 or A_R6 or A_R7) and VALID and (not OCC_SC) and ((not OCC_AB) or AT_S1J or (not (H_R4 or H_R5 or H_R6 or H_R7)))  # the route from S1J is cancelled (R8)
        CD_S2 = X_S2 and (A_R8 or A_R9 or A_R10) and VALID and (not OCC_BB) and ((not OCC_BA) or AT_S2 or (not (H_R8 or H_R9 or H_R10)))  # the route from S2 is cancelled (R8)
        CD_S2J = X_S2J and (A_R11 or A_R12) and VALID and (not OCC_BC) and ((not OCC_BB) or AT_S2J or (not (H_R11 or H_R12)))  # the route from S2J is cancelled (R8)
        CD_S4 = X_S4 and A_R13 and VALID and (not OCC_CB) and ((not OCC_CA) or AT_S4 or (not H_R13))  # the route from S4 is cancelled (R8)
        CD_S4J = X_S4J and A_R14 and VALID and (not OCC_BE) and ((not OCC_CB) or AT_S4J or (not H_R14))  # the route from S4J is cancelled (R8)
        CD_SG = X_SG and A_R15 and VALID and (not OCC_GA) and ((not OCC_GX) or AT_SG or (not H_R15))  # the route from SG is cancelled (R8)
        CD_SGJ = X_SGJ and (A_R16 or A_R17 or A_R18 or A_R19 or A_R20) and VALID and (not OCC_SC) and ((not OCC_GA) or AT_SGJ or (not (H_R16 or H_R17 or H_R18 or H_R19 or H_R20)))  # the route from SGJ is cancelled (R8)
        EX_AB = P_AB or L_AB_1  # a train in AB leaves over a boundary, or has passed on
        RTI_AB = VALID and U_AB and (not OCC_AB) and (not (L_AB_1 and L_SC_3)) and EX_AB  # AB may be released behind the train (R9)
        EX_AC = P_AC  # a train in AC leaves over a boundary, or has passed on
        RTI_AC = VALID and U_AC and (not OCC_AC) and (not (L_AC_2 and L_BC_3)) and (not ((L_AC_3 or L_AC_4) and (L_SC_1 or L_SC_5))) and EX_AC  # AC may be released behind the train (R9)
        EX_AD = P_AD or L_AD_1  # a train in AD leaves over a boundary, or has passed on
        RTI_AD = VALID and U_AD and (not OCC_AD) and (not (L_AD_1 and L_AC_3)) and EX_AD  # AD may be released behind the train (R9)
        EX_BB = P_BB or L_BB_1  # a train in BB leaves over a boundary, or has passed on
        RTI_BB = VALID and U_BB and (not OCC_BB) and (not (L_BB_1 and L_BC_1)) and EX_BB  # BB may be released behind the train (R9)
        EX_BC = P_BC  # a train in BC leaves over a boundary, or has passed on
        RTI_BC = VALID and U_BC and (not OCC_BC) and (not ((L_BC_1 or L_BC_2) and L_AC_4)) and EX_BC  # BC may be released behind the train (R9)
        EX_BD = P_BD or L_BD_1  # a train in BD leaves over a boundary, or has passed on
        RTI_BD = VALID and U_BD and (not OCC_BD) and (not (L_BD_1 and (L_BE_1 or L_BE_4))) and EX_BD  # BD may be released behind the train (R9)
        EX_BE = P_BE  # a train in BE leaves over a boundary, or has passed on
        RTI_BE = VALID and U_BE and (not OCC_BE) and (not (L_BE_1 and L_BC_4)) and EX_BE  # BE may be released behind the train (R9)
        EX_CB = P_CB  # a train in CB leaves over a boundary, or has passed on
        RTI_CB = VALID and U_CB and (not OCC_CB) and EX_CB  # CB may be released behind the train (R9)
        EX_CD = P_CD or L_CD_1  # a train in CD leaves over a boundary, or has passed on
        RTI_CD = VALID and U_CD and (not OCC_CD) and (not (L_CD_1 and L_BC_2)) and EX_CD  # CD may be released behind the train (R9)
        EX_GA = P_GA or (L_GA_2 and ((not OCC_SC) or AT_G3))  # a train in GA leaves over a boundary, or has passed on
        RTI_GA = VALID and U_GA and (not OCC_GA) and EX_GA  # GA may be released behind the train (R9)
        EX_GB = P_GB  # a train in GB leaves over a boundary, or has passed on
        RTI_GB = VALID and U_GB and (not OCC_GB) and (not G_R20) and (not (L_SC_2 or L_SC_6)) and EX_GB  # GB may be released behind the train (R9)
        EX_SC = P_SC or (L_SC_2 and (not M_SC) and OCC_GB and ((not OCC_AB) or AT_S1J)) or (L_SC_6 and (not M_SC) and OCC_GB and ((not OCC_GA) or AT_SGJ))  # a train in SC leaves over a boundary, or has passed on
        RTI_SC = VALID and U_SC and (not OCC_SC) and (not ((L_SC_3 or L_SC_4) and L_AC_2)) and EX_SC  # SC may be released behind the train (R9)
        RT_AB = self._timer('RT_AB', RTI_AB, dt_ms)  # AB: release delay (R9)
        RT_AC = self._timer('RT_AC', RTI_AC, dt_ms)  # AC: release delay (R9)
        RT_AD = self._timer('RT_AD', RTI_AD, dt_ms)  # AD: release delay (R9)
        RT_BB = self._timer('RT_BB', RTI_BB, dt_ms)  # BB: release delay (R9)
        RT_BC = self._timer('RT_BC', RTI_BC, dt_ms)  # BC: release delay (R9)
        RT_BD = self._timer('RT_BD', RTI_BD, dt_ms)  # BD: release delay (R9)
        RT_BE = self._timer('RT_BE', RTI_BE, dt_ms)  # BE: release delay (R9)
        RT_CB = self._timer('RT_CB', RTI_CB, dt_ms)  # CB: release delay (R9)
        RT_CD = self._timer('RT_CD', RTI_CD, dt_ms)  # CD: release delay (R9)
        RT_GA = self._timer('RT_GA', RTI_GA, dt_ms)  # GA: release delay (R9)
        RT_GB = self._timer('RT_GB', RTI_GB, dt_ms)  # GB: release delay (R9)
        RT_SC = self._timer('RT_SC', RTI_SC, dt_ms)  # SC: release delay (R9)
        CA_AB = VALID and (not OCC_AB) and (not U_AB) and L_AB_1 and (not (L_AB_1 and L_SC_3))  # the lock before AB was withdrawn (R8)
        HR_AB = VALID and (not OCC_AB) and (not (L_AB_1 and L_SC_3)) and REL_AB and (L_AB_1 or L_AB_2) and ((not L_AB_2) or ((not A_R3) and ((not OCC_AA) or AT_S1)))  # AB released by hand (R8, section fault release)
        SR_AB = VALID and (not OCC_AB) and K_AB and (REL_AB or RELALL)  # AB released after a restart (R16)
        RLS_AB = RT_AB or CA_AB or CD_S1 or HR_AB or SR_AB  # AB is released
        CA_AC = VALID and (not OCC_AC) and (not U_AC) and (L_AC_2 or L_AC_3 or L_AC_4) and (not (L_AC_2 and L_BC_3)) and (not ((L_AC_3 or L_AC_4) and (L_SC_1 or L_SC_5)))  # the lock before AC was withdrawn (R8)
        HR_AC = VALID and (not OCC_AC) and (not (L_AC_2 and L_BC_3)) and (not ((L_AC_3 or L_AC_4) and (L_SC_1 or L_SC_5))) and REL_AC and (L_AC_2 or L_AC_3 or L_AC_4)  # AC released by hand (R8, section fault release)
        SR_AC = VALID and (not OCC_AC) and K_AC and (REL_AC or RELALL)  # AC released after a restart (R16)
        RLS_AC = RT_AC or CA_AC or HR_AC or SR_AC  # AC is released
        CA_AD = VALID and (not OCC_AD) and (not U_AD) and L_AD_1 and (not (L_AD_1 and L_AC_3))  # the lock before AD was withdrawn (R8)
        HR_AD = VALID and (not OCC_AD) and (not (L_AD_1 and L_AC_3)) and REL_AD and L_AD_1  # AD released by hand (R8, section fault release)
        SR_AD = VALID and (not OCC_AD) and K_AD and (REL_AD or RELALL)  # AD released after a restart (R16)
        RLS_AD = RT_AD or CA_AD or HR_AD or SR_AD  # AD is released
        CA_BB = VALID and (not OCC_BB) and (not U_BB) and L_BB_1 and (not (L_BB_1 and L_BC_1))  # the lock before BB was withdrawn (R8)
        HR_BB = VALID and (not OCC_BB) and (not (L_BB_1 and L_BC_1)) and REL_BB and (L_BB_1 or L_BB_2) and ((not L_BB_2) or ((not (A_R8 or A_R9 or A_R10)) and ((not OCC_BA) or AT_S2)))  # BB released by hand (R8, section fault release)
        SR_BB = VALID and (not OCC_BB) and K_BB and (REL_BB or RELALL)  # BB released after a restart (R16)
        RLS_BB = RT_BB or CA_BB or CD_S2 or HR_BB or SR_BB  # BB is released
        CA_BC = VALID and (not OCC_BC) and (not U_BC) and (L_BC_1 or L_BC_2) and (not ((L_BC_1 or L_BC_2) and L_AC_4))  # the lock before BC was withdrawn (R8)
        HR_BC = VALID and (not OCC_BC) and (not ((L_BC_1 or L_BC_2) and L_AC_4)) and REL_BC and (L_BC_1 or L_BC_2 or L_BC_3 or L_BC_4) and ((not (L_BC_3 or L_BC_4)) or ((not (A_R11 or A_R12)) and ((not OCC_BB) or AT_S2J)))  # BC released by hand (R8, section fault release)
        SR_BC = VALID and (not OCC_BC) and K_BC and (REL_BC or RELALL)  # BC released after a restart (R16)
        RLS_BC = RT_BC or CA_BC or CD_S2J or HR_BC or SR_BC  # BC is released
        CA_BD = VALID and (not OCC_BD) and (not U_BD) and L_BD_1 and (not (L_BD_1 and (L_BE_1 or L_BE_4)))  # the lock before BD was withdrawn (R8)
        HR_BD = VALID and (not OCC_BD) and (not (L_BD_1 and (L_BE_1 or L_BE_4))) and REL_BD and L_BD_1  # BD released by hand (R8, section fault release)
        SR_BD = VALID and (not OCC_BD) and K_BD and (REL_BD or RELALL)  # BD released after a restart (R16)
        RLS_BD = RT_BD or CA_BD or HR_BD or SR_BD  # BD is released
        CA_BE = VALID and (not OCC_BE) and (not U_BE) and L_BE_1 and (not (L_BE_1 and L_BC_4))  # the lock before BE was withdrawn (R8)
        HR_BE = VALID and (not OCC_BE) and (not (L_BE_1 and L_BC_4)) and REL_BE and (L_BE_1 or L_BE_4) and ((not L_BE_4) or ((not A_R14) and ((not OCC_CB) or AT_S4J)))  # BE released by hand (R8, section fault release)
        SR_BE = VALID and (not OCC_BE) and K_BE and (REL_BE or RELALL)  # BE released after a restart (R16)
        RLS_BE = RT_BE or CA_BE or CD_S4J or HR_BE or SR_BE  # BE is released
        CA_CB = VALID and (not OCC_CB) and (not U_CB) and False  # the lock before CB was withdrawn (R8)
        HR_CB = VALID and (not OCC_CB) and REL_CB and L_CB_2 and ((not L_CB_2) or ((not A_R13) and ((not OCC_CA) or AT_S4)))  # CB released by hand (R8, section fault release)
        SR_CB = VALID and (not OCC_CB) and K_CB and (REL_CB or RELALL)  # CB released after a restart (R16)
        RLS_CB = RT_CB or CA_CB or CD_S4 or HR_CB or SR_CB  # CB is released
        CA_CD = VALID and (not OCC_CD) and (not U_CD) and L_CD_1 and (not (L_CD_1 and L_BC_2))  # the lock before CD was withdrawn (R8)
        HR_CD = VALID and (not OCC_CD) and (not (L_CD_1 and L_BC_2)) and REL_CD and L_CD_1  # CD released by hand (R8, section fault release)
        SR_CD = VALID and (not OCC_CD) and K_CD and (REL_CD or RELALL)  # CD released after a restart (R16)
        RLS_CD = RT_CD or CA_CD or HR_CD or SR_CD  # CD is released
        CA_GA = VALID and (not OCC_GA) and (not U_GA) and False  # the lock before GA was withdrawn (R8)
        HR_GA = VALID and (not OCC_GA) and REL_GA and (L_GA_1 or L_GA_2) and ((not L_GA_1) or ((not A_R15) and ((not OCC_GX) or AT_SG))) and ((not L_GA_2) or ((not A_R2) and ((not OCC_SC) or AT_G3)))  # GA released by hand (R8, section fault release)
        SR_GA = VALID and (not OCC_GA) and K_GA and (REL_GA or RELALL)  # GA released after a restart (R16)
        RLS_GA = RT_GA or CA_GA or CD_SG or CD_G3 or HR_GA or SR_GA  # GA is released
        AR_GB = VALID and U_GB and (not G_R20) and (not (L_SC_2 or L_SC_6))  # a train has arrived in GB, wholly (R2)
        CA_GB = VALID and (not OCC_GB) and (not U_GB) and L_GB_1 and (not G_R20) and (not (L_SC_2 or L_SC_6))  # the lock before GB was withdrawn (R8)
        HR_GB = VALID and (not OCC_GB) and (not G_R20) and (not (L_SC_2 or L_SC_6)) and REL_GB and L_GB_1  # GB released by hand (R8, section fault release)
        SR_GB = VALID and (not OCC_GB) and K_GB and (REL_GB or RELALL) and (not G_R20) and (not (L_SC_2 or L_SC_6))  # GB released after a restart (R16)
        RLS_GB = RT_GB or CA_GB or HR_GB or SR_GB  # GB is released
        CA_SC = VALID and (not OCC_SC) and (not U_SC) and (L_SC_3 or L_SC_4 or (L_SC_8 and M_SC)) and (not ((L_SC_3 or L_SC_4) and L_AC_2))  # the lock before SC was withdrawn (R8)
        HR_SC = VALID and (not OCC_SC) and (not ((L_SC_3 or L_SC_4) and L_AC_2)) and REL_SC and (L_SC_1 or L_SC_2 or L_SC_3 or L_SC_4 or L_SC_5 or L_SC_6 or L_SC_8) and ((not (L_SC_1 or L_SC_2)) or ((not (A_R4 or A_R5 or A_R6 or A_R7)) and ((not OCC_AB) or AT_S1J))) and ((not (L_SC_5 or L_SC_6)) or ((not (A_R16 or A_R17 or A_R18 or A_R19 or A_R20)) and ((not OCC_GA) or AT_SGJ))) and ((not L_SC_8) or ((not A_R1) and ((not OCC_GB) or AT_G2)))  # SC released by hand (R8, section fault release)
        SR_SC = VALID and (not OCC_SC) and K_SC and (REL_SC or RELALL)  # SC released after a restart (R16)
        RLS_SC = RT_SC or CA_SC or CD_S1J or CD_SGJ or CD_G2 or HR_SC or SR_SC  # SC is released
        OTI_G3 = VALID and U_SC and (not ((L_SC_3 or L_SC_4) and L_AC_2)) and (not ((L_SC_1 or L_SC_2) and OCC_AB)) and (not ((L_SC_5 or L_SC_6) and OCC_GA)) and (L_SC_4 or L_SC_8) and OCC_SC  # the train before G3 is wholly in SC (R4)
        OTI_S2J = VALID and U_BB and (not (L_BB_1 and L_BC_1)) and (not (L_BB_2 and OCC_BA)) and L_BB_2 and OCC_BB  # the train before S2J is wholly in BB (R4)
        OT_G3 = self._timer('OT_G3', OTI_G3, dt_ms)  # G3: the train before it stands (R4)
        OT_S2J = self._timer('OT_S2J', OTI_S2J, dt_ms)  # S2J: the train before it stands (R4)
        OR_G3 = (not (L_SC_4 or L_SC_8)) or OT_G3  # the overlap of G3 is not needed any more (R4)
        OR_S2J = (not L_BB_2) or OT_S2J  # the overlap of S2J is not needed any more (R4)
        TG_101 = (GW_AC_2 or GO_S2J_2 or GO_S2J_3 or GW_AC_3 or GW_AC_4 or GW_BC_4 or GO_S2J_1)  # a grant touches machine 101 in this scan
        GPN_101 = (GW_AC_3 or GW_BC_4 or GO_S2J_1)  # a grant needs 101 N
        MAN_101 = MN_101 and (not MR_101) and MOV_101 and (not TG_101)  # machine 101 moved N by hand
        GPR_101 = (GW_AC_2 or GO_S2J_2 or GO_S2J_3 or GW_AC_4)  # a grant needs 101 R
        MAR_101 = MR_101 and (not MN_101) and MOV_101 and (not TG_101)  # machine 101 moved R by hand
        HDN_101 = CN_101 and (not GPR_101) and (not MAR_101)  # the command N stays
        HDR_101 = CR_101 and (not GPN_101) and (not MAN_101)  # the command R stays
        TG_102 = (GW_BE_1 or GO_S2J_1 or GW_BE_4)  # a grant touches machine 102 in this scan
        GPN_102 = (GW_BE_1 or GO_S2J_1)  # a grant needs 102 N
        MAN_102 = MN_102 and (not MR_102) and MOV_102 and (not TG_102)  # machine 102 moved N by hand
        GPR_102 = GW_BE_4  # a grant needs 102 R
        MAR_102 = MR_102 and (not MN_102) and MOV_102 and (not TG_102)  # machine 102 moved R by hand
        HDN_102 = CN_102 and (not GPR_102) and (not MAR_102)  # the command N stays
        HDR_102 = CR_102 and (not GPN_102) and (not MAN_102)  # the command R stays
        TG_201a = (GW_BC_1 or GW_BC_2 or GW_BC_3 or GO_S2J_2 or GO_S2J_3 or GW_BC_4 or GO_S2J_1)  # a grant touches machine 201a in this scan
        GPN_201a = (GW_BC_2 or GW_BC_4 or GO_S2J_1)  # a grant needs 201a N
        MAN_201a = MN_201a and (not MR_201a) and MOV_201a and (not TG_201a)  # machine 201a moved N by hand
        GPR_201a = (GW_BC_1 or GW_BC_3 or GO_S2J_2 or GO_S2J_3)  # a grant needs 201a R
        MAR_201a = MR_201a and (not MN_201a) and MOV_201a and (not TG_201a)  # machine 201a moved R by hand
        HDN_201a = CN_201a and (not GPR_201a) and (not MAR_201a)  # the command N stays
        HDR_201a = CR_201a and (not GPN_201a) and (not MAN_201a)  # the command R stays
        TG_201b = (GW_AC_3 or GW_BC_1 or GW_BC_2 or GW_BC_3 or GO_S2J_2 or GO_S2J_3 or GW_BC_4 or GO_S2J_1 or GW_BE_4 or GW_SC_2 or GW_SC_6 or GW_SC_8)  # a grant touches machine 201b in this scan
        GPN_201b = (GW_AC_3 or GW_BC_2 or GW_BC_4 or GO_S2J_1 or GW_SC_2 or GW_SC_6 or GW_SC_8)  # a grant needs 201b N
        MAN_201b = MN_201b and (not MR_201b) and MOV_201b and (not TG_201b)  # machine 201b moved N by hand
        GPR_201b = (GW_BC_1 or GW_BC_3 or GO_S2J_2 or GO_S2J_3 or GW_BE_4)  # a grant needs 201b R
        MAR_201b = MR_201b and (not MN_201b) and MOV_201b and (not TG_201b)  # machine 201b moved R by hand
        HDN_201b = CN_201b and (not GPR_201b) and (not MAR_201b)  # the command N stays
        HDR_201b = CR_201b and (not GPN_201b) and (not MAN_201b)  # the command R stays
        TG_210a = (GW_SC_1 or GW_SC_2 or GO_S2J_2 or GW_SC_4 or GO_S2J_3 or GW_SC_5 or GW_SC_6 or GW_SC_8)  # a grant touches machine 210a in this scan
        GPN_210a = (GW_SC_1 or GW_SC_2 or GO_S2J_2)  # a grant needs 210a N
        MAN_210a = MN_210a and (not MR_210a) and MOV_210a and (not TG_210a)  # machine 210a moved N by hand
        GPR_210a = (GW_SC_4 or GO_S2J_3 or GW_SC_5 or GW_SC_6 or GW_SC_8)  # a grant needs 210a R
        MAR_210a = MR_210a and (not MN_210a) and MOV_210a and (not TG_210a)  # machine 210a moved R by hand
        HDN_210a = CN_210a and (not GPR_210a) and (not MAR_210a)  # the command N stays
        HDR_210a = CR_210a and (not GPN_210a) and (not MAN_210a)  # the command R stays
        TG_210b = (GW_SC_1 or GW_SC_2 or GO_S2J_2 or GW_SC_4 or GO_S2J_3 or GW_SC_5 or GW_SC_6 or GW_SC_8)  # a grant touches machine 210b in this scan
        GPN_210b = (GW_SC_1 or GO_S2J_2 or GW_SC_4 or GO_S2J_3 or GW_SC_5)  # a grant needs 210b N
        MAN_210b = MN_210b and (not MR_210b) and MOV_210b and (not TG_210b)  # machine 210b moved N by hand
        GPR_210b = (GW_SC_2 or GW_SC_6 or GW_SC_8)  # a grant needs 210b R
        MAR_210b = MR_210b and (not MN_210b) and MOV_210b and (not TG_210b)  # machine 210b moved R by hand
        HDN_210b = CN_210b and (not GPR_210b) and (not MAR_210b)  # the command N stays
        HDR_210b = CR_210b and (not GPN_210b) and (not MAN_210b)  # the command R stays
        STI_101 = (CN_101 and (not QN_101)) or (CR_101 and (not QR_101))  # machine 101 is not where it was commanded
        STI_102 = (CN_102 and (not QN_102)) or (CR_102 and (not QR_102))  # machine 102 is not where it was commanded
        STI_201a = (CN_201a and (not QN_201a)) or (CR_201a and (not QR_201a))  # machine 201a is not where it was commanded
        STI_201b = (CN_201b and (not QN_201b)) or (CR_201b and (not QR_201b))  # machine 201b is not where it was commanded
        STI_210a = (CN_210a and (not QN_210a)) or (CR_210a and (not QR_210a))  # machine 210a is not where it was commanded
        STI_210b = (CN_210b and (not QN_210b)) or (CR_210b and (not QR_210b))  # machine 210b is not where it was commanded
        ST_101 = self._timer('ST_101', STI_101, dt_ms)  # machine 101: time-out
        ST_102 = self._timer('ST_102', STI_102, dt_ms)  # machine 102: time-out
        ST_201a = self._timer('ST_201a', STI_201a, dt_ms)  # machine 201a: time-out
        ST_201b = self._timer('ST_201b', STI_201b, dt_ms)  # machine 201b: time-out
        ST_210a = self._timer('ST_210a', STI_210a, dt_ms)  # machine 210a: time-out
        ST_210b = self._timer('ST_210b', STI_210b, dt_ms)  # machine 210b: time-out
        KP_R1 = (not NU_SC_4) and (not CD_G2)  # route G2-G3 stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_G2) and (not CAN_G2)  # proceed for route G2-G3 (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route G2-G3: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_GA_2) and (not CD_G3)  # route G3-G stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_G3) and (not CAN_G3)  # proceed for route G3-G (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route G3-G: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_AB_2) and (not CD_S1)  # route S1-S1J stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_S1) and (not CAN_S1)  # proceed for route S1-S1J (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route S1-S1J: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_SC_1) and (not CD_S1J)  # route S1J-DB stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_S1J) and (not CAN_S1J)  # proceed for route S1J-DB (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route S1J-DB: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_SC_1) and (not CD_S1J)  # route S1J-DM2 stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_S1J) and (not CAN_S1J)  # proceed for route S1J-DM2 (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route S1J-DM2: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_SC_1) and (not CD_S1J)  # route S1J-GN stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_S1J) and (not CAN_S1J)  # proceed for route S1J-GN (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route S1J-GN: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_SC_1) and (not CD_S1J)  # route S1J-UM2 stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_S1J) and (not CAN_S1J)  # proceed for route S1J-UM2 (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route S1J-UM2: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_BB_2) and (not CD_S2)  # route S2-S2J stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_S2) and (not CAN_S2)  # proceed for route S2-S2J (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route S2-S2J: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_BB_2) and (not CD_S2)  # route S2-S2J.o2 stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_S2) and (not CAN_S2)  # proceed for route S2-S2J.o2 (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route S2-S2J.o2: a condition was lost; no reopening by itself (R14)
        KP_R10 = (not NU_BB_2) and (not CD_S2)  # route S2-S2J.o3 stays set
        PR_R10 = A_R10 and B_R10 and W_R10 and CO_R10 and KP_R10 and (not X_S2) and (not CAN_S2)  # proceed for route S2-S2J.o3 (R3, R11)
        LS_R10 = S_R10 and (not CO_R10)  # route S2-S2J.o3: a condition was lost; no reopening by itself (R14)
        KP_R11 = (not NU_BC_2) and (not CD_S2J)  # route S2J-G3 stays set
        PR_R11 = A_R11 and B_R11 and W_R11 and CO_R11 and KP_R11 and (not X_S2J) and (not CAN_S2J)  # proceed for route S2J-G3 (R3, R11)
        LS_R11 = S_R11 and (not CO_R11)  # route S2J-G3: a condition was lost; no reopening by itself (R14)
        KP_R12 = (not NU_BC_2) and (not CD_S2J)  # route S2J-UM stays set
        PR_R12 = A_R12 and B_R12 and W_R12 and CO_R12 and KP_R12 and (not X_S2J) and (not CAN_S2J)  # proceed for route S2J-UM (R3, R11)
        LS_R12 = S_R12 and (not CO_R12)  # route S2J-UM: a condition was lost; no reopening by itself (R14)
        KP_R13 = (not NU_CB_2) and (not CD_S4)  # route S4-S4J stays set
        PR_R13 = A_R13 and B_R13 and W_R13 and CO_R13 and KP_R13 and (not X_S4) and (not CAN_S4)  # proceed for route S4-S4J (R3, R11)
        LS_R13 = S_R13 and (not CO_R13)  # route S4-S4J: a condition was lost; no reopening by itself (R14)
        KP_R14 = (not NU_BE_3) and (not CD_S4J)  # route S4J-UM stays set
        PR_R14 = A_R14 and B_R14 and W_R14 and CO_R14 and KP_R14 and (not X_S4J) and (not CAN_S4J)  # proceed for route S4J-UM (R3, R11)
        LS_R14 = S_R14 and (not CO_R14)  # route S4J-UM: a condition was lost; no reopening by itself (R14)
        KP_R15 = (not NU_GA_1) and (not CD_SG)  # route SG-SGJ stays set
        PR_R15 = A_R15 and B_R15 and W_R15 and CO_R15 and KP_R15 and (not X_SG) and (not CAN_SG)  # proceed for route SG-SGJ (R3, R11)
        LS_R15 = S_R15 and (not CO_R15)  # route SG-SGJ: a condition was lost; no reopening by itself (R14)
        KP_R16 = (not NU_SC_3) and (not CD_SGJ)  # route SGJ-DB stays set
        PR_R16 = A_R16 and B_R16 and W_R16 and CO_R16 and KP_R16 and (not X_SGJ) and (not CAN_SGJ)  # proceed for route SGJ-DB (R3, R11)
        LS_R16 = S_R16 and (not CO_R16)  # route SGJ-DB: a condition was lost; no reopening by itself (R14)
        KP_R17 = (not NU_SC_3) and (not CD_SGJ)  # route SGJ-DM2 stays set
        PR_R17 = A_R17 and B_R17 and W_R17 and CO_R17 and KP_R17 and (not X_SGJ) and (not CAN_SGJ)  # proceed for route SGJ-DM2 (R3, R11)
        LS_R17 = S_R17 and (not CO_R17)  # route SGJ-DM2: a condition was lost; no reopening by itself (R14)
        KP_R18 = (not NU_SC_3) and (not CD_SGJ)  # route SGJ-GN stays set
        PR_R18 = A_R18 and B_R18 and W_R18 and CO_R18 and KP_R18 and (not X_SGJ) and (not CAN_SGJ)  # proceed for route SGJ-GN (R3, R11)
        LS_R18 = S_R18 and (not CO_R18)  # route SGJ-GN: a condition was lost; no reopening by itself (R14)
        KP_R19 = (not NU_SC_3) and (not CD_SGJ)  # route SGJ-UM2 stays set
        PR_R19 = A_R19 and B_R19 and W_R19 and CO_R19 and KP_R19 and (not X_SGJ) and (not CAN_SGJ)  # proceed for route SGJ-UM2 (R3, R11)
        LS_R19 = S_R19 and (not CO_R19)  # route SGJ-UM2: a condition was lost; no reopening by itself (R14)
        KP_R20 = (not NU_SC_3) and (not CD_SGJ)  # route SGJ-GN.s stays set
        PR_R20 = A_R20 and B_R20 and W_R20 and CO_R20 and KP_R20 and (not X_SGJ) and (not CAN_SGJ)  # proceed for route SGJ-GN.s (R3, R11)
        LS_R20 = S_R20 and (not CO_R20)  # route SGJ-GN.s: a condition was lost; no reopening by itself (R14)
        N_CN_101 = GPN_101 or MAN_101 or HDN_101  # machine 101 commanded N
        N_CR_101 = GPR_101 or MAR_101 or HDR_101  # machine 101 commanded R
        N_CN_102 = GPN_102 or MAN_102 or HDN_102  # machine 102 commanded N
        N_CR_102 = GPR_102 or MAR_102 or HDR_102  # machine 102 commanded R
        N_CN_201a = GPN_201a or MAN_201a or HDN_201a  # machine 201a commanded N
        N_CR_201a = GPR_201a or MAR_201a or HDR_201a  # machine 201a commanded R
        N_CN_201b = GPN_201b or MAN_201b or HDN_201b  # machine 201b commanded N
        N_CR_201b = GPR_201b or MAR_201b or HDR_201b  # machine 201b commanded R
        N_CN_210a = GPN_210a or MAN_210a or HDN_210a  # machine 210a commanded N
        N_CR_210a = GPR_210a or MAR_210a or HDR_210a  # machine 210a commanded R
        N_CN_210b = GPN_210b or MAN_210b or HDN_210b  # machine 210b commanded N
        N_CR_210b = GPR_210b or MAR_210b or HDR_210b  # machine 210b commanded R
        N_AL_101 = ST_101  # alarm: machine 101 not detected
        N_AL_102 = ST_102  # alarm: machine 102 not detected
        N_AL_201a = ST_201a  # alarm: machine 201a not detected
        N_AL_201b = ST_201b  # alarm: machine 201b not detected
        N_AL_210a = ST_210a  # alarm: machine 210a not detected
        N_AL_210b = ST_210b  # alarm: machine 210b not detected
        N_TH_101 = ((CN_101 and QN_101) or (CR_101 and QR_101)) and (not (GPN_101 or GPR_101 or MAN_101 or MAR_101))  # machine 101 was detected where it is commanded
        N_TR_101 = (TH_101 and VALID and ((CN_101 and (not QN_101) and (not GPR_101) and (not MAR_101)) or (CR_101 and (not QR_101) and (not GPN_101) and (not MAN_101)))) or (TR_101 and (not (TC_101 and VALID and (not OCC_AC))))  # machine 101 was trailed
        N_TH_102 = ((CN_102 and QN_102) or (CR_102 and QR_102)) and (not (GPN_102 or GPR_102 or MAN_102 or MAR_102))  # machine 102 was detected where it is commanded
        N_TR_102 = (TH_102 and VALID and ((CN_102 and (not QN_102) and (not GPR_102) and (not MAR_102)) or (CR_102 and (not QR_102) and (not GPN_102) and (not MAN_102)))) or (TR_102 and (not (TC_102 and VALID and (not OCC_BE))))  # machine 102 was trailed
        N_TH_201a = ((CN_201a and QN_201a) or (CR_201a and QR_201a)) and (not (GPN_201a or GPR_201a or MAN_201a or MAR_201a))  # machine 201a was detected where it is commanded
        N_TR_201a = (TH_201a and VALID and ((CN_201a and (not QN_201a) and (not GPR_201a) and (not MAR_201a)) or (CR_201a and (not QR_201a) and (not GPN_201a) and (not MAN_201a)))) or (TR_201a and (not (TC_201a and VALID and (not OCC_BC))))  # machine 201a was trailed
        N_TH_201b = ((CN_201b and QN_201b) or (CR_201b and QR_201b)) and (not (GPN_201b or GPR_201b or MAN_201b or MAR_201b))  # machine 201b was detected where it is commanded
        N_TR_201b = (TH_201b and VALID and ((CN_201b and (not QN_201b) and (not GPR_201b) and (not MAR_201b)) or (CR_201b and (not QR_201b) and (not GPN_201b) and (not MAN_201b)))) or (TR_201b and (not (TC_201b and VALID and (not OCC_BC))))  # machine 201b was trailed
        N_TH_210a = ((CN_210a and QN_210a) or (CR_210a and QR_210a)) and (not (GPN_210a or GPR_210a or MAN_210a or MAR_210a))  # machine 210a was detected where it is commanded
        N_TR_210a = (TH_210a and VALID and ((CN_210a and (not QN_210a) and (not GPR_210a) and (not MAR_210a)) or (CR_210a and (not QR_210a) and (not GPN_210a) and (not MAN_210a)))) or (TR_210a and (not (TC_210a and VALID and (not OCC_SC))))  # machine 210a was trailed
        N_TH_210b = ((CN_210b and QN_210b) or (CR_210b and QR_210b)) and (not (GPN_210b or GPR_210b or MAN_210b or MAR_210b))  # machine 210b was detected where it is commanded
        N_TR_210b = (TH_210b and VALID and ((CN_210b and (not QN_210b) and (not GPR_210b) and (not MAR_210b)) or (CR_210b and (not QR_210b) and (not GPN_210b) and (not MAN_210b)))) or (TR_210b and (not (TC_210b and VALID and (not OCC_SC))))  # machine 210b was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route G2-G3 active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route G2-G3 locked
        N_W_R1 = (W_R1 or LK_R1 or ((REQ == 1) and B_R1)) and (not LS_R1) and KP_R1 and (not X_G2) and (not CAN_G2)  # route G2-G3: proceed wanted
        N_S_R1 = PR_R1  # route G2-G3: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route G2-G3: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route G3-G active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route G3-G locked
        N_W_R2 = (W_R2 or LK_R2 or ((REQ == 2) and B_R2)) and (not LS_R2) and KP_R2 and (not X_G3) and (not CAN_G3)  # route G3-G: proceed wanted
        N_S_R2 = PR_R2  # route G3-G: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route G3-G: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route S1-S1J active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route S1-S1J locked
        N_W_R3 = (W_R3 or LK_R3 or ((REQ == 3) and B_R3)) and (not LS_R3) and KP_R3 and (not X_S1) and (not CAN_S1)  # route S1-S1J: proceed wanted
        N_S_R3 = PR_R3  # route S1-S1J: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route S1-S1J: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route S1J-DB active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route S1J-DB locked
        N_W_R4 = (W_R4 or LK_R4 or ((REQ == 4) and B_R4)) and (not LS_R4) and KP_R4 and (not X_S1J) and (not CAN_S1J)  # route S1J-DB: proceed wanted
        N_S_R4 = PR_R4  # route S1J-DB: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route S1J-DB: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route S1J-DM2 active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route S1J-DM2 locked
        N_W_R5 = (W_R5 or LK_R5 or ((REQ == 5) and B_R5)) and (not LS_R5) and KP_R5 and (not X_S1J) and (not CAN_S1J)  # route S1J-DM2: proceed wanted
        N_S_R5 = PR_R5  # route S1J-DM2: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route S1J-DM2: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route S1J-GN active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route S1J-GN locked
        N_W_R6 = (W_R6 or LK_R6 or ((REQ == 6) and B_R6)) and (not LS_R6) and KP_R6 and (not X_S1J) and (not CAN_S1J)  # route S1J-GN: proceed wanted
        N_S_R6 = PR_R6  # route S1J-GN: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route S1J-GN: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route S1J-UM2 active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route S1J-UM2 locked
        N_W_R7 = (W_R7 or LK_R7 or ((REQ == 7) and B_R7)) and (not LS_R7) and KP_R7 and (not X_S1J) and (not CAN_S1J)  # route S1J-UM2: proceed wanted
        N_S_R7 = PR_R7  # route S1J-UM2: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route S1J-UM2: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route S2-S2J active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route S2-S2J locked
        N_W_R8 = (W_R8 or LK_R8 or ((REQ == 8) and B_R8)) and (not LS_R8) and KP_R8 and (not X_S2) and (not CAN_S2)  # route S2-S2J: proceed wanted
        N_S_R8 = PR_R8  # route S2-S2J: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route S2-S2J: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route S2-S2J.o2 active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route S2-S2J.o2 locked
        N_W_R9 = (W_R9 or LK_R9 or ((REQ == 9) and B_R9)) and (not LS_R9) and KP_R9 and (not X_S2) and (not CAN_S2)  # route S2-S2J.o2: proceed wanted
        N_S_R9 = PR_R9  # route S2-S2J.o2: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route S2-S2J.o2: signal has been open
        N_A_R10 = (A_R10 or G_R10) and KP_R10  # route S2-S2J.o3 active
        N_B_R10 = (B_R10 or LK_R10) and KP_R10  # route S2-S2J.o3 locked
        N_W_R10 = (W_R10 or LK_R10 or ((REQ == 10) and B_R10)) and (not LS_R10) and KP_R10 and (not X_S2) and (not CAN_S2)  # route S2-S2J.o3: proceed wanted
        N_S_R10 = PR_R10  # route S2-S2J.o3: proceed
        N_H_R10 = (H_R10 or PR_R10) and KP_R10  # route S2-S2J.o3: signal has been open
        N_A_R11 = (A_R11 or G_R11) and KP_R11  # route S2J-G3 active
        N_B_R11 = (B_R11 or LK_R11) and KP_R11  # route S2J-G3 locked
        N_W_R11 = (W_R11 or LK_R11 or ((REQ == 11) and B_R11)) and (not LS_R11) and KP_R11 and (not X_S2J) and (not CAN_S2J)  # route S2J-G3: proceed wanted
        N_S_R11 = PR_R11  # route S2J-G3: proceed
        N_H_R11 = (H_R11 or PR_R11) and KP_R11  # route S2J-G3: signal has been open
        N_A_R12 = (A_R12 or G_R12) and KP_R12  # route S2J-UM active
        N_B_R12 = (B_R12 or LK_R12) and KP_R12  # route S2J-UM locked
        N_W_R12 = (W_R12 or LK_R12 or ((REQ == 12) and B_R12)) and (not LS_R12) and KP_R12 and (not X_S2J) and (not CAN_S2J)  # route S2J-UM: proceed wanted
        N_S_R12 = PR_R12  # route S2J-UM: proceed
        N_H_R12 = (H_R12 or PR_R12) and KP_R12  # route S2J-UM: signal has been open
        N_A_R13 = (A_R13 or G_R13) and KP_R13  # route S4-S4J active
        N_B_R13 = (B_R13 or LK_R13) and KP_R13  # route S4-S4J locked
        N_W_R13 = (W_R13 or LK_R13 or ((REQ == 13) and B_R13)) and (not LS_R13) and KP_R13 and (not X_S4) and (not CAN_S4)  # route S4-S4J: proceed wanted
        N_S_R13 = PR_R13  # route S4-S4J: proceed
        N_H_R13 = (H_R13 or PR_R13) and KP_R13  # route S4-S4J: signal has been open
        N_A_R14 = (A_R14 or G_R14) and KP_R14  # route S4J-UM active
        N_B_R14 = (B_R14 or LK_R14) and KP_R14  # route S4J-UM locked
        N_W_R14 = (W_R14 or LK_R14 or ((REQ == 14) and B_R14)) and (not LS_R14) and KP_R14 and (not X_S4J) and (not CAN_S4J)  # route S4J-UM: proceed wanted
        N_S_R14 = PR_R14  # route S4J-UM: proceed
        N_H_R14 = (H_R14 or PR_R14) and KP_R14  # route S4J-UM: signal has been open
        N_A_R15 = (A_R15 or G_R15) and KP_R15  # route SG-SGJ active
        N_B_R15 = (B_R15 or LK_R15) and KP_R15  # route SG-SGJ locked
        N_W_R15 = (W_R15 or LK_R15 or ((REQ == 15) and B_R15)) and (not LS_R15) and KP_R15 and (not X_SG) and (not CAN_SG)  # route SG-SGJ: proceed wanted
        N_S_R15 = PR_R15  # route SG-SGJ: proceed
        N_H_R15 = (H_R15 or PR_R15) and KP_R15  # route SG-SGJ: signal has been open
        N_A_R16 = (A_R16 or G_R16) and KP_R16  # route SGJ-DB active
        N_B_R16 = (B_R16 or LK_R16) and KP_R16  # route SGJ-DB locked
        N_W_R16 = (W_R16 or LK_R16 or ((REQ == 16) and B_R16)) and (not LS_R16) and KP_R16 and (not X_SGJ) and (not CAN_SGJ)  # route SGJ-DB: proceed wanted
        N_S_R16 = PR_R16  # route SGJ-DB: proceed
        N_H_R16 = (H_R16 or PR_R16) and KP_R16  # route SGJ-DB: signal has been open
        N_A_R17 = (A_R17 or G_R17) and KP_R17  # route SGJ-DM2 active
        N_B_R17 = (B_R17 or LK_R17) and KP_R17  # route SGJ-DM2 locked
        N_W_R17 = (W_R17 or LK_R17 or ((REQ == 17) and B_R17)) and (not LS_R17) and KP_R17 and (not X_SGJ) and (not CAN_SGJ)  # route SGJ-DM2: proceed wanted
        N_S_R17 = PR_R17  # route SGJ-DM2: proceed
        N_H_R17 = (H_R17 or PR_R17) and KP_R17  # route SGJ-DM2: signal has been open
        N_A_R18 = (A_R18 or G_R18) and KP_R18  # route SGJ-GN active
        N_B_R18 = (B_R18 or LK_R18) and KP_R18  # route SGJ-GN locked
        N_W_R18 = (W_R18 or LK_R18 or ((REQ == 18) and B_R18)) and (not LS_R18) and KP_R18 and (not X_SGJ) and (not CAN_SGJ)  # route SGJ-GN: proceed wanted
        N_S_R18 = PR_R18  # route SGJ-GN: proceed
        N_H_R18 = (H_R18 or PR_R18) and KP_R18  # route SGJ-GN: signal has been open
        N_A_R19 = (A_R19 or G_R19) and KP_R19  # route SGJ-UM2 active
        N_B_R19 = (B_R19 or LK_R19) and KP_R19  # route SGJ-UM2 locked
        N_W_R19 = (W_R19 or LK_R19 or ((REQ == 19) and B_R19)) and (not LS_R19) and KP_R19 and (not X_SGJ) and (not CAN_SGJ)  # route SGJ-UM2: proceed wanted
        N_S_R19 = PR_R19  # route SGJ-UM2: proceed
        N_H_R19 = (H_R19 or PR_R19) and KP_R19  # route SGJ-UM2: signal has been open
        N_A_R20 = (A_R20 or G_R20) and KP_R20  # route SGJ-GN.s active
        N_B_R20 = (B_R20 or LK_R20) and KP_R20  # route SGJ-GN.s locked
        N_W_R20 = (W_R20 or LK_R20 or ((REQ == 20) and B_R20)) and (not LS_R20) and KP_R20 and (not X_SGJ) and (not CAN_SGJ)  # route SGJ-GN.s: proceed wanted
        N_S_R20 = PR_R20  # route SGJ-GN.s: proceed
        N_H_R20 = (H_R20 or PR_R20) and KP_R20  # route SGJ-GN.s: signal has been open
        N_X_G2 = (X_G2 or CAN_G2) and A_R1 and (not CD_G2)  # G2: cancelling
        N_X_G3 = (X_G3 or CAN_G3) and A_R2 and (not CD_G3)  # G3: cancelling
        N_X_S1 = (X_S1 or CAN_S1) and A_R3 and (not CD_S1)  # S1: cancelling
        N_X_S1J = (X_S1J or CAN_S1J) and (A_R4 or A_R5 or A_R6 or A_R7) and (not CD_S1J)  # S1J: cancelling
        N_X_S2 = (X_S2 or CAN_S2) and (A_R8 or A_R9 or A_R10) and (not CD_S2)  # S2: cancelling
        N_X_S2J = (X_S2J or CAN_S2J) and (A_R11 or A_R12) and (not CD_S2J)  # S2J: cancelling
        N_X_S4 = (X_S4 or CAN_S4) and A_R13 and (not CD_S4)  # S4: cancelling
        N_X_S4J = (X_S4J or CAN_S4J) and A_R14 and (not CD_S4J)  # S4J: cancelling
        N_X_SG = (X_SG or CAN_SG) and A_R15 and (not CD_SG)  # SG: cancelling
        N_X_SGJ = (X_SGJ or CAN_SGJ) and (A_R16 or A_R17 or A_R18 or A_R19 or A_R20) and (not CD_SGJ)  # SGJ: cancelling
        N_K_AB = K_AB and (not RLS_AB)  # AB: restart lock (R16)
        N_L_AB_1 = L_AB_1 and (not RLS_AB)  # AB locked from AB|SC@210.1a to DM
        N_L_AB_2 = (L_AB_2 or GW_AB_2) and (not RLS_AB)  # AB locked from DM to AB|SC@210.1a
        N_M_AB = (M_AB or G_R3) and (not RLS_AB)  # AB locked for a train movement
        N_F_AB = (F_AB or LK_R3) and (not RLS_AB)  # AB firmly locked
        N_U_AB = (U_AB or NU_AB_1 or NU_AB_2) and (not RLS_AB)  # AB used by a train (R9)
        N_P_AB = (P_AB or (U_AB and OCC_AB and NU_SC_1)) and (not RLS_AB)  # AB: the train went on (R9)
        N_D_AB = (D_AB or ((not VALID) and (L_AB_1 or L_AB_2))) and (not RLS_AB)  # AB: detection is not relied on, inputs were lost or a train is called on
        N_K_AC = K_AC and (not RLS_AC)  # AC: restart lock (R16)
        N_L_AC_2 = (L_AC_2 or GW_AC_2) and (not RLS_AC)  # AC locked from AC|BC@101.reverse to AC|SC@101.toe
        N_L_AC_3 = (L_AC_3 or GW_AC_3) and (not RLS_AC)  # AC locked from AC|SC@101.toe to AC|AD@101.normal
        N_L_AC_4 = (L_AC_4 or GW_AC_4) and (not RLS_AC)  # AC locked from AC|SC@101.toe to AC|BC@101.reverse
        N_M_AC = (M_AC or G_R11 or G_R5 or G_R17 or G_R4 or G_R7 or G_R16 or G_R19) and (not RLS_AC)  # AC locked for a train movement
        N_F_AC = (F_AC or LK_R11 or LK_R5 or LK_R17 or LK_R4 or LK_R7 or LK_R16 or LK_R19) and (not RLS_AC)  # AC firmly locked
        N_U_AC = (U_AC or NU_AC_2 or NU_AC_3) and (not RLS_AC)  # AC used by a train (R9)
        N_P_AC = (P_AC or (U_AC and OCC_AC and (NU_AD_1 or NU_BC_1 or NU_SC_2))) and (not RLS_AC)  # AC: the train went on (R9)
        N_D_AC = (D_AC or ((not VALID) and (L_AC_2 or L_AC_3 or L_AC_4))) and (not RLS_AC)  # AC: detection is not relied on, inputs were lost or a train is called on
        N_K_AD = K_AD and (not RLS_AD)  # AD: restart lock (R16)
        N_L_AD_1 = (L_AD_1 or GW_AD_1) and (not RLS_AD)  # AD locked from AC|AD@101.normal to DM2
        N_M_AD = (M_AD or G_R5 or G_R17) and (not RLS_AD)  # AD locked for a train movement
        N_F_AD = (F_AD or LK_R5 or LK_R17) and (not RLS_AD)  # AD firmly locked
        N_U_AD = (U_AD or NU_AD_1) and (not RLS_AD)  # AD used by a train (R9)
        N_P_AD = P_AD and (not RLS_AD)  # AD: the train went on (R9)
        N_D_AD = (D_AD or ((not VALID) and L_AD_1)) and (not RLS_AD)  # AD: detection is not relied on, inputs were lost or a train is called on
        N_K_BB = K_BB and (not RLS_BB)  # BB: restart lock (R16)
        N_L_BB_1 = (L_BB_1 or GW_BB_1) and (not RLS_BB)  # BB locked from BB|BC@201.2b to UM2
        N_L_BB_2 = (L_BB_2 or GW_BB_2) and (not RLS_BB)  # BB locked from UM2 to BB|BC@201.2b
        N_M_BB = (M_BB or G_R7 or G_R19 or G_R8 or G_R9 or G_R10) and (not RLS_BB)  # BB locked for a train movement
        N_F_BB = (F_BB or LK_R7 or LK_R19 or LK_R8 or LK_R9 or LK_R10) and (not RLS_BB)  # BB firmly locked
        N_U_BB = (U_BB or NU_BB_1 or NU_BB_2) and (not RLS_BB)  # BB used by a train (R9)
        N_P_BB = (P_BB or (U_BB and OCC_BB and NU_BC_2)) and (not RLS_BB)  # BB: the train went on (R9)
        N_D_BB = (D_BB or ((not VALID) and (L_BB_1 or L_BB_2))) and (not RLS_BB)  # BB: detection is not relied on, inputs were lost or a train is called on
        N_K_BC = K_BC and (not RLS_BC)  # BC: restart lock (R16)
        N_L_BC_1 = (L_BC_1 or GW_BC_1) and (not RLS_BC)  # BC locked from AC|BC@101.reverse to BB|BC@201.2b
        N_L_BC_2 = (L_BC_2 or GW_BC_2) and (not RLS_BC)  # BC locked from AC|BC@101.reverse to BC|CD@201.1b
        N_L_BC_3 = (L_BC_3 or GW_BC_3) and (not RLS_BC)  # BC locked from BB|BC@201.2b to AC|BC@101.reverse
        N_L_BC_4 = (L_BC_4 or GW_BC_4) and (not RLS_BC)  # BC locked from BB|BC@201.2b to BC|BE@102.normal
        N_M_BC = (M_BC or G_R7 or G_R19 or G_R4 or G_R16 or G_R11 or G_R12) and (not RLS_BC)  # BC locked for a train movement
        N_F_BC = (F_BC or LK_R7 or LK_R19 or LK_R4 or LK_R16 or LK_R11 or LK_R12) and (not RLS_BC)  # BC firmly locked
        N_U_BC = (U_BC or NU_BC_1 or NU_BC_2) and (not RLS_BC)  # BC used by a train (R9)
        N_P_BC = (P_BC or (U_BC and OCC_BC and (NU_AC_2 or NU_BB_1 or NU_BE_1 or NU_CD_1))) and (not RLS_BC)  # BC: the train went on (R9)
        N_D_BC = (D_BC or ((not VALID) and (L_BC_1 or L_BC_2 or L_BC_3 or L_BC_4))) and (not RLS_BC)  # BC: detection is not relied on, inputs were lost or a train is called on
        N_K_BD = K_BD and (not RLS_BD)  # BD: restart lock (R16)
        N_L_BD_1 = (L_BD_1 or GW_BD_1) and (not RLS_BD)  # BD locked from BD|BE@102.toe to UM
        N_M_BD = (M_BD or G_R12 or G_R14) and (not RLS_BD)  # BD locked for a train movement
        N_F_BD = (F_BD or LK_R12 or LK_R14) and (not RLS_BD)  # BD firmly locked
        N_U_BD = (U_BD or NU_BD_1) and (not RLS_BD)  # BD used by a train (R9)
        N_P_BD = P_BD and (not RLS_BD)  # BD: the train went on (R9)
        N_D_BD = (D_BD or ((not VALID) and L_BD_1)) and (not RLS_BD)  # BD: detection is not relied on, inputs were lost or a train is called on
        N_K_BE = K_BE and (not RLS_BE)  # BE: restart lock (R16)
        N_L_BE_1 = (L_BE_1 or GW_BE_1) and (not RLS_BE)  # BE locked from BC|BE@102.normal to BD|BE@102.toe
        N_L_BE_4 = (L_BE_4 or GW_BE_4) and (not RLS_BE)  # BE locked from BE|CB@102.reverse to BD|BE@102.toe
        N_M_BE = (M_BE or G_R12 or G_R14) and (not RLS_BE)  # BE locked for a train movement
        N_F_BE = (F_BE or LK_R12 or LK_R14) and (not RLS_BE)  # BE firmly locked
        N_U_BE = (U_BE or NU_BE_1 or NU_BE_3) and (not RLS_BE)  # BE used by a train (R9)
        N_P_BE = (P_BE or (U_BE and OCC_BE and NU_BD_1)) and (not RLS_BE)  # BE: the train went on (R9)
        N_D_BE = (D_BE or ((not VALID) and (L_BE_1 or L_BE_4))) and (not RLS_BE)  # BE: detection is not relied on, inputs were lost or a train is called on
        N_K_CB = K_CB and (not RLS_CB)  # CB: restart lock (R16)
        N_L_CB_2 = (L_CB_2 or GW_CB_2) and (not RLS_CB)  # CB locked from UB to BE|CB@102.reverse
        N_M_CB = (M_CB or G_R13) and (not RLS_CB)  # CB locked for a train movement
        N_F_CB = (F_CB or LK_R13) and (not RLS_CB)  # CB firmly locked
        N_U_CB = (U_CB or NU_CB_2) and (not RLS_CB)  # CB used by a train (R9)
        N_P_CB = (P_CB or (U_CB and OCC_CB and NU_BE_3)) and (not RLS_CB)  # CB: the train went on (R9)
        N_D_CB = (D_CB or ((not VALID) and L_CB_2)) and (not RLS_CB)  # CB: detection is not relied on, inputs were lost or a train is called on
        N_K_CD = K_CD and (not RLS_CD)  # CD: restart lock (R16)
        N_L_CD_1 = (L_CD_1 or GW_CD_1) and (not RLS_CD)  # CD locked from BC|CD@201.1b to DB
        N_M_CD = (M_CD or G_R4 or G_R16) and (not RLS_CD)  # CD locked for a train movement
        N_F_CD = (F_CD or LK_R4 or LK_R16) and (not RLS_CD)  # CD firmly locked
        N_U_CD = (U_CD or NU_CD_1) and (not RLS_CD)  # CD used by a train (R9)
        N_P_CD = P_CD and (not RLS_CD)  # CD: the train went on (R9)
        N_D_CD = (D_CD or ((not VALID) and L_CD_1)) and (not RLS_CD)  # CD: detection is not relied on, inputs were lost or a train is called on
        N_K_GA = K_GA and (not RLS_GA)  # GA: restart lock (R16)
        N_L_GA_1 = (L_GA_1 or GW_GA_1) and (not RLS_GA)  # GA locked from G to GA|SC@210.2a
        N_L_GA_2 = (L_GA_2 or GW_GA_2) and (not RLS_GA)  # GA locked from GA|SC@210.2a to G
        N_M_GA = (M_GA or G_R15 or G_R2) and (not RLS_GA)  # GA locked for a train movement
        N_F_GA = (F_GA or LK_R15 or LK_R2) and (not RLS_GA)  # GA firmly locked
        N_U_GA = (U_GA or NU_GA_1 or NU_GA_2) and (not RLS_GA)  # GA used by a train (R9)
        N_P_GA = (P_GA or (U_GA and OCC_GA and NU_SC_3)) and (not RLS_GA)  # GA: the train went on (R9)
        N_D_GA = (D_GA or ((not VALID) and (L_GA_1 or L_GA_2))) and (not RLS_GA)  # GA: detection is not relied on, inputs were lost or a train is called on
        N_K_GB = K_GB and (not RLS_GB)  # GB: restart lock (R16)
        N_L_GB_1 = (L_GB_1 or GW_GB_1 or (GB_GB_1 and FREE_GB)) and (not RLS_GB)  # GB locked from GB|SC@210.2b to GN
        N_M_GB = (M_GB or G_R6 or G_R18) and (not RLS_GB) and (not AR_GB)  # GB locked for a train movement
        N_F_GB = (F_GB or LK_R6 or LK_R18 or (LK_R20 and L_GB_1)) and (not RLS_GB)  # GB firmly locked
        N_U_GB = (U_GB or NU_GB_1) and (not RLS_GB)  # GB used by a train (R9)
        N_P_GB = (P_GB or (U_GB and OCC_GB and NU_SC_4)) and (not RLS_GB)  # GB: the train went on (R9)
        N_D_GB = (D_GB or ((not VALID) and L_GB_1)) and (not RLS_GB)  # GB: detection is not relied on, inputs were lost or a train is called on
        N_K_SC = K_SC and (not RLS_SC)  # SC: restart lock (R16)
        N_L_SC_1 = (L_SC_1 or GW_SC_1) and (not RLS_SC)  # SC locked from AB|SC@210.1a to AC|SC@101.toe
        N_L_SC_2 = (L_SC_2 or GW_SC_2) and (not RLS_SC)  # SC locked from AB|SC@210.1a to GB|SC@210.2b
        N_L_SC_3 = L_SC_3 and (not RLS_SC)  # SC locked from AC|SC@101.toe to AB|SC@210.1a
        N_L_SC_4 = (L_SC_4 or GW_SC_4) and (not RLS_SC)  # SC locked from AC|SC@101.toe to GA|SC@210.2a
        N_L_SC_5 = (L_SC_5 or GW_SC_5) and (not RLS_SC)  # SC locked from GA|SC@210.2a to AC|SC@101.toe
        N_L_SC_6 = (L_SC_6 or GW_SC_6) and (not RLS_SC)  # SC locked from GA|SC@210.2a to GB|SC@210.2b
        N_L_SC_8 = (L_SC_8 or GW_SC_8) and (not RLS_SC)  # SC locked from GB|SC@210.2b to GA|SC@210.2a
        N_M_SC = (M_SC or G_R4 or G_R5 or G_R7 or G_R6 or G_R11 or G_R16 or G_R17 or G_R19 or G_R18) and (not RLS_SC)  # SC locked for a train movement
        N_F_SC = (F_SC or LK_R4 or LK_R5 or LK_R7 or LK_R6 or LK_R11 or LK_R16 or LK_R17 or LK_R19 or LK_R18 or LK_R20 or LK_R1) and (not RLS_SC)  # SC firmly locked
        N_U_SC = (U_SC or NU_SC_1 or NU_SC_2 or NU_SC_3 or NU_SC_4) and (not RLS_SC)  # SC used by a train (R9)
        N_P_SC = (P_SC or (U_SC and OCC_SC and (NU_AB_1 or NU_AC_3 or NU_GA_2 or NU_GB_1))) and (not RLS_SC)  # SC: the train went on (R9)
        N_D_SC = (D_SC or ((not VALID) and (L_SC_1 or L_SC_2 or L_SC_3 or L_SC_4 or L_SC_5 or L_SC_6 or L_SC_8))) and (not RLS_SC)  # SC: detection is not relied on, inputs were lost or a train is called on
        N_V_G3_1 = GO_G3_1 or (V_G3_1 and (not (OR_G3 and (not OCC_GA))))  # overlap 1 of G3 held
        N_V_S2J_1 = GO_S2J_1 or (V_S2J_1 and (not (OR_S2J and (not OCC_BC) and (not OCC_BE) and (not OCC_BD))))  # overlap 1 of S2J held
        N_V_S2J_2 = GO_S2J_2 or (V_S2J_2 and (not (OR_S2J and (not OCC_BC) and (not OCC_AC) and (not OCC_SC) and (not OCC_AB))))  # overlap 2 of S2J held
        N_V_S2J_3 = GO_S2J_3 or (V_S2J_3 and (not (OR_S2J and (not OCC_BC) and (not OCC_AC) and (not OCC_SC) and (not OCC_GA))))  # overlap 3 of S2J held
        N_VF_G3 = (VF_G3 or LK_R11) and V_G3_1  # overlap of G3 firmly held
        N_VF_S2J = (VF_S2J or LK_R8 or LK_R9 or LK_R10) and (V_S2J_1 or V_S2J_2 or V_S2J_3)  # overlap of S2J firmly held
        N_C_G3 = PR_R2 and PR_R2  # G3 shows clear
        N_C_S1 = PR_R3 and (PR_R3 and (PR_R4 or PR_R5 or PR_R6 or PR_R7))  # S1 shows clear
        N_C_S1J = (PR_R4 or PR_R5 or PR_R6 or PR_R7) and PR_R7  # S1J shows clear
        N_C_S2 = (PR_R8 or PR_R9 or PR_R10) and ((PR_R8 and (PR_R11 or PR_R12)) or (PR_R9 and (PR_R11 or PR_R12)) or (PR_R10 and (PR_R11 or PR_R12)))  # S2 shows clear
        N_C_S2J = (PR_R11 or PR_R12) and (PR_R11 and PR_R2)  # S2J shows clear
        N_C_S4 = PR_R13 and (PR_R13 and PR_R14)  # S4 shows clear
        N_C_S4J = PR_R14 and False  # S4J shows clear
        N_C_SG = PR_R15 and (PR_R15 and (PR_R16 or PR_R17 or PR_R18 or PR_R19))  # SG shows clear
        N_C_SGJ = (PR_R16 or PR_R17 or PR_R18 or PR_R19) and PR_R19  # SGJ shows clear
        self.state = {
            'CN_101': bool(N_CN_101),
            'CR_101': bool(N_CR_101),
            'CN_102': bool(N_CN_102),
            'CR_102': bool(N_CR_102),
            'CN_201a': bool(N_CN_201a),
            'CR_201a': bool(N_CR_201a),
            'CN_201b': bool(N_CN_201b),
            'CR_201b': bool(N_CR_201b),
            'CN_210a': bool(N_CN_210a),
            'CR_210a': bool(N_CR_210a),
            'CN_210b': bool(N_CN_210b),
            'CR_210b': bool(N_CR_210b),
            'AL_101': bool(N_AL_101),
            'AL_102': bool(N_AL_102),
            'AL_201a': bool(N_AL_201a),
            'AL_201b': bool(N_AL_201b),
            'AL_210a': bool(N_AL_210a),
            'AL_210b': bool(N_AL_210b),
            'TH_101': bool(N_TH_101),
            'TR_101': bool(N_TR_101),
            'TH_102': bool(N_TH_102),
            'TR_102': bool(N_TR_102),
            'TH_201a': bool(N_TH_201a),
            'TR_201a': bool(N_TR_201a),
            'TH_201b': bool(N_TH_201b),
            'TR_201b': bool(N_TR_201b),
            'TH_210a': bool(N_TH_210a),
            'TR_210a': bool(N_TR_210a),
            'TH_210b': bool(N_TH_210b),
            'TR_210b': bool(N_TR_210b),
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
            'A_R18': bool(N_A_R18),
            'B_R18': bool(N_B_R18),
            'W_R18': bool(N_W_R18),
            'S_R18': bool(N_S_R18),
            'H_R18': bool(N_H_R18),
            'A_R19': bool(N_A_R19),
            'B_R19': bool(N_B_R19),
            'W_R19': bool(N_W_R19),
            'S_R19': bool(N_S_R19),
            'H_R19': bool(N_H_R19),
            'A_R20': bool(N_A_R20),
            'B_R20': bool(N_B_R20),
            'W_R20': bool(N_W_R20),
            'S_R20': bool(N_S_R20),
            'H_R20': bool(N_H_R20),
            'X_G2': bool(N_X_G2),
            'X_G3': bool(N_X_G3),
            'X_S1': bool(N_X_S1),
            'X_S1J': bool(N_X_S1J),
            'X_S2': bool(N_X_S2),
            'X_S2J': bool(N_X_S2J),
            'X_S4': bool(N_X_S4),
            'X_S4J': bool(N_X_S4J),
            'X_SG': bool(N_X_SG),
            'X_SGJ': bool(N_X_SGJ),
            'K_AB': bool(N_K_AB),
            'L_AB_1': bool(N_L_AB_1),
            'L_AB_2': bool(N_L_AB_2),
            'M_AB': bool(N_M_AB),
            'F_AB': bool(N_F_AB),
            'U_AB': bool(N_U_AB),
            'P_AB': bool(N_P_AB),
            'D_AB': bool(N_D_AB),
            'K_AC': bool(N_K_AC),
            'L_AC_2': bool(N_L_AC_2),
            'L_AC_3': bool(N_L_AC_3),
            'L_AC_4': bool(N_L_AC_4),
            'M_AC': bool(N_M_AC),
            'F_AC': bool(N_F_AC),
            'U_AC': bool(N_U_AC),
            'P_AC': bool(N_P_AC),
            'D_AC': bool(N_D_AC),
            'K_AD': bool(N_K_AD),
            'L_AD_1': bool(N_L_AD_1),
            'M_AD': bool(N_M_AD),
            'F_AD': bool(N_F_AD),
            'U_AD': bool(N_U_AD),
            'P_AD': bool(N_P_AD),
            'D_AD': bool(N_D_AD),
            'K_BB': bool(N_K_BB),
            'L_BB_1': bool(N_L_BB_1),
            'L_BB_2': bool(N_L_BB_2),
            'M_BB': bool(N_M_BB),
            'F_BB': bool(N_F_BB),
            'U_BB': bool(N_U_BB),
            'P_BB': bool(N_P_BB),
            'D_BB': bool(N_D_BB),
            'K_BC': bool(N_K_BC),
            'L_BC_1': bool(N_L_BC_1),
            'L_BC_2': bool(N_L_BC_2),
            'L_BC_3': bool(N_L_BC_3),
            'L_BC_4': bool(N_L_BC_4),
            'M_BC': bool(N_M_BC),
            'F_BC': bool(N_F_BC),
            'U_BC': bool(N_U_BC),
            'P_BC': bool(N_P_BC),
            'D_BC': bool(N_D_BC),
            'K_BD': bool(N_K_BD),
            'L_BD_1': bool(N_L_BD_1),
            'M_BD': bool(N_M_BD),
            'F_BD': bool(N_F_BD),
            'U_BD': bool(N_U_BD),
            'P_BD': bool(N_P_BD),
            'D_BD': bool(N_D_BD),
            'K_BE': bool(N_K_BE),
            'L_BE_1': bool(N_L_BE_1),
            'L_BE_4': bool(N_L_BE_4),
            'M_BE': bool(N_M_BE),
            'F_BE': bool(N_F_BE),
            'U_BE': bool(N_U_BE),
            'P_BE': bool(N_P_BE),
            'D_BE': bool(N_D_BE),
            'K_CB': bool(N_K_CB),
            'L_CB_2': bool(N_L_CB_2),
            'M_CB': bool(N_M_CB),
            'F_CB': bool(N_F_CB),
            'U_CB': bool(N_U_CB),
            'P_CB': bool(N_P_CB),
            'D_CB': bool(N_D_CB),
            'K_CD': bool(N_K_CD),
            'L_CD_1': bool(N_L_CD_1),
            'M_CD': bool(N_M_CD),
            'F_CD': bool(N_F_CD),
            'U_CD': bool(N_U_CD),
            'P_CD': bool(N_P_CD),
            'D_CD': bool(N_D_CD),
            'K_GA': bool(N_K_GA),
            'L_GA_1': bool(N_L_GA_1),
            'L_GA_2': bool(N_L_GA_2),
            'M_GA': bool(N_M_GA),
            'F_GA': bool(N_F_GA),
            'U_GA': bool(N_U_GA),
            'P_GA': bool(N_P_GA),
            'D_GA': bool(N_D_GA),
            'K_GB': bool(N_K_GB),
            'L_GB_1': bool(N_L_GB_1),
            'M_GB': bool(N_M_GB),
            'F_GB': bool(N_F_GB),
            'U_GB': bool(N_U_GB),
            'P_GB': bool(N_P_GB),
            'D_GB': bool(N_D_GB),
            'K_SC': bool(N_K_SC),
            'L_SC_1': bool(N_L_SC_1),
            'L_SC_2': bool(N_L_SC_2),
            'L_SC_3': bool(N_L_SC_3),
            'L_SC_4': bool(N_L_SC_4),
            'L_SC_5': bool(N_L_SC_5),
            'L_SC_6': bool(N_L_SC_6),
            'L_SC_8': bool(N_L_SC_8),
            'M_SC': bool(N_M_SC),
            'F_SC': bool(N_F_SC),
            'U_SC': bool(N_U_SC),
            'P_SC': bool(N_P_SC),
            'D_SC': bool(N_D_SC),
            'V_G3_1': bool(N_V_G3_1),
            'V_S2J_1': bool(N_V_S2J_1),
            'V_S2J_2': bool(N_V_S2J_2),
            'V_S2J_3': bool(N_V_S2J_3),
            'VF_G3': bool(N_VF_G3),
            'VF_S2J': bool(N_VF_S2J),
            'C_G3': bool(N_C_G3),
            'C_S1': bool(N_C_S1),
            'C_S1J': bool(N_C_S1J),
            'C_S2': bool(N_C_S2),
            'C_S2J': bool(N_C_S2J),
            'C_S4': bool(N_C_S4),
            'C_S4J': bool(N_C_S4J),
            'C_SG': bool(N_C_SG),
            'C_SGJ': bool(N_C_SGJ),
        }
        CN_101 = self.state['CN_101']
        CR_101 = self.state['CR_101']
        CN_102 = self.state['CN_102']
        CR_102 = self.state['CR_102']
        CN_201a = self.state['CN_201a']
        CR_201a = self.state['CR_201a']
        CN_201b = self.state['CN_201b']
        CR_201b = self.state['CR_201b']
        CN_210a = self.state['CN_210a']
        CR_210a = self.state['CR_210a']
        CN_210b = self.state['CN_210b']
        CR_210b = self.state['CR_210b']
        AL_101 = self.state['AL_101']
        AL_102 = self.state['AL_102']
        AL_201a = self.state['AL_201a']
        AL_201b = self.state['AL_201b']
        AL_210a = self.state['AL_210a']
        AL_210b = self.state['AL_210b']
        TH_101 = self.state['TH_101']
        TR_101 = self.state['TR_101']
        TH_102 = self.state['TH_102']
        TR_102 = self.state['TR_102']
        TH_201a = self.state['TH_201a']
        TR_201a = self.state['TR_201a']
        TH_201b = self.state['TH_201b']
        TR_201b = self.state['TR_201b']
        TH_210a = self.state['TH_210a']
        TR_210a = self.state['TR_210a']
        TH_210b = self.state['TH_210b']
        TR_210b = self.state['TR_210b']
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
        A_R18 = self.state['A_R18']
        B_R18 = self.state['B_R18']
        W_R18 = self.state['W_R18']
        S_R18 = self.state['S_R18']
        H_R18 = self.state['H_R18']
        A_R19 = self.state['A_R19']
        B_R19 = self.state['B_R19']
        W_R19 = self.state['W_R19']
        S_R19 = self.state['S_R19']
        H_R19 = self.state['H_R19']
        A_R20 = self.state['A_R20']
        B_R20 = self.state['B_R20']
        W_R20 = self.state['W_R20']
        S_R20 = self.state['S_R20']
        H_R20 = self.state['H_R20']
        X_G2 = self.state['X_G2']
        X_G3 = self.state['X_G3']
        X_S1 = self.state['X_S1']
        X_S1J = self.state['X_S1J']
        X_S2 = self.state['X_S2']
        X_S2J = self.state['X_S2J']
        X_S4 = self.state['X_S4']
        X_S4J = self.state['X_S4J']
        X_SG = self.state['X_SG']
        X_SGJ = self.state['X_SGJ']
        K_AB = self.state['K_AB']
        L_AB_1 = self.state['L_AB_1']
        L_AB_2 = self.state['L_AB_2']
        M_AB = self.state['M_AB']
        F_AB = self.state['F_AB']
        U_AB = self.state['U_AB']
        P_AB = self.state['P_AB']
        D_AB = self.state['D_AB']
        K_AC = self.state['K_AC']
        L_AC_2 = self.state['L_AC_2']
        L_AC_3 = self.state['L_AC_3']
        L_AC_4 = self.state['L_AC_4']
        M_AC = self.state['M_AC']
        F_AC = self.state['F_AC']
        U_AC = self.state['U_AC']
        P_AC = self.state['P_AC']
        D_AC = self.state['D_AC']
        K_AD = self.state['K_AD']
        L_AD_1 = self.state['L_AD_1']
        M_AD = self.state['M_AD']
        F_AD = self.state['F_AD']
        U_AD = self.state['U_AD']
        P_AD = self.state['P_AD']
        D_AD = self.state['D_AD']
        K_BB = self.state['K_BB']
        L_BB_1 = self.state['L_BB_1']
        L_BB_2 = self.state['L_BB_2']
        M_BB = self.state['M_BB']
        F_BB = self.state['F_BB']
        U_BB = self.state['U_BB']
        P_BB = self.state['P_BB']
        D_BB = self.state['D_BB']
        K_BC = self.state['K_BC']
        L_BC_1 = self.state['L_BC_1']
        L_BC_2 = self.state['L_BC_2']
        L_BC_3 = self.state['L_BC_3']
        L_BC_4 = self.state['L_BC_4']
        M_BC = self.state['M_BC']
        F_BC = self.state['F_BC']
        U_BC = self.state['U_BC']
        P_BC = self.state['P_BC']
        D_BC = self.state['D_BC']
        K_BD = self.state['K_BD']
        L_BD_1 = self.state['L_BD_1']
        M_BD = self.state['M_BD']
        F_BD = self.state['F_BD']
        U_BD = self.state['U_BD']
        P_BD = self.state['P_BD']
        D_BD = self.state['D_BD']
        K_BE = self.state['K_BE']
        L_BE_1 = self.state['L_BE_1']
        L_BE_4 = self.state['L_BE_4']
        M_BE = self.state['M_BE']
        F_BE = self.state['F_BE']
        U_BE = self.state['U_BE']
        P_BE = self.state['P_BE']
        D_BE = self.state['D_BE']
        K_CB = self.state['K_CB']
        L_CB_2 = self.state['L_CB_2']
        M_CB = self.state['M_CB']
        F_CB = self.state['F_CB']
        U_CB = self.state['U_CB']
        P_CB = self.state['P_CB']
        D_CB = self.state['D_CB']
        K_CD = self.state['K_CD']
        L_CD_1 = self.state['L_CD_1']
        M_CD = self.state['M_CD']
        F_CD = self.state['F_CD']
        U_CD = self.state['U_CD']
        P_CD = self.state['P_CD']
        D_CD = self.state['D_CD']
        K_GA = self.state['K_GA']
        L_GA_1 = self.state['L_GA_1']
        L_GA_2 = self.state['L_GA_2']
        M_GA = self.state['M_GA']
        F_GA = self.state['F_GA']
        U_GA = self.state['U_GA']
        P_GA = self.state['P_GA']
        D_GA = self.state['D_GA']
        K_GB = self.state['K_GB']
        L_GB_1 = self.state['L_GB_1']
        M_GB = self.state['M_GB']
        F_GB = self.state['F_GB']
        U_GB = self.state['U_GB']
        P_GB = self.state['P_GB']
        D_GB = self.state['D_GB']
        K_SC = self.state['K_SC']
        L_SC_1 = self.state['L_SC_1']
        L_SC_2 = self.state['L_SC_2']
        L_SC_3 = self.state['L_SC_3']
        L_SC_4 = self.state['L_SC_4']
        L_SC_5 = self.state['L_SC_5']
        L_SC_6 = self.state['L_SC_6']
        L_SC_8 = self.state['L_SC_8']
        M_SC = self.state['M_SC']
        F_SC = self.state['F_SC']
        U_SC = self.state['U_SC']
        P_SC = self.state['P_SC']
        D_SC = self.state['D_SC']
        V_G3_1 = self.state['V_G3_1']
        V_S2J_1 = self.state['V_S2J_1']
        V_S2J_2 = self.state['V_S2J_2']
        V_S2J_3 = self.state['V_S2J_3']
        VF_G3 = self.state['VF_G3']
        VF_S2J = self.state['VF_S2J']
        C_G3 = self.state['C_G3']
        C_S1 = self.state['C_S1']
        C_S1J = self.state['C_S1J']
        C_S2 = self.state['C_S2']
        C_S2J = self.state['C_S2J']
        C_S4 = self.state['C_S4']
        C_S4J = self.state['C_S4J']
        C_SG = self.state['C_SG']
        C_SGJ = self.state['C_SGJ']
        return {
            'YN_101': bool(CN_101),
            'YR_101': bool(CR_101),
            'YN_102': bool(CN_102),
            'YR_102': bool(CR_102),
            'YN_201a': bool(CN_201a),
            'YR_201a': bool(CR_201a),
            'YN_201b': bool(CN_201b),
            'YR_201b': bool(CR_201b),
            'YN_210a': bool(CN_210a),
            'YR_210a': bool(CR_210a),
            'YN_210b': bool(CN_210b),
            'YR_210b': bool(CR_210b),
            'YA_101': bool(AL_101),
            'YA_102': bool(AL_102),
            'YA_201a': bool(AL_201a),
            'YA_201b': bool(AL_201b),
            'YA_210a': bool(AL_210a),
            'YA_210b': bool(AL_210b),
            'YT_101': bool(TR_101),
            'YT_102': bool(TR_102),
            'YT_201a': bool(TR_201a),
            'YT_201b': bool(TR_201b),
            'YT_210a': bool(TR_210a),
            'YT_210b': bool(TR_210b),
            'YL_AB': bool(K_AB or L_AB_1 or L_AB_2 or V_S2J_2),
            'YL_AC': bool(K_AC or L_AC_2 or L_AC_3 or L_AC_4 or V_S2J_2 or V_S2J_3),
            'YL_AD': bool(K_AD or L_AD_1),
            'YL_BB': bool(K_BB or L_BB_1 or L_BB_2),
            'YL_BC': bool(K_BC or L_BC_1 or L_BC_2 or L_BC_3 or L_BC_4 or V_S2J_1 or V_S2J_2 or V_S2J_3),
            'YL_BD': bool(K_BD or L_BD_1 or V_S2J_1),
            'YL_BE': bool(K_BE or L_BE_1 or L_BE_4 or V_S2J_1),
            'YL_CB': bool(K_CB or L_CB_2),
            'YL_CD': bool(K_CD or L_CD_1),
            'YL_GA': bool(K_GA or L_GA_1 or L_GA_2 or V_G3_1 or V_S2J_3),
            'YL_GB': bool(K_GB or L_GB_1),
            'YL_SC': bool(K_SC or L_SC_1 or L_SC_2 or L_SC_3 or L_SC_4 or L_SC_5 or L_SC_6 or L_SC_8 or V_S2J_2 or V_S2J_3),
            'YW_G2': bool(S_R1),
            'YS_G2': bool((not S_R1)),
            'YP_G3': bool(C_G3),
            'YY_G3': bool(S_R2 and (not C_G3)),
            'YS_G3': bool((not S_R2)),
            'YP_S1': bool(C_S1),
            'YY_S1': bool(S_R3 and (not C_S1)),
            'YS_S1': bool((not S_R3)),
            'YP_S1J': bool(C_S1J),
            'YY_S1J': bool((S_R4 or S_R5 or S_R6 or S_R7) and (not C_S1J)),
            'YS_S1J': bool((not (S_R4 or S_R5 or S_R6 or S_R7))),
            'YP_S2': bool(C_S2),
            'YY_S2': bool((S_R8 or S_R9 or S_R10) and (not C_S2)),
            'YS_S2': bool((not (S_R8 or S_R9 or S_R10))),
            'YP_S2J': bool(C_S2J),
            'YY_S2J': bool((S_R11 or S_R12) and (not C_S2J)),
            'YS_S2J': bool((not (S_R11 or S_R12))),
            'YP_S4': bool(C_S4),
            'YY_S4': bool(S_R13 and (not C_S4)),
            'YS_S4': bool((not S_R13)),
            'YP_S4J': bool(C_S4J),
            'YY_S4J': bool(S_R14 and (not C_S4J)),
            'YS_S4J': bool((not S_R14)),
            'YP_SG': bool(C_SG),
            'YY_SG': bool(S_R15 and (not C_SG)),
            'YS_SG': bool((not S_R15)),
            'YP_SGJ': bool(C_SGJ),
            'YY_SGJ': bool((S_R16 or S_R17 or S_R18 or S_R19) and (not C_SGJ)),
            'YW_SGJ': bool(S_R20),
            'YS_SGJ': bool((not (S_R16 or S_R17 or S_R18 or S_R19 or S_R20))),
        }
