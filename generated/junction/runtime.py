# Interlocking junction, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout c0d6e467e037e621008b849bd8c03cf9203309e9352df4cebbb8e1e0b7ae3871
# claims 00363a26f4a90804fac1059817031a707361c2dad3af83bf1c2ff1f5fe3102b7
"""Interlocking junction: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_S1': (0, 2),  # operator: cancel the route from S1
    'CAN_S1J': (0, 2),  # operator: cancel the route from S1J
    'CAN_S2': (0, 2),  # operator: cancel the route from S2
    'CAN_S2J': (0, 2),  # operator: cancel the route from S2J
    'CAN_S3': (0, 2),  # operator: cancel the route from S3
    'CAN_S4': (0, 2),  # operator: cancel the route from S4
    'CAN_S4J': (0, 2),  # operator: cancel the route from S4J
    'CAN_S5': (0, 2),  # operator: cancel the route from S5
    'CAN_S6': (0, 2),  # operator: cancel the route from S6
    'REQ': (0, 12),  # operator: set route number, 0 = none
    'CLR_AA': (0, 2),  # section AA reported clear
    'CLR_AB': (0, 2),  # section AB reported clear
    'CLR_AC': (0, 2),  # section AC reported clear
    'CLR_AD': (0, 2),  # section AD reported clear
    'CLR_AE': (0, 2),  # section AE reported clear
    'CLR_BA': (0, 2),  # section BA reported clear
    'CLR_BB': (0, 2),  # section BB reported clear
    'CLR_BC': (0, 2),  # section BC reported clear
    'CLR_BD': (0, 2),  # section BD reported clear
    'CLR_BE': (0, 2),  # section BE reported clear
    'CLR_CD': (0, 2),  # section CD reported clear
    'CLR_CE': (0, 2),  # section CE reported clear
    'CLR_DA': (0, 2),  # section DA reported clear
    'CLR_DB': (0, 2),  # section DB reported clear
    'REL_AB': (0, 2),  # operator: release section AB (hold until released)
    'REL_AC': (0, 2),  # operator: release section AC (hold until released)
    'REL_AD': (0, 2),  # operator: release section AD (hold until released)
    'REL_AE': (0, 2),  # operator: release section AE (hold until released)
    'REL_BB': (0, 2),  # operator: release section BB (hold until released)
    'REL_BC': (0, 2),  # operator: release section BC (hold until released)
    'REL_BD': (0, 2),  # operator: release section BD (hold until released)
    'REL_BE': (0, 2),  # operator: release section BE (hold until released)
    'REL_CD': (0, 2),  # operator: release section CD (hold until released)
    'REL_CE': (0, 2),  # operator: release section CE (hold until released)
    'REL_DB': (0, 2),  # operator: release section DB (hold until released)
    'BLK_AB': (1, 2),  # operator: section AB is blocked
    'BLK_AC': (1, 2),  # operator: section AC is blocked
    'BLK_AD': (1, 2),  # operator: section AD is blocked
    'BLK_AE': (1, 2),  # operator: section AE is blocked
    'BLK_BB': (1, 2),  # operator: section BB is blocked
    'BLK_BC': (1, 2),  # operator: section BC is blocked
    'BLK_BD': (1, 2),  # operator: section BD is blocked
    'BLK_BE': (1, 2),  # operator: section BE is blocked
    'BLK_CD': (1, 2),  # operator: section CD is blocked
    'BLK_CE': (1, 2),  # operator: section CE is blocked
    'BLK_DB': (1, 2),  # operator: section DB is blocked
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
}
# name: value at a restart, meaning
STATE = {
    'CN_101': False,  # machine 101 commanded N
    'CR_101': False,  # machine 101 commanded R
    'CN_102': False,  # machine 102 commanded N
    'CR_102': False,  # machine 102 commanded R
    'AL_101': False,  # alarm: machine 101 not detected
    'AL_102': False,  # alarm: machine 102 not detected
    'TH_101': False,  # machine 101 was detected where it is commanded
    'TR_101': False,  # machine 101 was trailed
    'TH_102': False,  # machine 102 was detected where it is commanded
    'TR_102': False,  # machine 102 was trailed
    'A_R1': False,  # route S1-S1J active
    'B_R1': False,  # route S1-S1J locked
    'W_R1': False,  # route S1-S1J: proceed wanted
    'S_R1': False,  # route S1-S1J: proceed
    'H_R1': False,  # route S1-S1J: signal has been open
    'A_R2': False,  # route S1-S1J.o2 active
    'B_R2': False,  # route S1-S1J.o2 locked
    'W_R2': False,  # route S1-S1J.o2: proceed wanted
    'S_R2': False,  # route S1-S1J.o2: proceed
    'H_R2': False,  # route S1-S1J.o2: signal has been open
    'A_R3': False,  # route S1J-S3 active
    'B_R3': False,  # route S1J-S3 locked
    'W_R3': False,  # route S1J-S3: proceed wanted
    'S_R3': False,  # route S1J-S3: proceed
    'H_R3': False,  # route S1J-S3: signal has been open
    'A_R4': False,  # route S1J-S5 active
    'B_R4': False,  # route S1J-S5 locked
    'W_R4': False,  # route S1J-S5: proceed wanted
    'S_R4': False,  # route S1J-S5: proceed
    'H_R4': False,  # route S1J-S5: signal has been open
    'A_R5': False,  # route S2-S2J active
    'B_R5': False,  # route S2-S2J locked
    'W_R5': False,  # route S2-S2J: proceed wanted
    'S_R5': False,  # route S2-S2J: proceed
    'H_R5': False,  # route S2-S2J: signal has been open
    'A_R6': False,  # route S2J-S6 active
    'B_R6': False,  # route S2J-S6 locked
    'W_R6': False,  # route S2J-S6: proceed wanted
    'S_R6': False,  # route S2J-S6: proceed
    'H_R6': False,  # route S2J-S6: signal has been open
    'A_R7': False,  # route S3-DM2 active
    'B_R7': False,  # route S3-DM2 locked
    'W_R7': False,  # route S3-DM2: proceed wanted
    'S_R7': False,  # route S3-DM2: proceed
    'H_R7': False,  # route S3-DM2: signal has been open
    'A_R8': False,  # route S4-S4J active
    'B_R8': False,  # route S4-S4J locked
    'W_R8': False,  # route S4-S4J: proceed wanted
    'S_R8': False,  # route S4-S4J: proceed
    'H_R8': False,  # route S4-S4J: signal has been open
    'A_R9': False,  # route S4J-S6 active
    'B_R9': False,  # route S4J-S6 locked
    'W_R9': False,  # route S4J-S6: proceed wanted
    'S_R9': False,  # route S4J-S6: proceed
    'H_R9': False,  # route S4J-S6: signal has been open
    'A_R10': False,  # route S5-DBO active
    'B_R10': False,  # route S5-DBO locked
    'W_R10': False,  # route S5-DBO: proceed wanted
    'S_R10': False,  # route S5-DBO: proceed
    'H_R10': False,  # route S5-DBO: signal has been open
    'A_R11': False,  # route S6-UM active
    'B_R11': False,  # route S6-UM locked
    'W_R11': False,  # route S6-UM: proceed wanted
    'S_R11': False,  # route S6-UM: proceed
    'H_R11': False,  # route S6-UM: signal has been open
    'X_S1': False,  # S1: cancelling
    'X_S1J': False,  # S1J: cancelling
    'X_S2': False,  # S2: cancelling
    'X_S2J': False,  # S2J: cancelling
    'X_S3': False,  # S3: cancelling
    'X_S4': False,  # S4: cancelling
    'X_S4J': False,  # S4J: cancelling
    'X_S5': False,  # S5: cancelling
    'X_S6': False,  # S6: cancelling
    'K_AB': True,  # AB: restart lock (R16)
    'L_AB_2': False,  # AB locked from DM to AB|AC@101.toe
    'F_AB': False,  # AB firmly locked
    'U_AB': True,  # AB used by a train (R9)
    'P_AB': False,  # AB: the train went on (R9)
    'D_AB': False,  # AB: detection is not relied on, inputs were lost or a train is called on
    'K_AC': True,  # AC: restart lock (R16)
    'L_AC_1': False,  # AC locked from AB|AC@101.toe to AC|AD@101.normal
    'L_AC_2': False,  # AC locked from AB|AC@101.toe to AC|CD@X1.1b
    'F_AC': False,  # AC firmly locked
    'U_AC': True,  # AC used by a train (R9)
    'P_AC': False,  # AC: the train went on (R9)
    'D_AC': False,  # AC: detection is not relied on, inputs were lost or a train is called on
    'K_AD': True,  # AD: restart lock (R16)
    'L_AD_1': False,  # AD locked from AC|AD@101.normal to AD|AE@down2.0
    'F_AD': False,  # AD firmly locked
    'U_AD': True,  # AD used by a train (R9)
    'P_AD': False,  # AD: the train went on (R9)
    'D_AD': False,  # AD: detection is not relied on, inputs were lost or a train is called on
    'K_AE': True,  # AE: restart lock (R16)
    'L_AE_1': False,  # AE locked from AD|AE@down2.0 to DM2
    'F_AE': False,  # AE firmly locked
    'U_AE': True,  # AE used by a train (R9)
    'P_AE': False,  # AE: the train went on (R9)
    'D_AE': False,  # AE: detection is not relied on, inputs were lost or a train is called on
    'K_BB': True,  # BB: restart lock (R16)
    'L_BB_2': False,  # BB locked from UM2 to BB|BC@X1.2a
    'F_BB': False,  # BB firmly locked
    'U_BB': True,  # BB used by a train (R9)
    'P_BB': False,  # BB: the train went on (R9)
    'D_BB': False,  # BB: detection is not relied on, inputs were lost or a train is called on
    'K_BC': True,  # BC: restart lock (R16)
    'L_BC_1': False,  # BC locked from BB|BC@X1.2a to BC|BD@102.toe
    'L_BC_4': False,  # BC locked from BC|DB@102.reverse to BC|BD@102.toe
    'F_BC': False,  # BC firmly locked
    'U_BC': True,  # BC used by a train (R9)
    'P_BC': False,  # BC: the train went on (R9)
    'D_BC': False,  # BC: detection is not relied on, inputs were lost or a train is called on
    'K_BD': True,  # BD: restart lock (R16)
    'L_BD_1': False,  # BD locked from BC|BD@102.toe to BD|BE@up2.0
    'F_BD': False,  # BD firmly locked
    'U_BD': True,  # BD used by a train (R9)
    'P_BD': False,  # BD: the train went on (R9)
    'D_BD': False,  # BD: detection is not relied on, inputs were lost or a train is called on
    'K_BE': True,  # BE: restart lock (R16)
    'L_BE_1': False,  # BE locked from BD|BE@up2.0 to UM
    'F_BE': False,  # BE firmly locked
    'U_BE': True,  # BE used by a train (R9)
    'P_BE': False,  # BE: the train went on (R9)
    'D_BE': False,  # BE: detection is not relied on, inputs were lost or a train is called on
    'K_CD': True,  # CD: restart lock (R16)
    'L_CD_1': False,  # CD locked from AC|CD@X1.1b to CD|CE@branch.0
    'F_CD': False,  # CD firmly locked
    'U_CD': True,  # CD used by a train (R9)
    'P_CD': False,  # CD: the train went on (R9)
    'D_CD': False,  # CD: detection is not relied on, inputs were lost or a train is called on
    'K_CE': True,  # CE: restart lock (R16)
    'L_CE_1': False,  # CE locked from CD|CE@branch.0 to DBO
    'F_CE': False,  # CE firmly locked
    'U_CE': True,  # CE used by a train (R9)
    'P_CE': False,  # CE: the train went on (R9)
    'D_CE': False,  # CE: detection is not relied on, inputs were lost or a train is called on
    'K_DB': True,  # DB: restart lock (R16)
    'L_DB_2': False,  # DB locked from UB to BC|DB@102.reverse
    'F_DB': False,  # DB firmly locked
    'U_DB': True,  # DB used by a train (R9)
    'P_DB': False,  # DB: the train went on (R9)
    'D_DB': False,  # DB: detection is not relied on, inputs were lost or a train is called on
    'V_S1J_1': False,  # overlap 1 of S1J held
    'V_S1J_2': False,  # overlap 2 of S1J held
    'V_S2J_1': False,  # overlap 1 of S2J held
    'V_S3_1': False,  # overlap 1 of S3 held
    'V_S4J_1': False,  # overlap 1 of S4J held
    'V_S5_1': False,  # overlap 1 of S5 held
    'V_S6_1': False,  # overlap 1 of S6 held
    'VF_S1J': False,  # overlap of S1J firmly held
    'VF_S2J': False,  # overlap of S2J firmly held
    'VF_S3': False,  # overlap of S3 firmly held
    'VF_S4J': False,  # overlap of S4J firmly held
    'VF_S5': False,  # overlap of S5 firmly held
    'VF_S6': False,  # overlap of S6 firmly held
    'C_S1': False,  # S1 shows clear
    'C_S1J': False,  # S1J shows clear
    'C_S2': False,  # S2 shows clear
    'C_S2J': False,  # S2J shows clear
    'C_S3': False,  # S3 shows clear
    'C_S4': False,  # S4 shows clear
    'C_S4J': False,  # S4J shows clear
    'C_S5': False,  # S5 shows clear
    'C_S6': False,  # S6 shows clear
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_S1': 120000,  # S1: approach locking delay (R8)
    'AT_S1J': 120000,  # S1J: approach locking delay (R8)
    'AT_S2': 120000,  # S2: approach locking delay (R8)
    'AT_S2J': 120000,  # S2J: approach locking delay (R8)
    'AT_S3': 120000,  # S3: approach locking delay (R8)
    'AT_S4': 120000,  # S4: approach locking delay (R8)
    'AT_S4J': 120000,  # S4J: approach locking delay (R8)
    'AT_S5': 120000,  # S5: approach locking delay (R8)
    'AT_S6': 120000,  # S6: approach locking delay (R8)
    'RT_AB': 3000,  # AB: release delay (R9)
    'RT_AC': 3000,  # AC: release delay (R9)
    'RT_AD': 3000,  # AD: release delay (R9)
    'RT_AE': 3000,  # AE: release delay (R9)
    'RT_BB': 3000,  # BB: release delay (R9)
    'RT_BC': 3000,  # BC: release delay (R9)
    'RT_BD': 3000,  # BD: release delay (R9)
    'RT_BE': 3000,  # BE: release delay (R9)
    'RT_CD': 3000,  # CD: release delay (R9)
    'RT_CE': 3000,  # CE: release delay (R9)
    'RT_DB': 3000,  # DB: release delay (R9)
    'OT_S1J': 60000,  # S1J: the train before it stands (R4)
    'OT_S2J': 60000,  # S2J: the train before it stands (R4)
    'OT_S3': 60000,  # S3: the train before it stands (R4)
    'OT_S4J': 60000,  # S4J: the train before it stands (R4)
    'OT_S5': 60000,  # S5: the train before it stands (R4)
    'OT_S6': 60000,  # S6: the train before it stands (R4)
    'ST_101': 13000,  # machine 101: time-out
    'ST_102': 13000,  # machine 102: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_101': False,  # machine 101: normal
    'YR_101': False,  # machine 101: reverse
    'YN_102': False,  # machine 102: normal
    'YR_102': False,  # machine 102: reverse
    'YA_101': False,  # alarm: machine 101 not detected in time
    'YA_102': False,  # alarm: machine 102 not detected in time
    'YT_101': False,  # alarm: machine 101 was trailed
    'YT_102': False,  # alarm: machine 102 was trailed
    'YL_AB': True,  # indication: AB is locked
    'YL_AC': True,  # indication: AC is locked
    'YL_AD': True,  # indication: AD is locked
    'YL_AE': True,  # indication: AE is locked
    'YL_BB': True,  # indication: BB is locked
    'YL_BC': True,  # indication: BC is locked
    'YL_BD': True,  # indication: BD is locked
    'YL_BE': True,  # indication: BE is locked
    'YL_CD': True,  # indication: CD is locked
    'YL_CE': True,  # indication: CE is locked
    'YL_DB': True,  # indication: DB is locked
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
    'YP_S3': False,  # signal S3: clear (green)
    'YY_S3': False,  # signal S3: caution (yellow)
    'YS_S3': True,  # signal S3: stop
    'YP_S4': False,  # signal S4: clear (green)
    'YY_S4': False,  # signal S4: caution (yellow)
    'YS_S4': True,  # signal S4: stop
    'YP_S4J': False,  # signal S4J: clear (green)
    'YY_S4J': False,  # signal S4J: caution (yellow)
    'YS_S4J': True,  # signal S4J: stop
    'YP_S5': False,  # signal S5: clear (green)
    'YY_S5': False,  # signal S5: caution (yellow)
    'YS_S5': True,  # signal S5: stop
    'YP_S6': False,  # signal S6: clear (green)
    'YY_S6': False,  # signal S6: caution (yellow)
    'YS_S6': True,  # signal S6: stop
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
        CAN_S1J = read['CAN_S1J']
        CAN_S2 = read['CAN_S2']
        CAN_S2J = read['CAN_S2J']
        CAN_S3 = read['CAN_S3']
        CAN_S4 = read['CAN_S4']
        CAN_S4J = read['CAN_S4J']
        CAN_S5 = read['CAN_S5']
        CAN_S6 = read['CAN_S6']
        REQ = read['REQ']
        CLR_AA = read['CLR_AA']
        CLR_AB = read['CLR_AB']
        CLR_AC = read['CLR_AC']
        CLR_AD = read['CLR_AD']
        CLR_AE = read['CLR_AE']
        CLR_BA = read['CLR_BA']
        CLR_BB = read['CLR_BB']
        CLR_BC = read['CLR_BC']
        CLR_BD = read['CLR_BD']
        CLR_BE = read['CLR_BE']
        CLR_CD = read['CLR_CD']
        CLR_CE = read['CLR_CE']
        CLR_DA = read['CLR_DA']
        CLR_DB = read['CLR_DB']
        REL_AB = read['REL_AB']
        REL_AC = read['REL_AC']
        REL_AD = read['REL_AD']
        REL_AE = read['REL_AE']
        REL_BB = read['REL_BB']
        REL_BC = read['REL_BC']
        REL_BD = read['REL_BD']
        REL_BE = read['REL_BE']
        REL_CD = read['REL_CD']
        REL_CE = read['REL_CE']
        REL_DB = read['REL_DB']
        BLK_AB = read['BLK_AB']
        BLK_AC = read['BLK_AC']
        BLK_AD = read['BLK_AD']
        BLK_AE = read['BLK_AE']
        BLK_BB = read['BLK_BB']
        BLK_BC = read['BLK_BC']
        BLK_BD = read['BLK_BD']
        BLK_BE = read['BLK_BE']
        BLK_CD = read['BLK_CD']
        BLK_CE = read['BLK_CE']
        BLK_DB = read['BLK_DB']
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
        CN_101 = old['CN_101']
        CR_101 = old['CR_101']
        CN_102 = old['CN_102']
        CR_102 = old['CR_102']
        AL_101 = old['AL_101']
        AL_102 = old['AL_102']
        TH_101 = old['TH_101']
        TR_101 = old['TR_101']
        TH_102 = old['TH_102']
        TR_102 = old['TR_102']
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
        X_S1 = old['X_S1']
        X_S1J = old['X_S1J']
        X_S2 = old['X_S2']
        X_S2J = old['X_S2J']
        X_S3 = old['X_S3']
        X_S4 = old['X_S4']
        X_S4J = old['X_S4J']
        X_S5 = old['X_S5']
        X_S6 = old['X_S6']
        K_AB = old['K_AB']
        L_AB_2 = old['L_AB_2']
        F_AB = old['F_AB']
        U_AB = old['U_AB']
        P_AB = old['P_AB']
        D_AB = old['D_AB']
        K_AC = old['K_AC']
        L_AC_1 = old['L_AC_1']
        L_AC_2 = old['L_AC_2']
        F_AC = old['F_AC']
        U_AC = old['U_AC']
        P_AC = old['P_AC']
        D_AC = old['D_AC']
        K_AD = old['K_AD']
        L_AD_1 = old['L_AD_1']
        F_AD = old['F_AD']
        U_AD = old['U_AD']
        P_AD = old['P_AD']
        D_AD = old['D_AD']
        K_AE = old['K_AE']
        L_AE_1 = old['L_AE_1']
        F_AE = old['F_AE']
        U_AE = old['U_AE']
        P_AE = old['P_AE']
        D_AE = old['D_AE']
        K_BB = old['K_BB']
        L_BB_2 = old['L_BB_2']
        F_BB = old['F_BB']
        U_BB = old['U_BB']
        P_BB = old['P_BB']
        D_BB = old['D_BB']
        K_BC = old['K_BC']
        L_BC_1 = old['L_BC_1']
        L_BC_4 = old['L_BC_4']
        F_BC = old['F_BC']
        U_BC = old['U_BC']
        P_BC = old['P_BC']
        D_BC = old['D_BC']
        K_BD = old['K_BD']
        L_BD_1 = old['L_BD_1']
        F_BD = old['F_BD']
        U_BD = old['U_BD']
        P_BD = old['P_BD']
        D_BD = old['D_BD']
        K_BE = old['K_BE']
        L_BE_1 = old['L_BE_1']
        F_BE = old['F_BE']
        U_BE = old['U_BE']
        P_BE = old['P_BE']
        D_BE = old['D_BE']
        K_CD = old['K_CD']
        L_CD_1 = old['L_CD_1']
        F_CD = old['F_CD']
        U_CD = old['U_CD']
        P_CD = old['P_CD']
        D_CD = old['D_CD']
        K_CE = old['K_CE']
        L_CE_1 = old['L_CE_1']
        F_CE = old['F_CE']
        U_CE = old['U_CE']
        P_CE = old['P_CE']
        D_CE = old['D_CE']
        K_DB = old['K_DB']
        L_DB_2 = old['L_DB_2']
        F_DB = old['F_DB']
        U_DB = old['U_DB']
        P_DB = old['P_DB']
        D_DB = old['D_DB']
        V_S1J_1 = old['V_S1J_1']
        V_S1J_2 = old['V_S1J_2']
        V_S2J_1 = old['V_S2J_1']
        V_S3_1 = old['V_S3_1']
        V_S4J_1 = old['V_S4J_1']
        V_S5_1 = old['V_S5_1']
        V_S6_1 = old['V_S6_1']
        VF_S1J = old['VF_S1J']
        VF_S2J = old['VF_S2J']
        VF_S3 = old['VF_S3']
        VF_S4J = old['VF_S4J']
        VF_S5 = old['VF_S5']
        VF_S6 = old['VF_S6']
        C_S1 = old['C_S1']
        C_S1J = old['C_S1J']
        C_S2 = old['C_S2']
        C_S2J = old['C_S2J']
        C_S3 = old['C_S3']
        C_S4 = old['C_S4']
        C_S4J = old['C_S4J']
        C_S5 = old['C_S5']
        C_S6 = old['C_S6']
        OCC_AA = (not CLR_AA) or (not VALID)  # AA counts as occupied
        OCC_AB = (not CLR_AB) or (not VALID)  # AB counts as occupied
        OCC_AC = (not CLR_AC) or (not VALID)  # AC counts as occupied
        OCC_AD = (not CLR_AD) or (not VALID)  # AD counts as occupied
        OCC_AE = (not CLR_AE) or (not VALID)  # AE counts as occupied
        OCC_BA = (not CLR_BA) or (not VALID)  # BA counts as occupied
        OCC_BB = (not CLR_BB) or (not VALID)  # BB counts as occupied
        OCC_BC = (not CLR_BC) or (not VALID)  # BC counts as occupied
        OCC_BD = (not CLR_BD) or (not VALID)  # BD counts as occupied
        OCC_BE = (not CLR_BE) or (not VALID)  # BE counts as occupied
        OCC_CD = (not CLR_CD) or (not VALID)  # CD counts as occupied
        OCC_CE = (not CLR_CE) or (not VALID)  # CE counts as occupied
        OCC_DA = (not CLR_DA) or (not VALID)  # DA counts as occupied
        OCC_DB = (not CLR_DB) or (not VALID)  # DB counts as occupied
        FREE_AB = (not K_AB) and (not L_AB_2)  # AB is not locked by anybody
        FREE_AC = (not K_AC) and (not L_AC_1) and (not L_AC_2) and (not V_S1J_1) and (not V_S1J_2)  # AC is not locked by anybody
        FREE_AD = (not K_AD) and (not L_AD_1) and (not V_S1J_1)  # AD is not locked by anybody
        FREE_AE = (not K_AE) and (not L_AE_1) and (not V_S3_1)  # AE is not locked by anybody
        FREE_BB = (not K_BB) and (not L_BB_2)  # BB is not locked by anybody
        FREE_BC = (not K_BC) and (not L_BC_1) and (not L_BC_4) and (not V_S2J_1) and (not V_S4J_1)  # BC is not locked by anybody
        FREE_BD = (not K_BD) and (not L_BD_1) and (not V_S2J_1) and (not V_S4J_1)  # BD is not locked by anybody
        FREE_BE = (not K_BE) and (not L_BE_1) and (not V_S6_1)  # BE is not locked by anybody
        FREE_CD = (not K_CD) and (not L_CD_1) and (not V_S1J_2)  # CD is not locked by anybody
        FREE_CE = (not K_CE) and (not L_CE_1) and (not V_S5_1)  # CE is not locked by anybody
        FREE_DB = (not K_DB) and (not L_DB_2)  # DB is not locked by anybody
        QN_101 = VALID and DN_101 and (not DR_101)  # machine 101 lies N (R10)
        QR_101 = VALID and DR_101 and (not DN_101)  # machine 101 lies R (R10)
        QN_102 = VALID and DN_102 and (not DR_102)  # machine 102 lies N (R10)
        QR_102 = VALID and DR_102 and (not DN_102)  # machine 102 lies R (R10)
        MOV_101 = VALID and FREE_AC and (not OCC_AC) and (not (L_BC_1 or V_S2J_1)) and True  # machine 101 is free to move (R10)
        AVN_101 = CN_101 or MOV_101 or (QN_101 and (not CN_101) and (not CR_101))  # machine 101 can be demanded N
        AVR_101 = CR_101 or MOV_101 or (QR_101 and (not CN_101) and (not CR_101))  # machine 101 can be demanded R
        MOV_102 = VALID and FREE_BC and (not OCC_BC) and True and True  # machine 102 is free to move (R10)
        AVN_102 = CN_102 or MOV_102 or (QN_102 and (not CN_102) and (not CR_102))  # machine 102 can be demanded N
        AVR_102 = CR_102 or MOV_102 or (QR_102 and (not CN_102) and (not CR_102))  # machine 102 can be demanded R
        WF_AB_2 = FREE_AB and (not OCC_AB) and (not BLK_AB)  # AB from DM to AB|AC@101.toe: free for a route (R6)
        WA_AC_1 = AVN_101 and (not TR_101)  # AC from AB|AC@101.toe to AC|AD@101.normal: could be locked
        WF_AC_1 = FREE_AC and (not OCC_AC) and (not BLK_AC) and WA_AC_1  # AC from AB|AC@101.toe to AC|AD@101.normal: free for a route (R6)
        WA_AC_2 = (not (L_BC_1 or V_S2J_1 or K_BC)) and AVR_101 and (not TR_101)  # AC from AB|AC@101.toe to AC|CD@X1.1b: could be locked
        WF_AC_2 = FREE_AC and (not OCC_AC) and (not BLK_AC) and WA_AC_2  # AC from AB|AC@101.toe to AC|CD@X1.1b: free for a route (R6)
        WF_AD_1 = FREE_AD and (not OCC_AD) and (not BLK_AD)  # AD from AC|AD@101.normal to AD|AE@down2.0: free for a route (R6)
        WF_AE_1 = FREE_AE and (not OCC_AE) and (not BLK_AE)  # AE from AD|AE@down2.0 to DM2: free for a route (R6)
        WF_BB_2 = FREE_BB and (not OCC_BB) and (not BLK_BB)  # BB from UM2 to BB|BC@X1.2a: free for a route (R6)
        WA_BC_1 = (not (L_AC_2 or V_S1J_2 or K_AC)) and AVN_102 and AVN_101 and (not TR_102) and (not TR_101)  # BC from BB|BC@X1.2a to BC|BD@102.toe: could be locked
        WF_BC_1 = FREE_BC and (not OCC_BC) and (not BLK_BC) and WA_BC_1  # BC from BB|BC@X1.2a to BC|BD@102.toe: free for a route (R6)
        WA_BC_4 = AVR_102 and (not TR_102)  # BC from BC|DB@102.reverse to BC|BD@102.toe: could be locked
        WF_BC_4 = FREE_BC and (not OCC_BC) and (not BLK_BC) and WA_BC_4  # BC from BC|DB@102.reverse to BC|BD@102.toe: free for a route (R6)
        WF_BD_1 = FREE_BD and (not OCC_BD) and (not BLK_BD)  # BD from BC|BD@102.toe to BD|BE@up2.0: free for a route (R6)
        WF_BE_1 = FREE_BE and (not OCC_BE) and (not BLK_BE)  # BE from BD|BE@up2.0 to UM: free for a route (R6)
        WF_CD_1 = FREE_CD and (not OCC_CD) and (not BLK_CD)  # CD from AC|CD@X1.1b to CD|CE@branch.0: free for a route (R6)
        WF_CE_1 = FREE_CE and (not OCC_CE) and (not BLK_CE)  # CE from CD|CE@branch.0 to DBO: free for a route (R6)
        WF_DB_2 = FREE_DB and (not OCC_DB) and (not BLK_DB)  # DB from UB to BC|DB@102.reverse: free for a route (R6)
        OF_S1J_1 = ((not K_AC) and (not V_S1J_1) and (not V_S1J_2) and ((not L_AC_1) or A_R3) and (not L_AC_2)) and (not OCC_AC) and (not BLK_AC) and WA_AC_1 and ((not K_AD) and (not V_S1J_1) and ((not L_AD_1) or A_R3)) and (not OCC_AD) and (not BLK_AD)  # overlap 1 of S1J may be held (R4)
        OF_S1J_2 = ((not K_AC) and (not V_S1J_1) and (not V_S1J_2) and (not L_AC_1) and ((not L_AC_2) or A_R4)) and (not OCC_AC) and (not BLK_AC) and WA_AC_2 and ((not K_CD) and (not V_S1J_2) and ((not L_CD_1) or A_R4)) and (not OCC_CD) and (not BLK_CD)  # overlap 2 of S1J may be held (R4)
        OF_S2J_1 = ((not K_BC) and (not V_S2J_1) and (not V_S4J_1) and ((not L_BC_1) or A_R6) and (not L_BC_4)) and (not OCC_BC) and (not BLK_BC) and WA_BC_1 and ((not K_BD) and (not V_S2J_1) and (not V_S4J_1) and ((not L_BD_1) or A_R6)) and (not OCC_BD) and (not BLK_BD)  # overlap 1 of S2J may be held (R4)
        OF_S3_1 = ((not K_AE) and (not V_S3_1) and ((not L_AE_1) or A_R7)) and (not OCC_AE) and (not BLK_AE)  # overlap 1 of S3 may be held (R4)
        OF_S4J_1 = ((not K_BC) and (not V_S2J_1) and (not V_S4J_1) and (not L_BC_1) and ((not L_BC_4) or A_R9)) and (not OCC_BC) and (not BLK_BC) and WA_BC_4 and ((not K_BD) and (not V_S2J_1) and (not V_S4J_1) and ((not L_BD_1) or A_R9)) and (not OCC_BD) and (not BLK_BD)  # overlap 1 of S4J may be held (R4)
        OF_S5_1 = ((not K_CE) and (not V_S5_1) and ((not L_CE_1) or A_R10)) and (not OCC_CE) and (not BLK_CE)  # overlap 1 of S5 may be held (R4)
        OF_S6_1 = ((not K_BE) and (not V_S6_1) and ((not L_BE_1) or A_R11)) and (not OCC_BE) and (not BLK_BE)  # overlap 1 of S6 may be held (R4)
        WL_AB_2 = (not OCC_AB)  # AB from DM to AB|AC@101.toe: lies and is clear
        WP_AB_2 = WL_AB_2 and (not BLK_AB)  # AB from DM to AB|AC@101.toe: proceed may be shown over it (R3)
        WD_AC_1 = QN_101 and (not TR_101)  # AC from AB|AC@101.toe to AC|AD@101.normal: its points lie, nothing is foul of it
        WL_AC_1 = (not OCC_AC) and WD_AC_1  # AC from AB|AC@101.toe to AC|AD@101.normal: lies and is clear
        WP_AC_1 = WL_AC_1 and (not BLK_AC)  # AC from AB|AC@101.toe to AC|AD@101.normal: proceed may be shown over it (R3)
        WD_AC_2 = QR_101 and (not TR_101)  # AC from AB|AC@101.toe to AC|CD@X1.1b: its points lie, nothing is foul of it
        WL_AC_2 = (not OCC_AC) and WD_AC_2  # AC from AB|AC@101.toe to AC|CD@X1.1b: lies and is clear
        WP_AC_2 = WL_AC_2 and (not BLK_AC)  # AC from AB|AC@101.toe to AC|CD@X1.1b: proceed may be shown over it (R3)
        WL_AD_1 = (not OCC_AD)  # AD from AC|AD@101.normal to AD|AE@down2.0: lies and is clear
        WP_AD_1 = WL_AD_1 and (not BLK_AD)  # AD from AC|AD@101.normal to AD|AE@down2.0: proceed may be shown over it (R3)
        WL_AE_1 = (not OCC_AE)  # AE from AD|AE@down2.0 to DM2: lies and is clear
        WP_AE_1 = WL_AE_1 and (not BLK_AE)  # AE from AD|AE@down2.0 to DM2: proceed may be shown over it (R3)
        WL_BB_2 = (not OCC_BB)  # BB from UM2 to BB|BC@X1.2a: lies and is clear
        WP_BB_2 = WL_BB_2 and (not BLK_BB)  # BB from UM2 to BB|BC@X1.2a: proceed may be shown over it (R3)
        WD_BC_1 = QN_102 and QN_101 and (not TR_102) and (not TR_101)  # BC from BB|BC@X1.2a to BC|BD@102.toe: its points lie, nothing is foul of it
        WL_BC_1 = (not OCC_BC) and WD_BC_1  # BC from BB|BC@X1.2a to BC|BD@102.toe: lies and is clear
        WP_BC_1 = WL_BC_1 and (not BLK_BC)  # BC from BB|BC@X1.2a to BC|BD@102.toe: proceed may be shown over it (R3)
        WD_BC_4 = QR_102 and (not TR_102)  # BC from BC|DB@102.reverse to BC|BD@102.toe: its points lie, nothing is foul of it
        WL_BC_4 = (not OCC_BC) and WD_BC_4  # BC from BC|DB@102.reverse to BC|BD@102.toe: lies and is clear
        WP_BC_4 = WL_BC_4 and (not BLK_BC)  # BC from BC|DB@102.reverse to BC|BD@102.toe: proceed may be shown over it (R3)
        WL_BD_1 = (not OCC_BD)  # BD from BC|BD@102.toe to BD|BE@up2.0: lies and is clear
        WP_BD_1 = WL_BD_1 and (not BLK_BD)  # BD from BC|BD@102.toe to BD|BE@up2.0: proceed may be shown over it (R3)
        WL_BE_1 = (not OCC_BE)  # BE from BD|BE@up2.0 to UM: lies and is clear
        WP_BE_1 = WL_BE_1 and (not BLK_BE)  # BE from BD|BE@up2.0 to UM: proceed may be shown over it (R3)
        WL_CD_1 = (not OCC_CD)  # CD from AC|CD@X1.1b to CD|CE@branch.0: lies and is clear
        WP_CD_1 = WL_CD_1 and (not BLK_CD)  # CD from AC|CD@X1.1b to CD|CE@branch.0: proceed may be shown over it (R3)
        WL_CE_1 = (not OCC_CE)  # CE from CD|CE@branch.0 to DBO: lies and is clear
        WP_CE_1 = WL_CE_1 and (not BLK_CE)  # CE from CD|CE@branch.0 to DBO: proceed may be shown over it (R3)
        WL_DB_2 = (not OCC_DB)  # DB from UB to BC|DB@102.reverse: lies and is clear
        WP_DB_2 = WL_DB_2 and (not BLK_DB)  # DB from UB to BC|DB@102.reverse: proceed may be shown over it (R3)
        G_R1 = (REQ == 1) and VALID and WF_AB_2 and OF_S1J_1  # grant of route S1-S1J (R6)
        G_R2 = (REQ == 2) and VALID and WF_AB_2 and OF_S1J_2  # grant of route S1-S1J.o2 (R6)
        G_R3 = (REQ == 3) and VALID and ((not K_AC) and (not L_AC_1) and (not L_AC_2) and (not V_S1J_2)) and (not OCC_AC) and (not BLK_AC) and WA_AC_1 and ((not K_AD) and (not L_AD_1)) and (not OCC_AD) and (not BLK_AD) and OF_S3_1  # grant of route S1J-S3 (R6)
        G_R4 = (REQ == 4) and VALID and ((not K_AC) and (not L_AC_1) and (not L_AC_2) and (not V_S1J_1)) and (not OCC_AC) and (not BLK_AC) and WA_AC_2 and ((not K_CD) and (not L_CD_1)) and (not OCC_CD) and (not BLK_CD) and OF_S5_1  # grant of route S1J-S5 (R6)
        G_R5 = (REQ == 5) and VALID and WF_BB_2 and OF_S2J_1  # grant of route S2-S2J (R6)
        G_R6 = (REQ == 6) and VALID and ((not K_BC) and (not L_BC_1) and (not L_BC_4) and (not V_S4J_1)) and (not OCC_BC) and (not BLK_BC) and WA_BC_1 and ((not K_BD) and (not L_BD_1) and (not V_S4J_1)) and (not OCC_BD) and (not BLK_BD) and OF_S6_1  # grant of route S2J-S6 (R6)
        G_R7 = (REQ == 7) and VALID and ((not K_AE) and (not L_AE_1)) and (not OCC_AE) and (not BLK_AE)  # grant of route S3-DM2 (R6)
        G_R8 = (REQ == 8) and VALID and WF_DB_2 and OF_S4J_1  # grant of route S4-S4J (R6)
        G_R9 = (REQ == 9) and VALID and ((not K_BC) and (not L_BC_1) and (not L_BC_4) and (not V_S2J_1)) and (not OCC_BC) and (not BLK_BC) and WA_BC_4 and ((not K_BD) and (not L_BD_1) and (not V_S2J_1)) and (not OCC_BD) and (not BLK_BD) and OF_S6_1  # grant of route S4J-S6 (R6)
        G_R10 = (REQ == 10) and VALID and ((not K_CE) and (not L_CE_1)) and (not OCC_CE) and (not BLK_CE)  # grant of route S5-DBO (R6)
        G_R11 = (REQ == 11) and VALID and ((not K_BE) and (not L_BE_1)) and (not OCC_BE) and (not BLK_BE)  # grant of route S6-UM (R6)
        GW_AB_2 = G_R1 or G_R2  # AB from DM to AB|AC@101.toe: granted
        GW_AC_1 = G_R3  # AC from AB|AC@101.toe to AC|AD@101.normal: granted
        GW_AC_2 = G_R4  # AC from AB|AC@101.toe to AC|CD@X1.1b: granted
        GW_AD_1 = G_R3  # AD from AC|AD@101.normal to AD|AE@down2.0: granted
        GW_AE_1 = G_R7  # AE from AD|AE@down2.0 to DM2: granted
        GW_BB_2 = G_R5  # BB from UM2 to BB|BC@X1.2a: granted
        GW_BC_1 = G_R6  # BC from BB|BC@X1.2a to BC|BD@102.toe: granted
        GW_BC_4 = G_R9  # BC from BC|DB@102.reverse to BC|BD@102.toe: granted
        GW_BD_1 = G_R6 or G_R9  # BD from BC|BD@102.toe to BD|BE@up2.0: granted
        GW_BE_1 = G_R11  # BE from BD|BE@up2.0 to UM: granted
        GW_CD_1 = G_R4  # CD from AC|CD@X1.1b to CD|CE@branch.0: granted
        GW_CE_1 = G_R10  # CE from CD|CE@branch.0 to DBO: granted
        GW_DB_2 = G_R8  # DB from UB to BC|DB@102.reverse: granted
        GO_S1J_1 = G_R1  # overlap 1 of S1J: granted
        GO_S1J_2 = G_R2  # overlap 2 of S1J: granted
        GO_S2J_1 = G_R5  # overlap 1 of S2J: granted
        GO_S3_1 = G_R3  # overlap 1 of S3: granted
        GO_S4J_1 = G_R8  # overlap 1 of S4J: granted
        GO_S5_1 = G_R4  # overlap 1 of S5: granted
        GO_S6_1 = G_R6 or G_R9  # overlap 1 of S6: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_S1) and (not CAN_S1) and WL_AB_2 and WL_AC_1 and WL_AD_1  # route S1-S1J becomes locked (R3)
        CO_R1 = VALID and WP_AB_2 and WL_AC_1 and WL_AD_1 and (not D_AB) and V_S1J_1  # conditions of proceed for route S1-S1J (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_S1) and (not CAN_S1) and WL_AB_2 and WL_AC_2 and WL_CD_1  # route S1-S1J.o2 becomes locked (R3)
        CO_R2 = VALID and WP_AB_2 and WL_AC_2 and WL_CD_1 and (not D_AB) and V_S1J_2  # conditions of proceed for route S1-S1J.o2 (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_S1J) and (not CAN_S1J) and WL_AC_1 and WL_AD_1 and WL_AE_1  # route S1J-S3 becomes locked (R3)
        CO_R3 = VALID and WP_AC_1 and WP_AD_1 and WL_AE_1 and (not D_AC) and V_S3_1  # conditions of proceed for route S1J-S3 (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_S1J) and (not CAN_S1J) and WL_AC_2 and WL_CD_1 and WL_CE_1  # route S1J-S5 becomes locked (R3)
        CO_R4 = VALID and WP_AC_2 and WP_CD_1 and WL_CE_1 and (not D_AC) and V_S5_1  # conditions of proceed for route S1J-S5 (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_S2) and (not CAN_S2) and WL_BB_2 and WL_BC_1 and WL_BD_1  # route S2-S2J becomes locked (R3)
        CO_R5 = VALID and WP_BB_2 and WL_BC_1 and WL_BD_1 and (not D_BB) and V_S2J_1  # conditions of proceed for route S2-S2J (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_S2J) and (not CAN_S2J) and WL_BC_1 and WL_BD_1 and WL_BE_1  # route S2J-S6 becomes locked (R3)
        CO_R6 = VALID and WP_BC_1 and WP_BD_1 and WL_BE_1 and (not D_BC) and V_S6_1  # conditions of proceed for route S2J-S6 (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_S3) and (not CAN_S3) and WL_AE_1  # route S3-DM2 becomes locked (R3)
        CO_R7 = VALID and WP_AE_1 and (not D_AE)  # conditions of proceed for route S3-DM2 (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_S4) and (not CAN_S4) and WL_DB_2 and WL_BC_4 and WL_BD_1  # route S4-S4J becomes locked (R3)
        CO_R8 = VALID and WP_DB_2 and WL_BC_4 and WL_BD_1 and (not D_DB) and V_S4J_1  # conditions of proceed for route S4-S4J (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_S4J) and (not CAN_S4J) and WL_BC_4 and WL_BD_1 and WL_BE_1  # route S4J-S6 becomes locked (R3)
        CO_R9 = VALID and WP_BC_4 and WP_BD_1 and WL_BE_1 and (not D_BC) and V_S6_1  # conditions of proceed for route S4J-S6 (R3)
        LK_R10 = A_R10 and (not B_R10) and VALID and (not X_S5) and (not CAN_S5) and WL_CE_1  # route S5-DBO becomes locked (R3)
        CO_R10 = VALID and WP_CE_1 and (not D_CE)  # conditions of proceed for route S5-DBO (R3)
        LK_R11 = A_R11 and (not B_R11) and VALID and (not X_S6) and (not CAN_S6) and WL_BE_1  # route S6-UM becomes locked (R3)
        CO_R11 = VALID and WP_BE_1 and (not D_BE)  # conditions of proceed for route S6-UM (R3)
        NU_AB_2 = VALID and F_AB and (not D_AB) and (not U_AB) and L_AB_2 and OCC_AB and OCC_AA  # a train comes into AB at DM (R9)
        NU_AC_1 = VALID and F_AC and (not D_AC) and (not U_AC) and (L_AC_1 or L_AC_2) and OCC_AC and OCC_AB  # a train comes into AC at AB|AC@101.toe (R9)
        NU_AD_1 = VALID and F_AD and (not D_AD) and (not U_AD) and L_AD_1 and OCC_AD and OCC_AC and (V_S1J_1 or U_AC) and (V_S1J_1 or L_AC_1)  # a train comes into AD at AC|AD@101.normal (R9)
        NU_AE_1 = VALID and F_AE and (not D_AE) and (not U_AE) and L_AE_1 and OCC_AE and OCC_AD  # a train comes into AE at AD|AE@down2.0 (R9)
        NU_BB_2 = VALID and F_BB and (not D_BB) and (not U_BB) and L_BB_2 and OCC_BB and OCC_BA  # a train comes into BB at UM2 (R9)
        NU_BC_1 = VALID and F_BC and (not D_BC) and (not U_BC) and L_BC_1 and OCC_BC and OCC_BB  # a train comes into BC at BB|BC@X1.2a (R9)
        NU_BC_3 = VALID and F_BC and (not D_BC) and (not U_BC) and L_BC_4 and OCC_BC and OCC_DB  # a train comes into BC at BC|DB@102.reverse (R9)
        NU_BD_1 = VALID and F_BD and (not D_BD) and (not U_BD) and L_BD_1 and OCC_BD and OCC_BC and (V_S2J_1 or V_S4J_1 or U_BC) and (V_S2J_1 or V_S4J_1 or L_BC_1 or L_BC_4)  # a train comes into BD at BC|BD@102.toe (R9)
        NU_BE_1 = VALID and F_BE and (not D_BE) and (not U_BE) and L_BE_1 and OCC_BE and OCC_BD  # a train comes into BE at BD|BE@up2.0 (R9)
        NU_CD_1 = VALID and F_CD and (not D_CD) and (not U_CD) and L_CD_1 and OCC_CD and OCC_AC and (V_S1J_2 or U_AC) and (V_S1J_2 or L_AC_2)  # a train comes into CD at AC|CD@X1.1b (R9)
        NU_CE_1 = VALID and F_CE and (not D_CE) and (not U_CE) and L_CE_1 and OCC_CE and OCC_CD  # a train comes into CE at CD|CE@branch.0 (R9)
        NU_DB_2 = VALID and F_DB and (not D_DB) and (not U_DB) and L_DB_2 and OCC_DB and OCC_DA  # a train comes into DB at UB (R9)
        ATI_S1 = X_S1 or ((not (A_R1 or A_R2)) and L_AB_2 and REL_AB)  # S1 at stop, waiting for a train that may still come (R8)
        ATI_S1J = X_S1J or ((not (A_R3 or A_R4)) and (L_AC_1 or L_AC_2) and REL_AC)  # S1J at stop, waiting for a train that may still come (R8)
        ATI_S2 = X_S2 or ((not A_R5) and L_BB_2 and REL_BB)  # S2 at stop, waiting for a train that may still come (R8)
        ATI_S2J = X_S2J or ((not A_R6) and L_BC_1 and REL_BC)  # S2J at stop, waiting for a train that may still come (R8)
        ATI_S3 = X_S3 or ((not A_R7) and L_AE_1 and (REL_AE or (L_AE_1 and U_AE and (not OCC_AE))))  # S3 at stop, waiting for a train that may still come (R8)
        ATI_S4 = X_S4 or ((not A_R8) and L_DB_2 and REL_DB)  # S4 at stop, waiting for a train that may still come (R8)
        ATI_S4J = X_S4J or ((not A_R9) and L_BC_4 and REL_BC)  # S4J at stop, waiting for a train that may still come (R8)
        ATI_S5 = X_S5 or ((not A_R10) and L_CE_1 and (REL_CE or (L_CE_1 and U_CE and (not OCC_CE))))  # S5 at stop, waiting for a train that may still come (R8)
        ATI_S6 = X_S6 or ((not A_R11) and L_BE_1 and (REL_BE or (L_BE_1 and U_BE and (not OCC_BE))))  # S6 at stop, waiting for a train that may still come (R8)
        AT_S1 = self._timer('AT_S1', ATI_S1, dt_ms)  # S1: approach locking delay (R8)
        AT_S1J = self._timer('AT_S1J', ATI_S1J, dt_ms)  # S1J: approach locking delay (R8)
        AT_S2 = self._timer('AT_S2', ATI_S2, dt_ms)  # S2: approach locking delay (R8)
        AT_S2J = self._timer('AT_S2J', ATI_S2J, dt_ms)  # S2J: approach locking delay (R8)
        AT_S3 = self._timer('AT_S3', ATI_S3, dt_ms)  # S3: approach locking delay (R8)
        AT_S4 = self._timer('AT_S4', ATI_S4, dt_ms)  # S4: approach locking delay (R8)
        AT_S4J = self._timer('AT_S4J', ATI_S4J, dt_ms)  # S4J: approach locking delay (R8)
        AT_S5 = self._timer('AT_S5', ATI_S5, dt_ms)  # S5: approach locking delay (R8)
        AT_S6 = self._timer('AT_S6', ATI_S6, dt_ms)  # S6: approach locking delay (R8)
        CD_S1 = X_S1 and (A_R1 or A_R2) and VALID and (not OCC_AB) and ((not OCC_AA) or AT_S1 or (not (H_R1 or H_R2)))  # the route from S1 is cancelled (R8)
        CD_S1J = X_S1J and (A_R3 or A_R4) and VALID and (not OCC_AC) and ((not OCC_AB) or AT_S1J or (not (H_R3 or H_R4)))  # the route from S1J is cancelled (R8)
        CD_S2 = X_S2 and A_R5 and VALID and (not OCC_BB) and ((not OCC_BA) or AT_S2 or (not H_R5))  # the route from S2 is cancelled (R8)
        CD_S2J = X_S2J and A_R6 and VALID and (not OCC_BC) and ((not OCC_BB) or AT_S2J or (not H_R6))  # the route from S2J is cancelled (R8)
        CD_S3 = X_S3 and A_R7 and VALID and (not OCC_AE) and ((not OCC_AD) or AT_S3 or (not H_R7))  # the route from S3 is cancelled (R8)
        CD_S4 = X_S4 and A_R8 and VALID and (not OCC_DB) and ((not OCC_DA) or AT_S4 or (not H_R8))  # the route from S4 is cancelled (R8)
        CD_S4J = X_S4J and A_R9 and VALID and (not OCC_BC) and ((not OCC_DB) or AT_S4J or (not H_R9))  # the route from S4J is cancelled (R8)
        CD_S5 = X_S5 and A_R10 and VALID and (not OCC_CE) and ((not OCC_CD) or AT_S5 or (not H_R10))  # the route from S5 is cancelled (R8)
        CD_S6 = X_S6 and A_R11 and VALID and (not OCC_BE) and ((not OCC_BD) or AT_S6 or (not H_R11))  # the route from S6 is cancelled (R8)
        EX_AB = P_AB  # a train in AB leaves over a boundary, or has passed on
        RTI_AB = VALID and U_AB and (not OCC_AB) and EX_AB  # AB may be released behind the train (R9)
        EX_AC = P_AC  # a train in AC leaves over a boundary, or has passed on
        RTI_AC = VALID and U_AC and (not OCC_AC) and EX_AC  # AC may be released behind the train (R9)
        EX_AD = P_AD  # a train in AD leaves over a boundary, or has passed on
        RTI_AD = VALID and U_AD and (not OCC_AD) and (not (L_AD_1 and L_AC_1)) and EX_AD  # AD may be released behind the train (R9)
        EX_AE = P_AE or (L_AE_1 and ((not OCC_AD) or AT_S3))  # a train in AE leaves over a boundary, or has passed on
        RTI_AE = VALID and U_AE and (not OCC_AE) and EX_AE  # AE may be released behind the train (R9)
        EX_BB = P_BB  # a train in BB leaves over a boundary, or has passed on
        RTI_BB = VALID and U_BB and (not OCC_BB) and EX_BB  # BB may be released behind the train (R9)
        EX_BC = P_BC  # a train in BC leaves over a boundary, or has passed on
        RTI_BC = VALID and U_BC and (not OCC_BC) and EX_BC  # BC may be released behind the train (R9)
        EX_BD = P_BD  # a train in BD leaves over a boundary, or has passed on
        RTI_BD = VALID and U_BD and (not OCC_BD) and (not (L_BD_1 and (L_BC_1 or L_BC_4))) and EX_BD  # BD may be released behind the train (R9)
        EX_BE = P_BE or (L_BE_1 and ((not OCC_BD) or AT_S6))  # a train in BE leaves over a boundary, or has passed on
        RTI_BE = VALID and U_BE and (not OCC_BE) and EX_BE  # BE may be released behind the train (R9)
        EX_CD = P_CD  # a train in CD leaves over a boundary, or has passed on
        RTI_CD = VALID and U_CD and (not OCC_CD) and (not (L_CD_1 and L_AC_2)) and EX_CD  # CD may be released behind the train (R9)
        EX_CE = P_CE or (L_CE_1 and ((not OCC_CD) or AT_S5))  # a train in CE leaves over a boundary, or has passed on
        RTI_CE = VALID and U_CE and (not OCC_CE) and EX_CE  # CE may be released behind the train (R9)
        EX_DB = P_DB  # a train in DB leaves over a boundary, or has passed on
        RTI_DB = VALID and U_DB and (not OCC_DB) and EX_DB  # DB may be released behind the train (R9)
        RT_AB = self._timer('RT_AB', RTI_AB, dt_ms)  # AB: release delay (R9)
        RT_AC = self._timer('RT_AC', RTI_AC, dt_ms)  # AC: release delay (R9)
        RT_AD = self._timer('RT_AD', RTI_AD, dt_ms)  # AD: release delay (R9)
        RT_AE = self._timer('RT_AE', RTI_AE, dt_ms)  # AE: release delay (R9)
        RT_BB = self._timer('RT_BB', RTI_BB, dt_ms)  # BB: release delay (R9)
        RT_BC = self._timer('RT_BC', RTI_BC, dt_ms)  # BC: release delay (R9)
        RT_BD = self._timer('RT_BD', RTI_BD, dt_ms)  # BD: release delay (R9)
        RT_BE = self._timer('RT_BE', RTI_BE, dt_ms)  # BE: release delay (R9)
        RT_CD = self._timer('RT_CD', RTI_CD, dt_ms)  # CD: release delay (R9)
        RT_CE = self._timer('RT_CE', RTI_CE, dt_ms)  # CE: release delay (R9)
        RT_DB = self._timer('RT_DB', RTI_DB, dt_ms)  # DB: release delay (R9)
        CA_AB = VALID and (not OCC_AB) and (not U_AB) and False  # the lock before AB was withdrawn (R8)
        HR_AB = VALID and (not OCC_AB) and REL_AB and L_AB_2 and ((not L_AB_2) or ((not (A_R1 or A_R2)) and ((not OCC_AA) or AT_S1)))  # AB released by hand (R8, section fault release)
        SR_AB = VALID and (not OCC_AB) and K_AB and (REL_AB or RELALL)  # AB released after a restart (R16)
        RLS_AB = RT_AB or CA_AB or CD_S1 or HR_AB or SR_AB  # AB is released
        CA_AC = VALID and (not OCC_AC) and (not U_AC) and False  # the lock before AC was withdrawn (R8)
        HR_AC = VALID and (not OCC_AC) and REL_AC and (L_AC_1 or L_AC_2) and ((not (L_AC_1 or L_AC_2)) or ((not (A_R3 or A_R4)) and ((not OCC_AB) or AT_S1J)))  # AC released by hand (R8, section fault release)
        SR_AC = VALID and (not OCC_AC) and K_AC and (REL_AC or RELALL)  # AC released after a restart (R16)
        RLS_AC = RT_AC or CA_AC or CD_S1J or HR_AC or SR_AC  # AC is released
        CA_AD = VALID and (not OCC_AD) and (not U_AD) and L_AD_1 and (not (L_AD_1 and L_AC_1))  # the lock before AD was withdrawn (R8)
        HR_AD = VALID and (not OCC_AD) and (not (L_AD_1 and L_AC_1)) and REL_AD and L_AD_1  # AD released by hand (R8, section fault release)
        SR_AD = VALID and (not OCC_AD) and K_AD and (REL_AD or RELALL)  # AD released after a restart (R16)
        RLS_AD = RT_AD or CA_AD or HR_AD or SR_AD  # AD is released
        CA_AE = VALID and (not OCC_AE) and (not U_AE) and False  # the lock before AE was withdrawn (R8)
        HR_AE = VALID and (not OCC_AE) and REL_AE and L_AE_1 and ((not L_AE_1) or ((not A_R7) and ((not OCC_AD) or AT_S3)))  # AE released by hand (R8, section fault release)
        SR_AE = VALID and (not OCC_AE) and K_AE and (REL_AE or RELALL)  # AE released after a restart (R16)
        RLS_AE = RT_AE or CA_AE or CD_S3 or HR_AE or SR_AE  # AE is released
        CA_BB = VALID and (not OCC_BB) and (not U_BB) and False  # the lock before BB was withdrawn (R8)
        HR_BB = VALID and (not OCC_BB) and REL_BB and L_BB_2 and ((not L_BB_2) or ((not A_R5) and ((not OCC_BA) or AT_S2)))  # BB released by hand (R8, section fault release)
        SR_BB = VALID and (not OCC_BB) and K_BB and (REL_BB or RELALL)  # BB released after a restart (R16)
        RLS_BB = RT_BB or CA_BB or CD_S2 or HR_BB or SR_BB  # BB is released
        CA_BC = VALID and (not OCC_BC) and (not U_BC) and False  # the lock before BC was withdrawn (R8)
        HR_BC = VALID and (not OCC_BC) and REL_BC and (L_BC_1 or L_BC_4) and ((not L_BC_1) or ((not A_R6) and ((not OCC_BB) or AT_S2J))) and ((not L_BC_4) or ((not A_R9) and ((not OCC_DB) or AT_S4J)))  # BC released by hand (R8, section fault release)
        SR_BC = VALID and (not OCC_BC) and K_BC and (REL_BC or RELALL)  # BC released after a restart (R16)
        RLS_BC = RT_BC or CA_BC or CD_S2J or CD_S4J or HR_BC or SR_BC  # BC is released
        CA_BD = VALID and (not OCC_BD) and (not U_BD) and L_BD_1 and (not (L_BD_1 and (L_BC_1 or L_BC_4)))  # the lock before BD was withdrawn (R8)
        HR_BD = VALID and (not OCC_BD) and (not (L_BD_1 and (L_BC_1 or L_BC_4))) and REL_BD and L_BD_1  # BD released by hand (R8, section fault release)
        SR_BD = VALID and (not OCC_BD) and K_BD and (REL_BD or RELALL)  # BD released after a restart (R16)
        RLS_BD = RT_BD or CA_BD or HR_BD or SR_BD  # BD is released
        CA_BE = VALID and (not OCC_BE) and (not U_BE) and False  # the lock before BE was withdrawn (R8)
        HR_BE = VALID and (not OCC_BE) and REL_BE and L_BE_1 and ((not L_BE_1) or ((not A_R11) and ((not OCC_BD) or AT_S6)))  # BE released by hand (R8, section fault release)
        SR_BE = VALID and (not OCC_BE) and K_BE and (REL_BE or RELALL)  # BE released after a restart (R16)
        RLS_BE = RT_BE or CA_BE or CD_S6 or HR_BE or SR_BE  # BE is released
        CA_CD = VALID and (not OCC_CD) and (not U_CD) and L_CD_1 and (not (L_CD_1 and L_AC_2))  # the lock before CD was withdrawn (R8)
        HR_CD = VALID and (not OCC_CD) and (not (L_CD_1 and L_AC_2)) and REL_CD and L_CD_1  # CD released by hand (R8, section fault release)
        SR_CD = VALID and (not OCC_CD) and K_CD and (REL_CD or RELALL)  # CD released after a restart (R16)
        RLS_CD = RT_CD or CA_CD or HR_CD or SR_CD  # CD is released
        CA_CE = VALID and (not OCC_CE) and (not U_CE) and False  # the lock before CE was withdrawn (R8)
        HR_CE = VALID and (not OCC_CE) and REL_CE and L_CE_1 and ((not L_CE_1) or ((not A_R10) and ((not OCC_CD) or AT_S5)))  # CE released by hand (R8, section fault release)
        SR_CE = VALID and (not OCC_CE) and K_CE and (REL_CE or RELALL)  # CE released after a restart (R16)
        RLS_CE = RT_CE or CA_CE or CD_S5 or HR_CE or SR_CE  # CE is released
        CA_DB = VALID and (not OCC_DB) and (not U_DB) and False  # the lock before DB was withdrawn (R8)
        HR_DB = VALID and (not OCC_DB) and REL_DB and L_DB_2 and ((not L_DB_2) or ((not A_R8) and ((not OCC_DA) or AT_S4)))  # DB released by hand (R8, section fault release)
        SR_DB = VALID and (not OCC_DB) and K_DB and (REL_DB or RELALL)  # DB released after a restart (R16)
        RLS_DB = RT_DB or CA_DB or CD_S4 or HR_DB or SR_DB  # DB is released
        OTI_S1J = VALID and U_AB and (not (L_AB_2 and OCC_AA)) and L_AB_2 and OCC_AB  # the train before S1J is wholly in AB (R4)
        OTI_S2J = VALID and U_BB and (not (L_BB_2 and OCC_BA)) and L_BB_2 and OCC_BB  # the train before S2J is wholly in BB (R4)
        OTI_S3 = VALID and U_AD and (not (L_AD_1 and L_AC_1)) and L_AD_1 and OCC_AD  # the train before S3 is wholly in AD (R4)
        OTI_S4J = VALID and U_DB and (not (L_DB_2 and OCC_DA)) and L_DB_2 and OCC_DB  # the train before S4J is wholly in DB (R4)
        OTI_S5 = VALID and U_CD and (not (L_CD_1 and L_AC_2)) and L_CD_1 and OCC_CD  # the train before S5 is wholly in CD (R4)
        OTI_S6 = VALID and U_BD and (not (L_BD_1 and (L_BC_1 or L_BC_4))) and L_BD_1 and OCC_BD  # the train before S6 is wholly in BD (R4)
        OT_S1J = self._timer('OT_S1J', OTI_S1J, dt_ms)  # S1J: the train before it stands (R4)
        OT_S2J = self._timer('OT_S2J', OTI_S2J, dt_ms)  # S2J: the train before it stands (R4)
        OT_S3 = self._timer('OT_S3', OTI_S3, dt_ms)  # S3: the train before it stands (R4)
        OT_S4J = self._timer('OT_S4J', OTI_S4J, dt_ms)  # S4J: the train before it stands (R4)
        OT_S5 = self._timer('OT_S5', OTI_S5, dt_ms)  # S5: the train before it stands (R4)
        OT_S6 = self._timer('OT_S6', OTI_S6, dt_ms)  # S6: the train before it stands (R4)
        OR_S1J = (not L_AB_2) or OT_S1J  # the overlap of S1J is not needed any more (R4)
        OR_S2J = (not L_BB_2) or OT_S2J  # the overlap of S2J is not needed any more (R4)
        OR_S3 = (not L_AD_1) or OT_S3  # the overlap of S3 is not needed any more (R4)
        OR_S4J = (not L_DB_2) or OT_S4J  # the overlap of S4J is not needed any more (R4)
        OR_S5 = (not L_CD_1) or OT_S5  # the overlap of S5 is not needed any more (R4)
        OR_S6 = (not L_BD_1) or OT_S6  # the overlap of S6 is not needed any more (R4)
        TG_101 = (GW_AC_1 or GO_S1J_1 or GW_AC_2 or GO_S1J_2 or GW_BC_1 or GO_S2J_1)  # a grant touches machine 101 in this scan
        GPN_101 = (GW_AC_1 or GO_S1J_1 or GW_BC_1 or GO_S2J_1)  # a grant needs 101 N
        MAN_101 = MN_101 and (not MR_101) and MOV_101 and (not TG_101)  # machine 101 moved N by hand
        GPR_101 = (GW_AC_2 or GO_S1J_2)  # a grant needs 101 R
        MAR_101 = MR_101 and (not MN_101) and MOV_101 and (not TG_101)  # machine 101 moved R by hand
        HDN_101 = CN_101 and (not GPR_101) and (not MAR_101)  # the command N stays
        HDR_101 = CR_101 and (not GPN_101) and (not MAN_101)  # the command R stays
        TG_102 = (GW_BC_1 or GO_S2J_1 or GW_BC_4 or GO_S4J_1)  # a grant touches machine 102 in this scan
        GPN_102 = (GW_BC_1 or GO_S2J_1)  # a grant needs 102 N
        MAN_102 = MN_102 and (not MR_102) and MOV_102 and (not TG_102)  # machine 102 moved N by hand
        GPR_102 = (GW_BC_4 or GO_S4J_1)  # a grant needs 102 R
        MAR_102 = MR_102 and (not MN_102) and MOV_102 and (not TG_102)  # machine 102 moved R by hand
        HDN_102 = CN_102 and (not GPR_102) and (not MAR_102)  # the command N stays
        HDR_102 = CR_102 and (not GPN_102) and (not MAN_102)  # the command R stays
        STI_101 = (CN_101 and (not QN_101)) or (CR_101 and (not QR_101))  # machine 101 is not where it was commanded
        STI_102 = (CN_102 and (not QN_102)) or (CR_102 and (not QR_102))  # machine 102 is not where it was commanded
        ST_101 = self._timer('ST_101', STI_101, dt_ms)  # machine 101: time-out
        ST_102 = self._timer('ST_102', STI_102, dt_ms)  # machine 102: time-out
        KP_R1 = (not NU_AB_2) and (not CD_S1)  # route S1-S1J stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_S1) and (not CAN_S1)  # proceed for route S1-S1J (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route S1-S1J: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_AB_2) and (not CD_S1)  # route S1-S1J.o2 stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_S1) and (not CAN_S1)  # proceed for route S1-S1J.o2 (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route S1-S1J.o2: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_AC_1) and (not CD_S1J)  # route S1J-S3 stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_S1J) and (not CAN_S1J)  # proceed for route S1J-S3 (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route S1J-S3: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_AC_1) and (not CD_S1J)  # route S1J-S5 stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_S1J) and (not CAN_S1J)  # proceed for route S1J-S5 (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route S1J-S5: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_BB_2) and (not CD_S2)  # route S2-S2J stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_S2) and (not CAN_S2)  # proceed for route S2-S2J (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route S2-S2J: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_BC_1) and (not CD_S2J)  # route S2J-S6 stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_S2J) and (not CAN_S2J)  # proceed for route S2J-S6 (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route S2J-S6: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_AE_1) and (not CD_S3)  # route S3-DM2 stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_S3) and (not CAN_S3)  # proceed for route S3-DM2 (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route S3-DM2: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_DB_2) and (not CD_S4)  # route S4-S4J stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_S4) and (not CAN_S4)  # proceed for route S4-S4J (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route S4-S4J: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_BC_3) and (not CD_S4J)  # route S4J-S6 stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_S4J) and (not CAN_S4J)  # proceed for route S4J-S6 (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route S4J-S6: a condition was lost; no reopening by itself (R14)
        KP_R10 = (not NU_CE_1) and (not CD_S5)  # route S5-DBO stays set
        PR_R10 = A_R10 and B_R10 and W_R10 and CO_R10 and KP_R10 and (not X_S5) and (not CAN_S5)  # proceed for route S5-DBO (R3, R11)
        LS_R10 = S_R10 and (not CO_R10)  # route S5-DBO: a condition was lost; no reopening by itself (R14)
        KP_R11 = (not NU_BE_1) and (not CD_S6)  # route S6-UM stays set
        PR_R11 = A_R11 and B_R11 and W_R11 and CO_R11 and KP_R11 and (not X_S6) and (not CAN_S6)  # proceed for route S6-UM (R3, R11)
        LS_R11 = S_R11 and (not CO_R11)  # route S6-UM: a condition was lost; no reopening by itself (R14)
        N_CN_101 = GPN_101 or MAN_101 or HDN_101  # machine 101 commanded N
        N_CR_101 = GPR_101 or MAR_101 or HDR_101  # machine 101 commanded R
        N_CN_102 = GPN_102 or MAN_102 or HDN_102  # machine 102 commanded N
        N_CR_102 = GPR_102 or MAR_102 or HDR_102  # machine 102 commanded R
        N_AL_101 = ST_101  # alarm: machine 101 not detected
        N_AL_102 = ST_102  # alarm: machine 102 not detected
        N_TH_101 = ((CN_101 and QN_101) or (CR_101 and QR_101)) and (not (GPN_101 or GPR_101 or MAN_101 or MAR_101))  # machine 101 was detected where it is commanded
        N_TR_101 = (TH_101 and VALID and ((CN_101 and (not QN_101) and (not GPR_101) and (not MAR_101)) or (CR_101 and (not QR_101) and (not GPN_101) and (not MAN_101)))) or (TR_101 and (not (TC_101 and VALID and (not OCC_AC))))  # machine 101 was trailed
        N_TH_102 = ((CN_102 and QN_102) or (CR_102 and QR_102)) and (not (GPN_102 or GPR_102 or MAN_102 or MAR_102))  # machine 102 was detected where it is commanded
        N_TR_102 = (TH_102 and VALID and ((CN_102 and (not QN_102) and (not GPR_102) and (not MAR_102)) or (CR_102 and (not QR_102) and (not GPN_102) and (not MAN_102)))) or (TR_102 and (not (TC_102 and VALID and (not OCC_BC))))  # machine 102 was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route S1-S1J active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route S1-S1J locked
        N_W_R1 = (W_R1 or LK_R1 or ((REQ == 1) and B_R1)) and (not LS_R1) and KP_R1 and (not X_S1) and (not CAN_S1)  # route S1-S1J: proceed wanted
        N_S_R1 = PR_R1  # route S1-S1J: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route S1-S1J: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route S1-S1J.o2 active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route S1-S1J.o2 locked
        N_W_R2 = (W_R2 or LK_R2 or ((REQ == 2) and B_R2)) and (not LS_R2) and KP_R2 and (not X_S1) and (not CAN_S1)  # route S1-S1J.o2: proceed wanted
        N_S_R2 = PR_R2  # route S1-S1J.o2: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route S1-S1J.o2: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route S1J-S3 active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route S1J-S3 locked
        N_W_R3 = (W_R3 or LK_R3 or ((REQ == 3) and B_R3)) and (not LS_R3) and KP_R3 and (not X_S1J) and (not CAN_S1J)  # route S1J-S3: proceed wanted
        N_S_R3 = PR_R3  # route S1J-S3: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route S1J-S3: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route S1J-S5 active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route S1J-S5 locked
        N_W_R4 = (W_R4 or LK_R4 or ((REQ == 4) and B_R4)) and (not LS_R4) and KP_R4 and (not X_S1J) and (not CAN_S1J)  # route S1J-S5: proceed wanted
        N_S_R4 = PR_R4  # route S1J-S5: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route S1J-S5: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route S2-S2J active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route S2-S2J locked
        N_W_R5 = (W_R5 or LK_R5 or ((REQ == 5) and B_R5)) and (not LS_R5) and KP_R5 and (not X_S2) and (not CAN_S2)  # route S2-S2J: proceed wanted
        N_S_R5 = PR_R5  # route S2-S2J: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route S2-S2J: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route S2J-S6 active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route S2J-S6 locked
        N_W_R6 = (W_R6 or LK_R6 or ((REQ == 6) and B_R6)) and (not LS_R6) and KP_R6 and (not X_S2J) and (not CAN_S2J)  # route S2J-S6: proceed wanted
        N_S_R6 = PR_R6  # route S2J-S6: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route S2J-S6: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route S3-DM2 active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route S3-DM2 locked
        N_W_R7 = (W_R7 or LK_R7 or ((REQ == 7) and B_R7)) and (not LS_R7) and KP_R7 and (not X_S3) and (not CAN_S3)  # route S3-DM2: proceed wanted
        N_S_R7 = PR_R7  # route S3-DM2: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route S3-DM2: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route S4-S4J active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route S4-S4J locked
        N_W_R8 = (W_R8 or LK_R8 or ((REQ == 8) and B_R8)) and (not LS_R8) and KP_R8 and (not X_S4) and (not CAN_S4)  # route S4-S4J: proceed wanted
        N_S_R8 = PR_R8  # route S4-S4J: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route S4-S4J: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route S4J-S6 active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route S4J-S6 locked
        N_W_R9 = (W_R9 or LK_R9 or ((REQ == 9) and B_R9)) and (not LS_R9) and KP_R9 and (not X_S4J) and (not CAN_S4J)  # route S4J-S6: proceed wanted
        N_S_R9 = PR_R9  # route S4J-S6: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route S4J-S6: signal has been open
        N_A_R10 = (A_R10 or G_R10) and KP_R10  # route S5-DBO active
        N_B_R10 = (B_R10 or LK_R10) and KP_R10  # route S5-DBO locked
        N_W_R10 = (W_R10 or LK_R10 or ((REQ == 10) and B_R10)) and (not LS_R10) and KP_R10 and (not X_S5) and (not CAN_S5)  # route S5-DBO: proceed wanted
        N_S_R10 = PR_R10  # route S5-DBO: proceed
        N_H_R10 = (H_R10 or PR_R10) and KP_R10  # route S5-DBO: signal has been open
        N_A_R11 = (A_R11 or G_R11) and KP_R11  # route S6-UM active
        N_B_R11 = (B_R11 or LK_R11) and KP_R11  # route S6-UM locked
        N_W_R11 = (W_R11 or LK_R11 or ((REQ == 11) and B_R11)) and (not LS_R11) and KP_R11 and (not X_S6) and (not CAN_S6)  # route S6-UM: proceed wanted
        N_S_R11 = PR_R11  # route S6-UM: proceed
        N_H_R11 = (H_R11 or PR_R11) and KP_R11  # route S6-UM: signal has been open
        N_X_S1 = (X_S1 or CAN_S1) and (A_R1 or A_R2) and (not CD_S1)  # S1: cancelling
        N_X_S1J = (X_S1J or CAN_S1J) and (A_R3 or A_R4) and (not CD_S1J)  # S1J: cancelling
        N_X_S2 = (X_S2 or CAN_S2) and A_R5 and (not CD_S2)  # S2: cancelling
        N_X_S2J = (X_S2J or CAN_S2J) and A_R6 and (not CD_S2J)  # S2J: cancelling
        N_X_S3 = (X_S3 or CAN_S3) and A_R7 and (not CD_S3)  # S3: cancelling
        N_X_S4 = (X_S4 or CAN_S4) and A_R8 and (not CD_S4)  # S4: cancelling
        N_X_S4J = (X_S4J or CAN_S4J) and A_R9 and (not CD_S4J)  # S4J: cancelling
        N_X_S5 = (X_S5 or CAN_S5) and A_R10 and (not CD_S5)  # S5: cancelling
        N_X_S6 = (X_S6 or CAN_S6) and A_R11 and (not CD_S6)  # S6: cancelling
        N_K_AB = K_AB and (not RLS_AB)  # AB: restart lock (R16)
        N_L_AB_2 = (L_AB_2 or GW_AB_2) and (not RLS_AB)  # AB locked from DM to AB|AC@101.toe
        N_F_AB = (F_AB or LK_R1 or LK_R2) and (not RLS_AB)  # AB firmly locked
        N_U_AB = (U_AB or NU_AB_2) and (not RLS_AB)  # AB used by a train (R9)
        N_P_AB = (P_AB or (U_AB and OCC_AB and NU_AC_1)) and (not RLS_AB)  # AB: the train went on (R9)
        N_D_AB = (D_AB or ((not VALID) and L_AB_2)) and (not RLS_AB)  # AB: detection is not relied on, inputs were lost or a train is called on
        N_K_AC = K_AC and (not RLS_AC)  # AC: restart lock (R16)
        N_L_AC_1 = (L_AC_1 or GW_AC_1) and (not RLS_AC)  # AC locked from AB|AC@101.toe to AC|AD@101.normal
        N_L_AC_2 = (L_AC_2 or GW_AC_2) and (not RLS_AC)  # AC locked from AB|AC@101.toe to AC|CD@X1.1b
        N_F_AC = (F_AC or LK_R3 or LK_R4) and (not RLS_AC)  # AC firmly locked
        N_U_AC = (U_AC or NU_AC_1) and (not RLS_AC)  # AC used by a train (R9)
        N_P_AC = (P_AC or (U_AC and OCC_AC and (NU_AD_1 or NU_CD_1))) and (not RLS_AC)  # AC: the train went on (R9)
        N_D_AC = (D_AC or ((not VALID) and (L_AC_1 or L_AC_2))) and (not RLS_AC)  # AC: detection is not relied on, inputs were lost or a train is called on
        N_K_AD = K_AD and (not RLS_AD)  # AD: restart lock (R16)
        N_L_AD_1 = (L_AD_1 or GW_AD_1) and (not RLS_AD)  # AD locked from AC|AD@101.normal to AD|AE@down2.0
        N_F_AD = (F_AD or LK_R3) and (not RLS_AD)  # AD firmly locked
        N_U_AD = (U_AD or NU_AD_1) and (not RLS_AD)  # AD used by a train (R9)
        N_P_AD = (P_AD or (U_AD and OCC_AD and NU_AE_1)) and (not RLS_AD)  # AD: the train went on (R9)
        N_D_AD = (D_AD or ((not VALID) and L_AD_1)) and (not RLS_AD)  # AD: detection is not relied on, inputs were lost or a train is called on
        N_K_AE = K_AE and (not RLS_AE)  # AE: restart lock (R16)
        N_L_AE_1 = (L_AE_1 or GW_AE_1) and (not RLS_AE)  # AE locked from AD|AE@down2.0 to DM2
        N_F_AE = (F_AE or LK_R7) and (not RLS_AE)  # AE firmly locked
        N_U_AE = (U_AE or NU_AE_1) and (not RLS_AE)  # AE used by a train (R9)
        N_P_AE = P_AE and (not RLS_AE)  # AE: the train went on (R9)
        N_D_AE = (D_AE or ((not VALID) and L_AE_1)) and (not RLS_AE)  # AE: detection is not relied on, inputs were lost or a train is called on
        N_K_BB = K_BB and (not RLS_BB)  # BB: restart lock (R16)
        N_L_BB_2 = (L_BB_2 or GW_BB_2) and (not RLS_BB)  # BB locked from UM2 to BB|BC@X1.2a
        N_F_BB = (F_BB or LK_R5) and (not RLS_BB)  # BB firmly locked
        N_U_BB = (U_BB or NU_BB_2) and (not RLS_BB)  # BB used by a train (R9)
        N_P_BB = (P_BB or (U_BB and OCC_BB and NU_BC_1)) and (not RLS_BB)  # BB: the train went on (R9)
        N_D_BB = (D_BB or ((not VALID) and L_BB_2)) and (not RLS_BB)  # BB: detection is not relied on, inputs were lost or a train is called on
        N_K_BC = K_BC and (not RLS_BC)  # BC: restart lock (R16)
        N_L_BC_1 = (L_BC_1 or GW_BC_1) and (not RLS_BC)  # BC locked from BB|BC@X1.2a to BC|BD@102.toe
        N_L_BC_4 = (L_BC_4 or GW_BC_4) and (not RLS_BC)  # BC locked from BC|DB@102.reverse to BC|BD@102.toe
        N_F_BC = (F_BC or LK_R6 or LK_R9) and (not RLS_BC)  # BC firmly locked
        N_U_BC = (U_BC or NU_BC_1 or NU_BC_3) and (not RLS_BC)  # BC used by a train (R9)
        N_P_BC = (P_BC or (U_BC and OCC_BC and NU_BD_1)) and (not RLS_BC)  # BC: the train went on (R9)
        N_D_BC = (D_BC or ((not VALID) and (L_BC_1 or L_BC_4))) and (not RLS_BC)  # BC: detection is not relied on, inputs were lost or a train is called on
        N_K_BD = K_BD and (not RLS_BD)  # BD: restart lock (R16)
        N_L_BD_1 = (L_BD_1 or GW_BD_1) and (not RLS_BD)  # BD locked from BC|BD@102.toe to BD|BE@up2.0
        N_F_BD = (F_BD or LK_R6 or LK_R9) and (not RLS_BD)  # BD firmly locked
        N_U_BD = (U_BD or NU_BD_1) and (not RLS_BD)  # BD used by a train (R9)
        N_P_BD = (P_BD or (U_BD and OCC_BD and NU_BE_1)) and (not RLS_BD)  # BD: the train went on (R9)
        N_D_BD = (D_BD or ((not VALID) and L_BD_1)) and (not RLS_BD)  # BD: detection is not relied on, inputs were lost or a train is called on
        N_K_BE = K_BE and (not RLS_BE)  # BE: restart lock (R16)
        N_L_BE_1 = (L_BE_1 or GW_BE_1) and (not RLS_BE)  # BE locked from BD|BE@up2.0 to UM
        N_F_BE = (F_BE or LK_R11) and (not RLS_BE)  # BE firmly locked
        N_U_BE = (U_BE or NU_BE_1) and (not RLS_BE)  # BE used by a train (R9)
        N_P_BE = P_BE and (not RLS_BE)  # BE: the train went on (R9)
        N_D_BE = (D_BE or ((not VALID) and L_BE_1)) and (not RLS_BE)  # BE: detection is not relied on, inputs were lost or a train is called on
        N_K_CD = K_CD and (not RLS_CD)  # CD: restart lock (R16)
        N_L_CD_1 = (L_CD_1 or GW_CD_1) and (not RLS_CD)  # CD locked from AC|CD@X1.1b to CD|CE@branch.0
        N_F_CD = (F_CD or LK_R4) and (not RLS_CD)  # CD firmly locked
        N_U_CD = (U_CD or NU_CD_1) and (not RLS_CD)  # CD used by a train (R9)
        N_P_CD = (P_CD or (U_CD and OCC_CD and NU_CE_1)) and (not RLS_CD)  # CD: the train went on (R9)
        N_D_CD = (D_CD or ((not VALID) and L_CD_1)) and (not RLS_CD)  # CD: detection is not relied on, inputs were lost or a train is called on
        N_K_CE = K_CE and (not RLS_CE)  # CE: restart lock (R16)
        N_L_CE_1 = (L_CE_1 or GW_CE_1) and (not RLS_CE)  # CE locked from CD|CE@branch.0 to DBO
        N_F_CE = (F_CE or LK_R10) and (not RLS_CE)  # CE firmly locked
        N_U_CE = (U_CE or NU_CE_1) and (not RLS_CE)  # CE used by a train (R9)
        N_P_CE = P_CE and (not RLS_CE)  # CE: the train went on (R9)
        N_D_CE = (D_CE or ((not VALID) and L_CE_1)) and (not RLS_CE)  # CE: detection is not relied on, inputs were lost or a train is called on
        N_K_DB = K_DB and (not RLS_DB)  # DB: restart lock (R16)
        N_L_DB_2 = (L_DB_2 or GW_DB_2) and (not RLS_DB)  # DB locked from UB to BC|DB@102.reverse
        N_F_DB = (F_DB or LK_R8) and (not RLS_DB)  # DB firmly locked
        N_U_DB = (U_DB or NU_DB_2) and (not RLS_DB)  # DB used by a train (R9)
        N_P_DB = (P_DB or (U_DB and OCC_DB and NU_BC_3)) and (not RLS_DB)  # DB: the train went on (R9)
        N_D_DB = (D_DB or ((not VALID) and L_DB_2)) and (not RLS_DB)  # DB: detection is not relied on, inputs were lost or a train is called on
        N_V_S1J_1 = GO_S1J_1 or (V_S1J_1 and (not (OR_S1J and (not OCC_AC) and (not OCC_AD))))  # overlap 1 of S1J held
        N_V_S1J_2 = GO_S1J_2 or (V_S1J_2 and (not (OR_S1J and (not OCC_AC) and (not OCC_CD))))  # overlap 2 of S1J held
        N_V_S2J_1 = GO_S2J_1 or (V_S2J_1 and (not (OR_S2J and (not OCC_BC) and (not OCC_BD))))  # overlap 1 of S2J held
        N_V_S3_1 = GO_S3_1 or (V_S3_1 and (not (OR_S3 and (not OCC_AE))))  # overlap 1 of S3 held
        N_V_S4J_1 = GO_S4J_1 or (V_S4J_1 and (not (OR_S4J and (not OCC_BC) and (not OCC_BD))))  # overlap 1 of S4J held
        N_V_S5_1 = GO_S5_1 or (V_S5_1 and (not (OR_S5 and (not OCC_CE))))  # overlap 1 of S5 held
        N_V_S6_1 = GO_S6_1 or (V_S6_1 and (not (OR_S6 and (not OCC_BE))))  # overlap 1 of S6 held
        N_VF_S1J = (VF_S1J or LK_R1 or LK_R2) and (V_S1J_1 or V_S1J_2)  # overlap of S1J firmly held
        N_VF_S2J = (VF_S2J or LK_R5) and V_S2J_1  # overlap of S2J firmly held
        N_VF_S3 = (VF_S3 or LK_R3) and V_S3_1  # overlap of S3 firmly held
        N_VF_S4J = (VF_S4J or LK_R8) and V_S4J_1  # overlap of S4J firmly held
        N_VF_S5 = (VF_S5 or LK_R4) and V_S5_1  # overlap of S5 firmly held
        N_VF_S6 = (VF_S6 or LK_R6 or LK_R9) and V_S6_1  # overlap of S6 firmly held
        N_C_S1 = (PR_R1 or PR_R2) and ((PR_R1 and (PR_R3 or PR_R4)) or (PR_R2 and (PR_R3 or PR_R4)))  # S1 shows clear
        N_C_S1J = (PR_R3 or PR_R4) and ((PR_R3 and PR_R7) or (PR_R4 and PR_R10))  # S1J shows clear
        N_C_S2 = PR_R5 and (PR_R5 and PR_R6)  # S2 shows clear
        N_C_S2J = PR_R6 and (PR_R6 and PR_R11)  # S2J shows clear
        N_C_S3 = PR_R7 and False  # S3 shows clear
        N_C_S4 = PR_R8 and (PR_R8 and PR_R9)  # S4 shows clear
        N_C_S4J = PR_R9 and (PR_R9 and PR_R11)  # S4J shows clear
        N_C_S5 = PR_R10 and False  # S5 shows clear
        N_C_S6 = PR_R11 and False  # S6 shows clear
        self.state = {
            'CN_101': bool(N_CN_101),
            'CR_101': bool(N_CR_101),
            'CN_102': bool(N_CN_102),
            'CR_102': bool(N_CR_102),
            'AL_101': bool(N_AL_101),
            'AL_102': bool(N_AL_102),
            'TH_101': bool(N_TH_101),
            'TR_101': bool(N_TR_101),
            'TH_102': bool(N_TH_102),
            'TR_102': bool(N_TR_102),
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
            'X_S1': bool(N_X_S1),
            'X_S1J': bool(N_X_S1J),
            'X_S2': bool(N_X_S2),
            'X_S2J': bool(N_X_S2J),
            'X_S3': bool(N_X_S3),
            'X_S4': bool(N_X_S4),
            'X_S4J': bool(N_X_S4J),
            'X_S5': bool(N_X_S5),
            'X_S6': bool(N_X_S6),
            'K_AB': bool(N_K_AB),
            'L_AB_2': bool(N_L_AB_2),
            'F_AB': bool(N_F_AB),
            'U_AB': bool(N_U_AB),
            'P_AB': bool(N_P_AB),
            'D_AB': bool(N_D_AB),
            'K_AC': bool(N_K_AC),
            'L_AC_1': bool(N_L_AC_1),
            'L_AC_2': bool(N_L_AC_2),
            'F_AC': bool(N_F_AC),
            'U_AC': bool(N_U_AC),
            'P_AC': bool(N_P_AC),
            'D_AC': bool(N_D_AC),
            'K_AD': bool(N_K_AD),
            'L_AD_1': bool(N_L_AD_1),
            'F_AD': bool(N_F_AD),
            'U_AD': bool(N_U_AD),
            'P_AD': bool(N_P_AD),
            'D_AD': bool(N_D_AD),
            'K_AE': bool(N_K_AE),
            'L_AE_1': bool(N_L_AE_1),
            'F_AE': bool(N_F_AE),
            'U_AE': bool(N_U_AE),
            'P_AE': bool(N_P_AE),
            'D_AE': bool(N_D_AE),
            'K_BB': bool(N_K_BB),
            'L_BB_2': bool(N_L_BB_2),
            'F_BB': bool(N_F_BB),
            'U_BB': bool(N_U_BB),
            'P_BB': bool(N_P_BB),
            'D_BB': bool(N_D_BB),
            'K_BC': bool(N_K_BC),
            'L_BC_1': bool(N_L_BC_1),
            'L_BC_4': bool(N_L_BC_4),
            'F_BC': bool(N_F_BC),
            'U_BC': bool(N_U_BC),
            'P_BC': bool(N_P_BC),
            'D_BC': bool(N_D_BC),
            'K_BD': bool(N_K_BD),
            'L_BD_1': bool(N_L_BD_1),
            'F_BD': bool(N_F_BD),
            'U_BD': bool(N_U_BD),
            'P_BD': bool(N_P_BD),
            'D_BD': bool(N_D_BD),
            'K_BE': bool(N_K_BE),
            'L_BE_1': bool(N_L_BE_1),
            'F_BE': bool(N_F_BE),
            'U_BE': bool(N_U_BE),
            'P_BE': bool(N_P_BE),
            'D_BE': bool(N_D_BE),
            'K_CD': bool(N_K_CD),
            'L_CD_1': bool(N_L_CD_1),
            'F_CD': bool(N_F_CD),
            'U_CD': bool(N_U_CD),
            'P_CD': bool(N_P_CD),
            'D_CD': bool(N_D_CD),
            'K_CE': bool(N_K_CE),
            'L_CE_1': bool(N_L_CE_1),
            'F_CE': bool(N_F_CE),
            'U_CE': bool(N_U_CE),
            'P_CE': bool(N_P_CE),
            'D_CE': bool(N_D_CE),
            'K_DB': bool(N_K_DB),
            'L_DB_2': bool(N_L_DB_2),
            'F_DB': bool(N_F_DB),
            'U_DB': bool(N_U_DB),
            'P_DB': bool(N_P_DB),
            'D_DB': bool(N_D_DB),
            'V_S1J_1': bool(N_V_S1J_1),
            'V_S1J_2': bool(N_V_S1J_2),
            'V_S2J_1': bool(N_V_S2J_1),
            'V_S3_1': bool(N_V_S3_1),
            'V_S4J_1': bool(N_V_S4J_1),
            'V_S5_1': bool(N_V_S5_1),
            'V_S6_1': bool(N_V_S6_1),
            'VF_S1J': bool(N_VF_S1J),
            'VF_S2J': bool(N_VF_S2J),
            'VF_S3': bool(N_VF_S3),
            'VF_S4J': bool(N_VF_S4J),
            'VF_S5': bool(N_VF_S5),
            'VF_S6': bool(N_VF_S6),
            'C_S1': bool(N_C_S1),
            'C_S1J': bool(N_C_S1J),
            'C_S2': bool(N_C_S2),
            'C_S2J': bool(N_C_S2J),
            'C_S3': bool(N_C_S3),
            'C_S4': bool(N_C_S4),
            'C_S4J': bool(N_C_S4J),
            'C_S5': bool(N_C_S5),
            'C_S6': bool(N_C_S6),
        }
        CN_101 = self.state['CN_101']
        CR_101 = self.state['CR_101']
        CN_102 = self.state['CN_102']
        CR_102 = self.state['CR_102']
        AL_101 = self.state['AL_101']
        AL_102 = self.state['AL_102']
        TH_101 = self.state['TH_101']
        TR_101 = self.state['TR_101']
        TH_102 = self.state['TH_102']
        TR_102 = self.state['TR_102']
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
        X_S1 = self.state['X_S1']
        X_S1J = self.state['X_S1J']
        X_S2 = self.state['X_S2']
        X_S2J = self.state['X_S2J']
        X_S3 = self.state['X_S3']
        X_S4 = self.state['X_S4']
        X_S4J = self.state['X_S4J']
        X_S5 = self.state['X_S5']
        X_S6 = self.state['X_S6']
        K_AB = self.state['K_AB']
        L_AB_2 = self.state['L_AB_2']
        F_AB = self.state['F_AB']
        U_AB = self.state['U_AB']
        P_AB = self.state['P_AB']
        D_AB = self.state['D_AB']
        K_AC = self.state['K_AC']
        L_AC_1 = self.state['L_AC_1']
        L_AC_2 = self.state['L_AC_2']
        F_AC = self.state['F_AC']
        U_AC = self.state['U_AC']
        P_AC = self.state['P_AC']
        D_AC = self.state['D_AC']
        K_AD = self.state['K_AD']
        L_AD_1 = self.state['L_AD_1']
        F_AD = self.state['F_AD']
        U_AD = self.state['U_AD']
        P_AD = self.state['P_AD']
        D_AD = self.state['D_AD']
        K_AE = self.state['K_AE']
        L_AE_1 = self.state['L_AE_1']
        F_AE = self.state['F_AE']
        U_AE = self.state['U_AE']
        P_AE = self.state['P_AE']
        D_AE = self.state['D_AE']
        K_BB = self.state['K_BB']
        L_BB_2 = self.state['L_BB_2']
        F_BB = self.state['F_BB']
        U_BB = self.state['U_BB']
        P_BB = self.state['P_BB']
        D_BB = self.state['D_BB']
        K_BC = self.state['K_BC']
        L_BC_1 = self.state['L_BC_1']
        L_BC_4 = self.state['L_BC_4']
        F_BC = self.state['F_BC']
        U_BC = self.state['U_BC']
        P_BC = self.state['P_BC']
        D_BC = self.state['D_BC']
        K_BD = self.state['K_BD']
        L_BD_1 = self.state['L_BD_1']
        F_BD = self.state['F_BD']
        U_BD = self.state['U_BD']
        P_BD = self.state['P_BD']
        D_BD = self.state['D_BD']
        K_BE = self.state['K_BE']
        L_BE_1 = self.state['L_BE_1']
        F_BE = self.state['F_BE']
        U_BE = self.state['U_BE']
        P_BE = self.state['P_BE']
        D_BE = self.state['D_BE']
        K_CD = self.state['K_CD']
        L_CD_1 = self.state['L_CD_1']
        F_CD = self.state['F_CD']
        U_CD = self.state['U_CD']
        P_CD = self.state['P_CD']
        D_CD = self.state['D_CD']
        K_CE = self.state['K_CE']
        L_CE_1 = self.state['L_CE_1']
        F_CE = self.state['F_CE']
        U_CE = self.state['U_CE']
        P_CE = self.state['P_CE']
        D_CE = self.state['D_CE']
        K_DB = self.state['K_DB']
        L_DB_2 = self.state['L_DB_2']
        F_DB = self.state['F_DB']
        U_DB = self.state['U_DB']
        P_DB = self.state['P_DB']
        D_DB = self.state['D_DB']
        V_S1J_1 = self.state['V_S1J_1']
        V_S1J_2 = self.state['V_S1J_2']
        V_S2J_1 = self.state['V_S2J_1']
        V_S3_1 = self.state['V_S3_1']
        V_S4J_1 = self.state['V_S4J_1']
        V_S5_1 = self.state['V_S5_1']
        V_S6_1 = self.state['V_S6_1']
        VF_S1J = self.state['VF_S1J']
        VF_S2J = self.state['VF_S2J']
        VF_S3 = self.state['VF_S3']
        VF_S4J = self.state['VF_S4J']
        VF_S5 = self.state['VF_S5']
        VF_S6 = self.state['VF_S6']
        C_S1 = self.state['C_S1']
        C_S1J = self.state['C_S1J']
        C_S2 = self.state['C_S2']
        C_S2J = self.state['C_S2J']
        C_S3 = self.state['C_S3']
        C_S4 = self.state['C_S4']
        C_S4J = self.state['C_S4J']
        C_S5 = self.state['C_S5']
        C_S6 = self.state['C_S6']
        return {
            'YN_101': bool(CN_101),
            'YR_101': bool(CR_101),
            'YN_102': bool(CN_102),
            'YR_102': bool(CR_102),
            'YA_101': bool(AL_101),
            'YA_102': bool(AL_102),
            'YT_101': bool(TR_101),
            'YT_102': bool(TR_102),
            'YL_AB': bool(K_AB or L_AB_2),
            'YL_AC': bool(K_AC or L_AC_1 or L_AC_2 or V_S1J_1 or V_S1J_2),
            'YL_AD': bool(K_AD or L_AD_1 or V_S1J_1),
            'YL_AE': bool(K_AE or L_AE_1 or V_S3_1),
            'YL_BB': bool(K_BB or L_BB_2),
            'YL_BC': bool(K_BC or L_BC_1 or L_BC_4 or V_S2J_1 or V_S4J_1),
            'YL_BD': bool(K_BD or L_BD_1 or V_S2J_1 or V_S4J_1),
            'YL_BE': bool(K_BE or L_BE_1 or V_S6_1),
            'YL_CD': bool(K_CD or L_CD_1 or V_S1J_2),
            'YL_CE': bool(K_CE or L_CE_1 or V_S5_1),
            'YL_DB': bool(K_DB or L_DB_2),
            'YP_S1': bool(C_S1),
            'YY_S1': bool((S_R1 or S_R2) and (not C_S1)),
            'YS_S1': bool((not (S_R1 or S_R2))),
            'YP_S1J': bool(C_S1J),
            'YY_S1J': bool((S_R3 or S_R4) and (not C_S1J)),
            'YS_S1J': bool((not (S_R3 or S_R4))),
            'YP_S2': bool(C_S2),
            'YY_S2': bool(S_R5 and (not C_S2)),
            'YS_S2': bool((not S_R5)),
            'YP_S2J': bool(C_S2J),
            'YY_S2J': bool(S_R6 and (not C_S2J)),
            'YS_S2J': bool((not S_R6)),
            'YP_S3': bool(C_S3),
            'YY_S3': bool(S_R7 and (not C_S3)),
            'YS_S3': bool((not S_R7)),
            'YP_S4': bool(C_S4),
            'YY_S4': bool(S_R8 and (not C_S4)),
            'YS_S4': bool((not S_R8)),
            'YP_S4J': bool(C_S4J),
            'YY_S4J': bool(S_R9 and (not C_S4J)),
            'YS_S4J': bool((not S_R9)),
            'YP_S5': bool(C_S5),
            'YY_S5': bool(S_R10 and (not C_S5)),
            'YS_S5': bool((not S_R10)),
            'YP_S6': bool(C_S6),
            'YY_S6': bool(S_R11 and (not C_S6)),
            'YS_S6': bool((not S_R11)),
        }
