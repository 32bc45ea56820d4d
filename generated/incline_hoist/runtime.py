# Interlocking incline_hoist, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout 4332c5c9def9ae1b212caddcdb52d4cc461b5ae15ef1d81345a44f7c49380dd5
# claims 5f9bcd711d29d7b22ca3d29ec19dce5eb89d48110150bf27a0c25809dc0dc0f2
"""Interlocking incline_hoist: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_XD2': (0, 2),  # operator: cancel the route from XD2
    'CAN_XD3': (0, 2),  # operator: cancel the route from XD3
    'CAN_XL': (0, 2),  # operator: cancel the route from XL
    'CAN_XM': (0, 2),  # operator: cancel the route from XM
    'CAN_XN1': (0, 2),  # operator: cancel the route from XN1
    'CAN_XU': (0, 2),  # operator: cancel the route from XU
    'CAN_XU3': (0, 2),  # operator: cancel the route from XU3
    'E_B1_OPEN': (0, 2),  # external condition B1_OPEN: upper barrier open
    'E_B2_OPEN': (0, 2),  # external condition B2_OPEN: lower barrier open
    'E_HOIST_STOPPED': (0, 2),  # external condition HOIST_STOPPED: hoist stopped
    'E_NO_PERSON': (0, 2),  # external condition NO_PERSON: nobody on the incline
    'E_ROPE_ATTACHED': (0, 2),  # external condition ROPE_ATTACHED: rope attached
    'REQ': (0, 10),  # operator: set route number, 0 = none
    'LREQ': (0, 10),  # operator on the spot: set route number, 0 = none
    'CLR_d1': (0, 2),  # section d1 reported clear
    'CLR_d2': (0, 2),  # section d2 reported clear
    'CLR_d3': (0, 2),  # section d3 reported clear
    'CLR_i1': (0, 2),  # section i1 reported clear
    'CLR_i2': (0, 2),  # section i2 reported clear
    'CLR_lane': (0, 2),  # section lane reported clear
    'CLR_u1': (0, 2),  # section u1 reported clear
    'CLR_u2': (0, 2),  # section u2 reported clear
    'CLR_u3_stub': (0, 2),  # section u3_stub reported clear
    'REL_d1': (0, 2),  # operator: release section d1 (hold until released)
    'REL_d2': (0, 2),  # operator: release section d2 (hold until released)
    'REL_d3': (0, 2),  # operator: release section d3 (hold until released)
    'REL_i1': (0, 2),  # operator: release section i1 (hold until released)
    'REL_i2': (0, 2),  # operator: release section i2 (hold until released)
    'REL_u2': (0, 2),  # operator: release section u2 (hold until released)
    'REL_u3_stub': (0, 2),  # operator: release section u3_stub (hold until released)
    'BLK_d1': (1, 2),  # operator: section d1 is blocked
    'BLK_d2': (1, 2),  # operator: section d2 is blocked
    'BLK_d3': (1, 2),  # operator: section d3 is blocked
    'BLK_i1': (1, 2),  # operator: section i1 is blocked
    'BLK_i2': (1, 2),  # operator: section i2 is blocked
    'BLK_u2': (1, 2),  # operator: section u2 is blocked
    'BLK_u3_stub': (1, 2),  # operator: section u3_stub is blocked
    'RELALL': (0, 2),  # operator: release all clear sections after a restart
    'DN_PD': (0, 2),  # machine PD detected normal
    'DR_PD': (0, 2),  # machine PD detected reverse
    'MN_PD': (0, 2),  # operator: move machine PD normal
    'MR_PD': (0, 2),  # operator: move machine PD reverse
    'TC_PD': (0, 2),  # operator: machine PD has been looked at after it was trailed
    'DN_PU': (0, 2),  # machine PU detected normal
    'DR_PU': (0, 2),  # machine PU detected reverse
    'MN_PU': (0, 2),  # operator: move machine PU normal
    'MR_PU': (0, 2),  # operator: move machine PU reverse
    'TC_PU': (0, 2),  # operator: machine PU has been looked at after it was trailed
}
# name: value at a restart, meaning
STATE = {
    'CN_PD': False,  # machine PD commanded N
    'CR_PD': False,  # machine PD commanded R
    'CN_PU': False,  # machine PU commanded N
    'CR_PU': False,  # machine PU commanded R
    'AL_PD': False,  # alarm: machine PD not detected
    'AL_PU': False,  # alarm: machine PU not detected
    'TH_PD': False,  # machine PD was detected where it is commanded
    'TR_PD': False,  # machine PD was trailed
    'TH_PU': False,  # machine PU was detected where it is commanded
    'TR_PU': False,  # machine PU was trailed
    'A_R1': False,  # route XD2-XN1 active
    'B_R1': False,  # route XD2-XN1 locked
    'W_R1': False,  # route XD2-XN1: proceed wanted
    'S_R1': False,  # route XD2-XN1: proceed
    'H_R1': False,  # route XD2-XN1: signal has been open
    'A_R2': False,  # route XD3-XN1 active
    'B_R2': False,  # route XD3-XN1 locked
    'W_R2': False,  # route XD3-XN1: proceed wanted
    'S_R2': False,  # route XD3-XN1: proceed
    'H_R2': False,  # route XD3-XN1: signal has been open
    'A_R3': False,  # route XL-XD3 active
    'B_R3': False,  # route XL-XD3 locked
    'W_R3': False,  # route XL-XD3: proceed wanted
    'S_R3': False,  # route XL-XD3: proceed
    'H_R3': False,  # route XL-XD3: signal has been open
    'A_R4': False,  # route XM-L active
    'B_R4': False,  # route XM-L locked
    'W_R4': False,  # route XM-L: proceed wanted
    'S_R4': False,  # route XM-L: proceed
    'H_R4': False,  # route XM-L: signal has been open
    'A_R5': False,  # route XM-LB active
    'B_R5': False,  # route XM-LB locked
    'W_R5': False,  # route XM-LB: proceed wanted
    'S_R5': False,  # route XM-LB: proceed
    'H_R5': False,  # route XM-LB: signal has been open
    'A_R6': False,  # route XN1-U active
    'B_R6': False,  # route XN1-U locked
    'W_R6': False,  # route XN1-U: proceed wanted
    'S_R6': False,  # route XN1-U: proceed
    'H_R6': False,  # route XN1-U: signal has been open
    'A_R7': False,  # route XU-UB active
    'B_R7': False,  # route XU-UB locked
    'W_R7': False,  # route XU-UB: proceed wanted
    'S_R7': False,  # route XU-UB: proceed
    'H_R7': False,  # route XU-UB: signal has been open
    'A_R8': False,  # route XU-XM active
    'B_R8': False,  # route XU-XM locked
    'W_R8': False,  # route XU-XM: proceed wanted
    'S_R8': False,  # route XU-XM: proceed
    'H_R8': False,  # route XU-XM: signal has been open
    'A_R9': False,  # route XU3-U active
    'B_R9': False,  # route XU3-U locked
    'W_R9': False,  # route XU3-U: proceed wanted
    'S_R9': False,  # route XU3-U: proceed
    'H_R9': False,  # route XU3-U: signal has been open
    'X_XD2': False,  # XD2: cancelling
    'X_XD3': False,  # XD3: cancelling
    'X_XL': False,  # XL: cancelling
    'X_XM': False,  # XM: cancelling
    'X_XN1': False,  # XN1: cancelling
    'X_XU': False,  # XU: cancelling
    'X_XU3': False,  # XU3: cancelling
    'K_d1': True,  # d1: restart lock (R16)
    'L_d1_1': False,  # d1 locked from d1|d2@PD.normal to d1|i2@PD.toe
    'L_d1_2': False,  # d1 locked from d1|d3@PD.reverse to d1|i2@PD.toe
    'L_d1_3': False,  # d1 locked from d1|i2@PD.toe to d1|d2@PD.normal
    'L_d1_4': False,  # d1 locked from d1|i2@PD.toe to d1|d3@PD.reverse
    'F_d1': False,  # d1 firmly locked
    'U_d1': True,  # d1 used by a train (R9)
    'P_d1': False,  # d1: the train went on (R9)
    'D_d1': False,  # d1: detection is not relied on, inputs were lost or a train is called on
    'K_d2': True,  # d2: restart lock (R16)
    'L_d2_2': False,  # d2 locked from d1|d2@PD.normal to LB
    'F_d2': False,  # d2 firmly locked
    'U_d2': True,  # d2 used by a train (R9)
    'P_d2': False,  # d2: the train went on (R9)
    'D_d2': False,  # d2: detection is not relied on, inputs were lost or a train is called on
    'K_d3': True,  # d3: restart lock (R16)
    'L_d3_1': False,  # d3 locked from L to d1|d3@PD.reverse
    'L_d3_2': False,  # d3 locked from d1|d3@PD.reverse to L
    'F_d3': False,  # d3 firmly locked
    'U_d3': True,  # d3 used by a train (R9)
    'P_d3': False,  # d3: the train went on (R9)
    'D_d3': False,  # d3: detection is not relied on, inputs were lost or a train is called on
    'K_i1': True,  # i1: restart lock (R16)
    'L_i1_1': False,  # i1 locked from i1|i2@slope.0 to i1|u2@PU.normal
    'L_i1_2': False,  # i1 locked from i1|u2@PU.normal to i1|i2@slope.0
    'F_i1': False,  # i1 firmly locked
    'U_i1': True,  # i1 used by a train (R9)
    'P_i1': False,  # i1: the train went on (R9)
    'D_i1': False,  # i1: detection is not relied on, inputs were lost or a train is called on
    'K_i2': True,  # i2: restart lock (R16)
    'L_i2_1': False,  # i2 locked from d1|i2@PD.toe to i1|i2@slope.0
    'L_i2_2': False,  # i2 locked from i1|i2@slope.0 to d1|i2@PD.toe
    'F_i2': False,  # i2 firmly locked
    'U_i2': True,  # i2 used by a train (R9)
    'P_i2': False,  # i2: the train went on (R9)
    'D_i2': False,  # i2: detection is not relied on, inputs were lost or a train is called on
    'K_u2': True,  # u2: restart lock (R16)
    'L_u2_1': False,  # u2 locked from U to i1|u2@PU.normal
    'L_u2_2': False,  # u2 locked from U to u2|u3_stub@PU.reverse
    'L_u2_3': False,  # u2 locked from i1|u2@PU.normal to U
    'L_u2_4': False,  # u2 locked from u2|u3_stub@PU.reverse to U
    'F_u2': False,  # u2 firmly locked
    'U_u2': True,  # u2 used by a train (R9)
    'P_u2': False,  # u2: the train went on (R9)
    'D_u2': False,  # u2: detection is not relied on, inputs were lost or a train is called on
    'K_u3_stub': True,  # u3_stub: restart lock (R16)
    'L_u3_stub_2': False,  # u3_stub locked from u2|u3_stub@PU.reverse to UB
    'F_u3_stub': False,  # u3_stub firmly locked
    'U_u3_stub': True,  # u3_stub used by a train (R9)
    'P_u3_stub': False,  # u3_stub: the train went on (R9)
    'D_u3_stub': False,  # u3_stub: detection is not relied on, inputs were lost or a train is called on
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_XD2': 60000,  # XD2: approach locking delay (R8)
    'AT_XD3': 60000,  # XD3: approach locking delay (R8)
    'AT_XL': 60000,  # XL: approach locking delay (R8)
    'AT_XM': 60000,  # XM: approach locking delay (R8)
    'AT_XN1': 60000,  # XN1: approach locking delay (R8)
    'AT_XU': 60000,  # XU: approach locking delay (R8)
    'AT_XU3': 60000,  # XU3: approach locking delay (R8)
    'RT_d1': 3000,  # d1: release delay (R9)
    'RT_d2': 3000,  # d2: release delay (R9)
    'RT_d3': 3000,  # d3: release delay (R9)
    'RT_i1': 3000,  # i1: release delay (R9)
    'RT_i2': 3000,  # i2: release delay (R9)
    'RT_u2': 3000,  # u2: release delay (R9)
    'RT_u3_stub': 3000,  # u3_stub: release delay (R9)
    'ST_PD': 13000,  # machine PD: time-out
    'ST_PU': 13000,  # machine PU: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_PD': False,  # machine PD: normal
    'YR_PD': False,  # machine PD: reverse
    'YN_PU': False,  # machine PU: normal
    'YR_PU': False,  # machine PU: reverse
    'YA_PD': False,  # alarm: machine PD not detected in time
    'YA_PU': False,  # alarm: machine PU not detected in time
    'YT_PD': False,  # alarm: machine PD was trailed
    'YT_PU': False,  # alarm: machine PU was trailed
    'YL_d1': True,  # indication: d1 is locked
    'YL_d2': True,  # indication: d2 is locked
    'YL_d3': True,  # indication: d3 is locked
    'YL_i1': True,  # indication: i1 is locked
    'YL_i2': True,  # indication: i2 is locked
    'YL_u2': True,  # indication: u2 is locked
    'YL_u3_stub': True,  # indication: u3_stub is locked
    'YP_XD2': False,  # signal XD2: clear (green)
    'YS_XD2': True,  # signal XD2: stop
    'YP_XD3': False,  # signal XD3: clear (green)
    'YS_XD3': True,  # signal XD3: stop
    'YP_XL': False,  # signal XL: clear (green)
    'YS_XL': True,  # signal XL: stop
    'YP_XM': False,  # signal XM: clear (green)
    'YS_XM': True,  # signal XM: stop
    'YP_XN1': False,  # signal XN1: clear (green)
    'YS_XN1': True,  # signal XN1: stop
    'YP_XU': False,  # signal XU: clear (green)
    'YS_XU': True,  # signal XU: stop
    'YP_XU3': False,  # signal XU3: clear (green)
    'YS_XU3': True,  # signal XU3: stop
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
        CAN_XD2 = read['CAN_XD2']
        CAN_XD3 = read['CAN_XD3']
        CAN_XL = read['CAN_XL']
        CAN_XM = read['CAN_XM']
        CAN_XN1 = read['CAN_XN1']
        CAN_XU = read['CAN_XU']
        CAN_XU3 = read['CAN_XU3']
        E_B1_OPEN = read['E_B1_OPEN']
        E_B2_OPEN = read['E_B2_OPEN']
        E_HOIST_STOPPED = read['E_HOIST_STOPPED']
        E_NO_PERSON = read['E_NO_PERSON']
        E_ROPE_ATTACHED = read['E_ROPE_ATTACHED']
        REQ = read['REQ']
        LREQ = read['LREQ']
        CLR_d1 = read['CLR_d1']
        CLR_d2 = read['CLR_d2']
        CLR_d3 = read['CLR_d3']
        CLR_i1 = read['CLR_i1']
        CLR_i2 = read['CLR_i2']
        CLR_lane = read['CLR_lane']
        CLR_u1 = read['CLR_u1']
        CLR_u2 = read['CLR_u2']
        CLR_u3_stub = read['CLR_u3_stub']
        REL_d1 = read['REL_d1']
        REL_d2 = read['REL_d2']
        REL_d3 = read['REL_d3']
        REL_i1 = read['REL_i1']
        REL_i2 = read['REL_i2']
        REL_u2 = read['REL_u2']
        REL_u3_stub = read['REL_u3_stub']
        BLK_d1 = read['BLK_d1']
        BLK_d2 = read['BLK_d2']
        BLK_d3 = read['BLK_d3']
        BLK_i1 = read['BLK_i1']
        BLK_i2 = read['BLK_i2']
        BLK_u2 = read['BLK_u2']
        BLK_u3_stub = read['BLK_u3_stub']
        RELALL = read['RELALL']
        DN_PD = read['DN_PD']
        DR_PD = read['DR_PD']
        MN_PD = read['MN_PD']
        MR_PD = read['MR_PD']
        TC_PD = read['TC_PD']
        DN_PU = read['DN_PU']
        DR_PU = read['DR_PU']
        MN_PU = read['MN_PU']
        MR_PU = read['MR_PU']
        TC_PU = read['TC_PU']
        CN_PD = old['CN_PD']
        CR_PD = old['CR_PD']
        CN_PU = old['CN_PU']
        CR_PU = old['CR_PU']
        AL_PD = old['AL_PD']
        AL_PU = old['AL_PU']
        TH_PD = old['TH_PD']
        TR_PD = old['TR_PD']
        TH_PU = old['TH_PU']
        TR_PU = old['TR_PU']
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
        X_XD2 = old['X_XD2']
        X_XD3 = old['X_XD3']
        X_XL = old['X_XL']
        X_XM = old['X_XM']
        X_XN1 = old['X_XN1']
        X_XU = old['X_XU']
        X_XU3 = old['X_XU3']
        K_d1 = old['K_d1']
        L_d1_1 = old['L_d1_1']
        L_d1_2 = old['L_d1_2']
        L_d1_3 = old['L_d1_3']
        L_d1_4 = old['L_d1_4']
        F_d1 = old['F_d1']
        U_d1 = old['U_d1']
        P_d1 = old['P_d1']
        D_d1 = old['D_d1']
        K_d2 = old['K_d2']
        L_d2_2 = old['L_d2_2']
        F_d2 = old['F_d2']
        U_d2 = old['U_d2']
        P_d2 = old['P_d2']
        D_d2 = old['D_d2']
        K_d3 = old['K_d3']
        L_d3_1 = old['L_d3_1']
        L_d3_2 = old['L_d3_2']
        F_d3 = old['F_d3']
        U_d3 = old['U_d3']
        P_d3 = old['P_d3']
        D_d3 = old['D_d3']
        K_i1 = old['K_i1']
        L_i1_1 = old['L_i1_1']
        L_i1_2 = old['L_i1_2']
        F_i1 = old['F_i1']
        U_i1 = old['U_i1']
        P_i1 = old['P_i1']
        D_i1 = old['D_i1']
        K_i2 = old['K_i2']
        L_i2_1 = old['L_i2_1']
        L_i2_2 = old['L_i2_2']
        F_i2 = old['F_i2']
        U_i2 = old['U_i2']
        P_i2 = old['P_i2']
        D_i2 = old['D_i2']
        K_u2 = old['K_u2']
        L_u2_1 = old['L_u2_1']
        L_u2_2 = old['L_u2_2']
        L_u2_3 = old['L_u2_3']
        L_u2_4 = old['L_u2_4']
        F_u2 = old['F_u2']
        U_u2 = old['U_u2']
        P_u2 = old['P_u2']
        D_u2 = old['D_u2']
        K_u3_stub = old['K_u3_stub']
        L_u3_stub_2 = old['L_u3_stub_2']
        F_u3_stub = old['F_u3_stub']
        U_u3_stub = old['U_u3_stub']
        P_u3_stub = old['P_u3_stub']
        D_u3_stub = old['D_u3_stub']
        OCC_d1 = (not CLR_d1) or (not VALID)  # d1 counts as occupied
        OCC_d2 = (not CLR_d2) or (not VALID)  # d2 counts as occupied
        OCC_d3 = (not CLR_d3) or (not VALID)  # d3 counts as occupied
        OCC_i1 = (not CLR_i1) or (not VALID)  # i1 counts as occupied
        OCC_i2 = (not CLR_i2) or (not VALID)  # i2 counts as occupied
        OCC_lane = (not CLR_lane) or (not VALID)  # lane counts as occupied
        OCC_u1 = (not CLR_u1) or (not VALID)  # u1 counts as occupied
        OCC_u2 = (not CLR_u2) or (not VALID)  # u2 counts as occupied
        OCC_u3_stub = (not CLR_u3_stub) or (not VALID)  # u3_stub counts as occupied
        FREE_d1 = (not K_d1) and (not L_d1_1) and (not L_d1_2) and (not L_d1_3) and (not L_d1_4)  # d1 is not locked by anybody
        FREE_d2 = (not K_d2) and (not L_d2_2)  # d2 is not locked by anybody
        FREE_d3 = (not K_d3) and (not L_d3_1) and (not L_d3_2)  # d3 is not locked by anybody
        FREE_i1 = (not K_i1) and (not L_i1_1) and (not L_i1_2)  # i1 is not locked by anybody
        FREE_i2 = (not K_i2) and (not L_i2_1) and (not L_i2_2)  # i2 is not locked by anybody
        FREE_u2 = (not K_u2) and (not L_u2_1) and (not L_u2_2) and (not L_u2_3) and (not L_u2_4)  # u2 is not locked by anybody
        FREE_u3_stub = (not K_u3_stub) and (not L_u3_stub_2)  # u3_stub is not locked by anybody
        QN_PD = VALID and DN_PD and (not DR_PD)  # machine PD lies N (R10)
        QR_PD = VALID and DR_PD and (not DN_PD)  # machine PD lies R (R10)
        QN_PU = VALID and DN_PU and (not DR_PU)  # machine PU lies N (R10)
        QR_PU = VALID and DR_PU and (not DN_PU)  # machine PU lies R (R10)
        MOV_PD = VALID and FREE_d1 and (not OCC_d1) and True and True  # machine PD is free to move (R10)
        AVN_PD = CN_PD or MOV_PD or (QN_PD and (not CN_PD) and (not CR_PD))  # machine PD can be demanded N
        AVR_PD = CR_PD or MOV_PD or (QR_PD and (not CN_PD) and (not CR_PD))  # machine PD can be demanded R
        MOV_PU = VALID and FREE_u2 and (not OCC_u2) and True and True  # machine PU is free to move (R10)
        AVN_PU = CN_PU or MOV_PU or (QN_PU and (not CN_PU) and (not CR_PU))  # machine PU can be demanded N
        AVR_PU = CR_PU or MOV_PU or (QR_PU and (not CN_PU) and (not CR_PU))  # machine PU can be demanded R
        WA_d1_1 = AVN_PD and (not TR_PD)  # d1 from d1|d2@PD.normal to d1|i2@PD.toe: could be locked
        WF_d1_1 = FREE_d1 and (not OCC_d1) and (not BLK_d1) and WA_d1_1  # d1 from d1|d2@PD.normal to d1|i2@PD.toe: free for a route (R6)
        WA_d1_2 = AVR_PD and (not TR_PD)  # d1 from d1|d3@PD.reverse to d1|i2@PD.toe: could be locked
        WF_d1_2 = FREE_d1 and (not OCC_d1) and (not BLK_d1) and WA_d1_2  # d1 from d1|d3@PD.reverse to d1|i2@PD.toe: free for a route (R6)
        WA_d1_3 = AVN_PD and (not TR_PD)  # d1 from d1|i2@PD.toe to d1|d2@PD.normal: could be locked
        WF_d1_3 = FREE_d1 and (not OCC_d1) and (not BLK_d1) and WA_d1_3  # d1 from d1|i2@PD.toe to d1|d2@PD.normal: free for a route (R6)
        WA_d1_4 = AVR_PD and (not TR_PD)  # d1 from d1|i2@PD.toe to d1|d3@PD.reverse: could be locked
        WF_d1_4 = FREE_d1 and (not OCC_d1) and (not BLK_d1) and WA_d1_4  # d1 from d1|i2@PD.toe to d1|d3@PD.reverse: free for a route (R6)
        WF_d2_2 = FREE_d2 and (not OCC_d2) and (not BLK_d2)  # d2 from d1|d2@PD.normal to LB: free for a route (R6)
        WF_d3_1 = FREE_d3 and (not OCC_d3) and (not BLK_d3)  # d3 from L to d1|d3@PD.reverse: free for a route (R6)
        WF_d3_2 = FREE_d3 and (not OCC_d3) and (not BLK_d3)  # d3 from d1|d3@PD.reverse to L: free for a route (R6)
        WF_i1_1 = FREE_i1 and (not OCC_i1) and (not BLK_i1)  # i1 from i1|i2@slope.0 to i1|u2@PU.normal: free for a route (R6)
        WF_i1_2 = FREE_i1 and (not OCC_i1) and (not BLK_i1)  # i1 from i1|u2@PU.normal to i1|i2@slope.0: free for a route (R6)
        WF_i2_1 = FREE_i2 and (not OCC_i2) and (not BLK_i2)  # i2 from d1|i2@PD.toe to i1|i2@slope.0: free for a route (R6)
        WF_i2_2 = FREE_i2 and (not OCC_i2) and (not BLK_i2)  # i2 from i1|i2@slope.0 to d1|i2@PD.toe: free for a route (R6)
        WA_u2_1 = AVN_PU and (not TR_PU)  # u2 from U to i1|u2@PU.normal: could be locked
        WF_u2_1 = FREE_u2 and (not OCC_u2) and (not BLK_u2) and WA_u2_1  # u2 from U to i1|u2@PU.normal: free for a route (R6)
        WA_u2_2 = AVR_PU and (not TR_PU)  # u2 from U to u2|u3_stub@PU.reverse: could be locked
        WF_u2_2 = FREE_u2 and (not OCC_u2) and (not BLK_u2) and WA_u2_2  # u2 from U to u2|u3_stub@PU.reverse: free for a route (R6)
        WA_u2_3 = AVN_PU and (not TR_PU)  # u2 from i1|u2@PU.normal to U: could be locked
        WF_u2_3 = FREE_u2 and (not OCC_u2) and (not BLK_u2) and WA_u2_3  # u2 from i1|u2@PU.normal to U: free for a route (R6)
        WA_u2_4 = AVR_PU and (not TR_PU)  # u2 from u2|u3_stub@PU.reverse to U: could be locked
        WF_u2_4 = FREE_u2 and (not OCC_u2) and (not BLK_u2) and WA_u2_4  # u2 from u2|u3_stub@PU.reverse to U: free for a route (R6)
        WF_u3_stub_2 = FREE_u3_stub and (not OCC_u3_stub) and (not BLK_u3_stub)  # u3_stub from u2|u3_stub@PU.reverse to UB: free for a route (R6)
        WD_d1_1 = QN_PD and (not TR_PD)  # d1 from d1|d2@PD.normal to d1|i2@PD.toe: its points lie, nothing is foul of it
        WL_d1_1 = (not OCC_d1) and WD_d1_1  # d1 from d1|d2@PD.normal to d1|i2@PD.toe: lies and is clear
        WP_d1_1 = WL_d1_1 and (not BLK_d1)  # d1 from d1|d2@PD.normal to d1|i2@PD.toe: proceed may be shown over it (R3)
        WD_d1_2 = QR_PD and (not TR_PD)  # d1 from d1|d3@PD.reverse to d1|i2@PD.toe: its points lie, nothing is foul of it
        WL_d1_2 = (not OCC_d1) and WD_d1_2  # d1 from d1|d3@PD.reverse to d1|i2@PD.toe: lies and is clear
        WP_d1_2 = WL_d1_2 and (not BLK_d1)  # d1 from d1|d3@PD.reverse to d1|i2@PD.toe: proceed may be shown over it (R3)
        WD_d1_3 = QN_PD and (not TR_PD)  # d1 from d1|i2@PD.toe to d1|d2@PD.normal: its points lie, nothing is foul of it
        WL_d1_3 = (not OCC_d1) and WD_d1_3  # d1 from d1|i2@PD.toe to d1|d2@PD.normal: lies and is clear
        WP_d1_3 = WL_d1_3 and (not BLK_d1)  # d1 from d1|i2@PD.toe to d1|d2@PD.normal: proceed may be shown over it (R3)
        WD_d1_4 = QR_PD and (not TR_PD)  # d1 from d1|i2@PD.toe to d1|d3@PD.reverse: its points lie, nothing is foul of it
        WL_d1_4 = (not OCC_d1) and WD_d1_4  # d1 from d1|i2@PD.toe to d1|d3@PD.reverse: lies and is clear
        WP_d1_4 = WL_d1_4 and (not BLK_d1)  # d1 from d1|i2@PD.toe to d1|d3@PD.reverse: proceed may be shown over it (R3)
        WL_d2_2 = (not OCC_d2)  # d2 from d1|d2@PD.normal to LB: lies and is clear
        WP_d2_2 = WL_d2_2 and (not BLK_d2)  # d2 from d1|d2@PD.normal to LB: proceed may be shown over it (R3)
        WL_d3_1 = (not OCC_d3)  # d3 from L to d1|d3@PD.reverse: lies and is clear
        WP_d3_1 = WL_d3_1 and (not BLK_d3)  # d3 from L to d1|d3@PD.reverse: proceed may be shown over it (R3)
        WL_d3_2 = (not OCC_d3)  # d3 from d1|d3@PD.reverse to L: lies and is clear
        WP_d3_2 = WL_d3_2 and (not BLK_d3)  # d3 from d1|d3@PD.reverse to L: proceed may be shown over it (R3)
        WL_i1_1 = (not OCC_i1)  # i1 from i1|i2@slope.0 to i1|u2@PU.normal: lies and is clear
        WP_i1_1 = WL_i1_1 and (not BLK_i1)  # i1 from i1|i2@slope.0 to i1|u2@PU.normal: proceed may be shown over it (R3)
        WL_i1_2 = (not OCC_i1)  # i1 from i1|u2@PU.normal to i1|i2@slope.0: lies and is clear
        WP_i1_2 = WL_i1_2 and (not BLK_i1)  # i1 from i1|u2@PU.normal to i1|i2@slope.0: proceed may be shown over it (R3)
        WL_i2_1 = (not OCC_i2)  # i2 from d1|i2@PD.toe to i1|i2@slope.0: lies and is clear
        WP_i2_1 = WL_i2_1 and (not BLK_i2)  # i2 from d1|i2@PD.toe to i1|i2@slope.0: proceed may be shown over it (R3)
        WL_i2_2 = (not OCC_i2)  # i2 from i1|i2@slope.0 to d1|i2@PD.toe: lies and is clear
        WP_i2_2 = WL_i2_2 and (not BLK_i2)  # i2 from i1|i2@slope.0 to d1|i2@PD.toe: proceed may be shown over it (R3)
        WD_u2_1 = QN_PU and (not TR_PU)  # u2 from U to i1|u2@PU.normal: its points lie, nothing is foul of it
        WL_u2_1 = (not OCC_u2) and WD_u2_1  # u2 from U to i1|u2@PU.normal: lies and is clear
        WP_u2_1 = WL_u2_1 and (not BLK_u2)  # u2 from U to i1|u2@PU.normal: proceed may be shown over it (R3)
        WD_u2_2 = QR_PU and (not TR_PU)  # u2 from U to u2|u3_stub@PU.reverse: its points lie, nothing is foul of it
        WL_u2_2 = (not OCC_u2) and WD_u2_2  # u2 from U to u2|u3_stub@PU.reverse: lies and is clear
        WP_u2_2 = WL_u2_2 and (not BLK_u2)  # u2 from U to u2|u3_stub@PU.reverse: proceed may be shown over it (R3)
        WD_u2_3 = QN_PU and (not TR_PU)  # u2 from i1|u2@PU.normal to U: its points lie, nothing is foul of it
        WL_u2_3 = (not OCC_u2) and WD_u2_3  # u2 from i1|u2@PU.normal to U: lies and is clear
        WP_u2_3 = WL_u2_3 and (not BLK_u2)  # u2 from i1|u2@PU.normal to U: proceed may be shown over it (R3)
        WD_u2_4 = QR_PU and (not TR_PU)  # u2 from u2|u3_stub@PU.reverse to U: its points lie, nothing is foul of it
        WL_u2_4 = (not OCC_u2) and WD_u2_4  # u2 from u2|u3_stub@PU.reverse to U: lies and is clear
        WP_u2_4 = WL_u2_4 and (not BLK_u2)  # u2 from u2|u3_stub@PU.reverse to U: proceed may be shown over it (R3)
        WL_u3_stub_2 = (not OCC_u3_stub)  # u3_stub from u2|u3_stub@PU.reverse to UB: lies and is clear
        WP_u3_stub_2 = WL_u3_stub_2 and (not BLK_u3_stub)  # u3_stub from u2|u3_stub@PU.reverse to UB: proceed may be shown over it (R3)
        G_R1 = ((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and VALID and WF_d1_1 and WF_i2_1 and WF_i1_1  # grant of route XD2-XN1 (R6)
        G_R2 = ((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) and VALID and WF_d1_2 and WF_i2_1 and WF_i1_1  # grant of route XD3-XN1 (R6)
        G_R3 = ((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and VALID and WF_d3_1  # grant of route XL-XD3 (R6)
        G_R4 = ((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and VALID and WF_d1_4 and WF_d3_2  # grant of route XM-L (R6)
        G_R5 = ((LREQ == 5) or ((LREQ == 0) and (REQ == 5))) and VALID and WF_d1_3 and WF_d2_2  # grant of route XM-LB (R6)
        G_R6 = ((LREQ == 6) or ((LREQ == 0) and (REQ == 6))) and VALID and WF_u2_3  # grant of route XN1-U (R6)
        G_R7 = ((LREQ == 7) or ((LREQ == 0) and (REQ == 7))) and VALID and WF_u2_2 and WF_u3_stub_2  # grant of route XU-UB (R6)
        G_R8 = ((LREQ == 8) or ((LREQ == 0) and (REQ == 8))) and VALID and WF_u2_1 and WF_i1_2 and WF_i2_2  # grant of route XU-XM (R6)
        G_R9 = ((LREQ == 9) or ((LREQ == 0) and (REQ == 9))) and VALID and WF_u2_4  # grant of route XU3-U (R6)
        GW_d1_1 = G_R1  # d1 from d1|d2@PD.normal to d1|i2@PD.toe: granted
        GW_d1_2 = G_R2  # d1 from d1|d3@PD.reverse to d1|i2@PD.toe: granted
        GW_d1_3 = G_R5  # d1 from d1|i2@PD.toe to d1|d2@PD.normal: granted
        GW_d1_4 = G_R4  # d1 from d1|i2@PD.toe to d1|d3@PD.reverse: granted
        GW_d2_2 = G_R5  # d2 from d1|d2@PD.normal to LB: granted
        GW_d3_1 = G_R3  # d3 from L to d1|d3@PD.reverse: granted
        GW_d3_2 = G_R4  # d3 from d1|d3@PD.reverse to L: granted
        GW_i1_1 = G_R1 or G_R2  # i1 from i1|i2@slope.0 to i1|u2@PU.normal: granted
        GW_i1_2 = G_R8  # i1 from i1|u2@PU.normal to i1|i2@slope.0: granted
        GW_i2_1 = G_R1 or G_R2  # i2 from d1|i2@PD.toe to i1|i2@slope.0: granted
        GW_i2_2 = G_R8  # i2 from i1|i2@slope.0 to d1|i2@PD.toe: granted
        GW_u2_1 = G_R8  # u2 from U to i1|u2@PU.normal: granted
        GW_u2_2 = G_R7  # u2 from U to u2|u3_stub@PU.reverse: granted
        GW_u2_3 = G_R6  # u2 from i1|u2@PU.normal to U: granted
        GW_u2_4 = G_R9  # u2 from u2|u3_stub@PU.reverse to U: granted
        GW_u3_stub_2 = G_R7  # u3_stub from u2|u3_stub@PU.reverse to UB: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_XD2) and (not CAN_XD2) and WL_d1_1 and WL_i2_1 and WL_i1_1  # route XD2-XN1 becomes locked (R3)
        CO_R1 = VALID and WP_d1_1 and WP_i2_1 and WP_i1_1 and E_B1_OPEN and E_B2_OPEN and E_HOIST_STOPPED and E_NO_PERSON and E_ROPE_ATTACHED and (not D_d1)  # conditions of proceed for route XD2-XN1 (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_XD3) and (not CAN_XD3) and WL_d1_2 and WL_i2_1 and WL_i1_1  # route XD3-XN1 becomes locked (R3)
        CO_R2 = VALID and WP_d1_2 and WP_i2_1 and WP_i1_1 and E_B1_OPEN and E_B2_OPEN and E_HOIST_STOPPED and E_NO_PERSON and E_ROPE_ATTACHED and (not D_d1)  # conditions of proceed for route XD3-XN1 (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_XL) and (not CAN_XL) and WL_d3_1  # route XL-XD3 becomes locked (R3)
        CO_R3 = VALID and WP_d3_1 and (not D_d3)  # conditions of proceed for route XL-XD3 (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_XM) and (not CAN_XM) and WL_d1_4 and WL_d3_2  # route XM-L becomes locked (R3)
        CO_R4 = VALID and WP_d1_4 and WP_d3_2 and E_HOIST_STOPPED and (not OCC_lane) and (not D_d1)  # conditions of proceed for route XM-L (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_XM) and (not CAN_XM) and WL_d1_3 and WL_d2_2  # route XM-LB becomes locked (R3)
        CO_R5 = VALID and WP_d1_3 and WP_d2_2 and E_HOIST_STOPPED and (not D_d1)  # conditions of proceed for route XM-LB (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_XN1) and (not CAN_XN1) and WL_u2_3  # route XN1-U becomes locked (R3)
        CO_R6 = VALID and WP_u2_3 and E_HOIST_STOPPED and (not OCC_u1) and (not D_u2)  # conditions of proceed for route XN1-U (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_XU) and (not CAN_XU) and WL_u2_2 and WL_u3_stub_2  # route XU-UB becomes locked (R3)
        CO_R7 = VALID and WP_u2_2 and WP_u3_stub_2 and E_HOIST_STOPPED and (not D_u2)  # conditions of proceed for route XU-UB (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_XU) and (not CAN_XU) and WL_u2_1 and WL_i1_2 and WL_i2_2  # route XU-XM becomes locked (R3)
        CO_R8 = VALID and WP_u2_1 and WP_i1_2 and WP_i2_2 and E_B1_OPEN and E_B2_OPEN and E_HOIST_STOPPED and E_NO_PERSON and E_ROPE_ATTACHED and (not D_u2)  # conditions of proceed for route XU-XM (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_XU3) and (not CAN_XU3) and WL_u2_4  # route XU3-U becomes locked (R3)
        CO_R9 = VALID and WP_u2_4 and E_HOIST_STOPPED and (not OCC_u1) and (not D_u2)  # conditions of proceed for route XU3-U (R3)
        NU_d1_1 = VALID and F_d1 and (not D_d1) and (not U_d1) and L_d1_1 and OCC_d1 and OCC_d2  # a train comes into d1 at d1|d2@PD.normal (R9)
        NU_d1_2 = VALID and F_d1 and (not D_d1) and (not U_d1) and L_d1_2 and OCC_d1 and OCC_d3  # a train comes into d1 at d1|d3@PD.reverse (R9)
        NU_d1_3 = VALID and F_d1 and (not D_d1) and (not U_d1) and (L_d1_3 or L_d1_4) and OCC_d1 and OCC_i2  # a train comes into d1 at d1|i2@PD.toe (R9)
        NU_d2_2 = VALID and F_d2 and (not D_d2) and (not U_d2) and L_d2_2 and OCC_d2 and OCC_d1 and U_d1 and L_d1_3  # a train comes into d2 at d1|d2@PD.normal (R9)
        NU_d3_1 = VALID and F_d3 and (not D_d3) and (not U_d3) and L_d3_1 and OCC_d3 and OCC_lane  # a train comes into d3 at L (R9)
        NU_d3_2 = VALID and F_d3 and (not D_d3) and (not U_d3) and L_d3_2 and OCC_d3 and OCC_d1 and U_d1 and L_d1_4  # a train comes into d3 at d1|d3@PD.reverse (R9)
        NU_i1_1 = VALID and F_i1 and (not D_i1) and (not U_i1) and L_i1_1 and OCC_i1 and OCC_i2 and U_i2 and L_i2_1  # a train comes into i1 at i1|i2@slope.0 (R9)
        NU_i1_2 = VALID and F_i1 and (not D_i1) and (not U_i1) and L_i1_2 and OCC_i1 and OCC_u2 and U_u2 and L_u2_1  # a train comes into i1 at i1|u2@PU.normal (R9)
        NU_i2_1 = VALID and F_i2 and (not D_i2) and (not U_i2) and L_i2_1 and OCC_i2 and OCC_d1 and U_d1 and (L_d1_1 or L_d1_2)  # a train comes into i2 at d1|i2@PD.toe (R9)
        NU_i2_2 = VALID and F_i2 and (not D_i2) and (not U_i2) and L_i2_2 and OCC_i2 and OCC_i1 and U_i1 and L_i1_2  # a train comes into i2 at i1|i2@slope.0 (R9)
        NU_u2_1 = VALID and F_u2 and (not D_u2) and (not U_u2) and (L_u2_1 or L_u2_2) and OCC_u2 and OCC_u1  # a train comes into u2 at U (R9)
        NU_u2_2 = VALID and F_u2 and (not D_u2) and (not U_u2) and L_u2_3 and OCC_u2 and OCC_i1  # a train comes into u2 at i1|u2@PU.normal (R9)
        NU_u2_3 = VALID and F_u2 and (not D_u2) and (not U_u2) and L_u2_4 and OCC_u2 and OCC_u3_stub  # a train comes into u2 at u2|u3_stub@PU.reverse (R9)
        NU_u3_stub_2 = VALID and F_u3_stub and (not D_u3_stub) and (not U_u3_stub) and L_u3_stub_2 and OCC_u3_stub and OCC_u2 and U_u2 and L_u2_2  # a train comes into u3_stub at u2|u3_stub@PU.reverse (R9)
        ATI_XD2 = X_XD2 or ((not A_R1) and L_d1_1 and REL_d1)  # XD2 at stop, waiting for a train that may still come (R8)
        ATI_XD3 = X_XD3 or ((not A_R2) and L_d1_2 and REL_d1)  # XD3 at stop, waiting for a train that may still come (R8)
        ATI_XL = X_XL or ((not A_R3) and L_d3_1 and REL_d3)  # XL at stop, waiting for a train that may still come (R8)
        ATI_XM = X_XM or ((not (A_R4 or A_R5)) and (L_d1_3 or L_d1_4) and REL_d1)  # XM at stop, waiting for a train that may still come (R8)
        ATI_XN1 = X_XN1 or ((not A_R6) and L_u2_3 and (REL_u2 or (L_u2_3 and U_u2 and (not OCC_u2))))  # XN1 at stop, waiting for a train that may still come (R8)
        ATI_XU = X_XU or ((not (A_R7 or A_R8)) and (L_u2_1 or L_u2_2) and REL_u2)  # XU at stop, waiting for a train that may still come (R8)
        ATI_XU3 = X_XU3 or ((not A_R9) and L_u2_4 and (REL_u2 or (L_u2_4 and U_u2 and (not OCC_u2))))  # XU3 at stop, waiting for a train that may still come (R8)
        AT_XD2 = self._timer('AT_XD2', ATI_XD2, dt_ms)  # XD2: approach locking delay (R8)
        AT_XD3 = self._timer('AT_XD3', ATI_XD3, dt_ms)  # XD3: approach locking delay (R8)
        AT_XL = self._timer('AT_XL', ATI_XL, dt_ms)  # XL: approach locking delay (R8)
        AT_XM = self._timer('AT_XM', ATI_XM, dt_ms)  # XM: approach locking delay (R8)
        AT_XN1 = self._timer('AT_XN1', ATI_XN1, dt_ms)  # XN1: approach locking delay (R8)
        AT_XU = self._timer('AT_XU', ATI_XU, dt_ms)  # XU: approach locking delay (R8)
        AT_XU3 = self._timer('AT_XU3', ATI_XU3, dt_ms)  # XU3: approach locking delay (R8)
        CD_XD2 = X_XD2 and A_R1 and VALID and (not OCC_d1) and ((not OCC_d2) or AT_XD2 or (not H_R1))  # the route from XD2 is cancelled (R8)
        CD_XD3 = X_XD3 and A_R2 and VALID and (not OCC_d1) and ((not OCC_d3) or AT_XD3 or (not H_R2))  # the route from XD3 is cancelled (R8)
        CD_XL = X_XL and A_R3 and VALID and (not OCC_d3) and ((not OCC_lane) or AT_XL or (not H_R3))  # the route from XL is cancelled (R8)
        CD_XM = X_XM and (A_R4 or A_R5) and VALID and (not OCC_d1) and ((not OCC_i2) or AT_XM or (not (H_R4 or H_R5)))  # the route from XM is cancelled (R8)
        CD_XN1 = X_XN1 and A_R6 and VALID and (not OCC_u2) and ((not OCC_i1) or AT_XN1 or (not H_R6))  # the route from XN1 is cancelled (R8)
        CD_XU = X_XU and (A_R7 or A_R8) and VALID and (not OCC_u2) and ((not OCC_u1) or AT_XU or (not (H_R7 or H_R8)))  # the route from XU is cancelled (R8)
        CD_XU3 = X_XU3 and A_R9 and VALID and (not OCC_u2) and ((not OCC_u3_stub) or AT_XU3 or (not H_R9))  # the route from XU3 is cancelled (R8)
        EX_d1 = P_d1  # a train in d1 leaves over a boundary, or has passed on
        RTI_d1 = VALID and U_d1 and (not OCC_d1) and EX_d1  # d1 may be released behind the train (R9)
        EX_d2 = P_d2  # a train in d2 leaves over a boundary, or has passed on
        RTI_d2 = VALID and U_d2 and (not OCC_d2) and (not (L_d2_2 and L_d1_3)) and EX_d2  # d2 may be released behind the train (R9)
        EX_d3 = P_d3 or L_d3_2  # a train in d3 leaves over a boundary, or has passed on
        RTI_d3 = VALID and U_d3 and (not OCC_d3) and (not (L_d3_2 and L_d1_4)) and EX_d3  # d3 may be released behind the train (R9)
        EX_i1 = P_i1  # a train in i1 leaves over a boundary, or has passed on
        RTI_i1 = VALID and U_i1 and (not OCC_i1) and (not (L_i1_1 and L_i2_1)) and (not (L_i1_2 and L_u2_1)) and EX_i1  # i1 may be released behind the train (R9)
        EX_i2 = P_i2  # a train in i2 leaves over a boundary, or has passed on
        RTI_i2 = VALID and U_i2 and (not OCC_i2) and (not (L_i2_1 and (L_d1_1 or L_d1_2))) and (not (L_i2_2 and L_i1_2)) and EX_i2  # i2 may be released behind the train (R9)
        EX_u2 = P_u2 or (L_u2_3 and ((not OCC_i1) or AT_XN1)) or (L_u2_4 and ((not OCC_u3_stub) or AT_XU3))  # a train in u2 leaves over a boundary, or has passed on
        RTI_u2 = VALID and U_u2 and (not OCC_u2) and EX_u2  # u2 may be released behind the train (R9)
        EX_u3_stub = P_u3_stub  # a train in u3_stub leaves over a boundary, or has passed on
        RTI_u3_stub = VALID and U_u3_stub and (not OCC_u3_stub) and (not (L_u3_stub_2 and L_u2_2)) and EX_u3_stub  # u3_stub may be released behind the train (R9)
        RT_d1 = self._timer('RT_d1', RTI_d1, dt_ms)  # d1: release delay (R9)
        RT_d2 = self._timer('RT_d2', RTI_d2, dt_ms)  # d2: release delay (R9)
        RT_d3 = self._timer('RT_d3', RTI_d3, dt_ms)  # d3: release delay (R9)
        RT_i1 = self._timer('RT_i1', RTI_i1, dt_ms)  # i1: release delay (R9)
        RT_i2 = self._timer('RT_i2', RTI_i2, dt_ms)  # i2: release delay (R9)
        RT_u2 = self._timer('RT_u2', RTI_u2, dt_ms)  # u2: release delay (R9)
        RT_u3_stub = self._timer('RT_u3_stub', RTI_u3_stub, dt_ms)  # u3_stub: release delay (R9)
        CA_d1 = VALID and (not OCC_d1) and (not U_d1) and False  # the lock before d1 was withdrawn (R8)
        HR_d1 = VALID and (not OCC_d1) and REL_d1 and (L_d1_1 or L_d1_2 or L_d1_3 or L_d1_4) and ((not L_d1_1) or ((not A_R1) and ((not OCC_d2) or AT_XD2))) and ((not L_d1_2) or ((not A_R2) and ((not OCC_d3) or AT_XD3))) and ((not (L_d1_3 or L_d1_4)) or ((not (A_R4 or A_R5)) and ((not OCC_i2) or AT_XM)))  # d1 released by hand (R8, section fault release)
        SR_d1 = VALID and (not OCC_d1) and K_d1 and (REL_d1 or RELALL)  # d1 released after a restart (R16)
        RLS_d1 = RT_d1 or CA_d1 or CD_XD2 or CD_XD3 or CD_XM or HR_d1 or SR_d1  # d1 is released
        CA_d2 = VALID and (not OCC_d2) and (not U_d2) and L_d2_2 and (not (L_d2_2 and L_d1_3))  # the lock before d2 was withdrawn (R8)
        HR_d2 = VALID and (not OCC_d2) and (not (L_d2_2 and L_d1_3)) and REL_d2 and L_d2_2  # d2 released by hand (R8, section fault release)
        SR_d2 = VALID and (not OCC_d2) and K_d2 and (REL_d2 or RELALL)  # d2 released after a restart (R16)
        RLS_d2 = RT_d2 or CA_d2 or HR_d2 or SR_d2  # d2 is released
        CA_d3 = VALID and (not OCC_d3) and (not U_d3) and L_d3_2 and (not (L_d3_2 and L_d1_4))  # the lock before d3 was withdrawn (R8)
        HR_d3 = VALID and (not OCC_d3) and (not (L_d3_2 and L_d1_4)) and REL_d3 and (L_d3_1 or L_d3_2) and ((not L_d3_1) or ((not A_R3) and ((not OCC_lane) or AT_XL)))  # d3 released by hand (R8, section fault release)
        SR_d3 = VALID and (not OCC_d3) and K_d3 and (REL_d3 or RELALL)  # d3 released after a restart (R16)
        RLS_d3 = RT_d3 or CA_d3 or CD_XL or HR_d3 or SR_d3  # d3 is released
        CA_i1 = VALID and (not OCC_i1) and (not U_i1) and (L_i1_1 or L_i1_2) and (not (L_i1_1 and L_i2_1)) and (not (L_i1_2 and L_u2_1))  # the lock before i1 was withdrawn (R8)
        HR_i1 = VALID and (not OCC_i1) and (not (L_i1_1 and L_i2_1)) and (not (L_i1_2 and L_u2_1)) and REL_i1 and (L_i1_1 or L_i1_2)  # i1 released by hand (R8, section fault release)
        SR_i1 = VALID and (not OCC_i1) and K_i1 and (REL_i1 or RELALL)  # i1 released after a restart (R16)
        RLS_i1 = RT_i1 or CA_i1 or HR_i1 or SR_i1  # i1 is released
        CA_i2 = VALID and (not OCC_i2) and (not U_i2) and (L_i2_1 or L_i2_2) and (not (L_i2_1 and (L_d1_1 or L_d1_2))) and (not (L_i2_2 and L_i1_2))  # the lock before i2 was withdrawn (R8)
        HR_i2 = VALID and (not OCC_i2) and (not (L_i2_1 and (L_d1_1 or L_d1_2))) and (not (L_i2_2 and L_i1_2)) and REL_i2 and (L_i2_1 or L_i2_2)  # i2 released by hand (R8, section fault release)
        SR_i2 = VALID and (not OCC_i2) and K_i2 and (REL_i2 or RELALL)  # i2 released after a restart (R16)
        RLS_i2 = RT_i2 or CA_i2 or HR_i2 or SR_i2  # i2 is released
        CA_u2 = VALID and (not OCC_u2) and (not U_u2) and False  # the lock before u2 was withdrawn (R8)
        HR_u2 = VALID and (not OCC_u2) and REL_u2 and (L_u2_1 or L_u2_2 or L_u2_3 or L_u2_4) and ((not (L_u2_1 or L_u2_2)) or ((not (A_R7 or A_R8)) and ((not OCC_u1) or AT_XU))) and ((not L_u2_3) or ((not A_R6) and ((not OCC_i1) or AT_XN1))) and ((not L_u2_4) or ((not A_R9) and ((not OCC_u3_stub) or AT_XU3)))  # u2 released by hand (R8, section fault release)
        SR_u2 = VALID and (not OCC_u2) and K_u2 and (REL_u2 or RELALL)  # u2 released after a restart (R16)
        RLS_u2 = RT_u2 or CA_u2 or CD_XU or CD_XN1 or CD_XU3 or HR_u2 or SR_u2  # u2 is released
        CA_u3_stub = VALID and (not OCC_u3_stub) and (not U_u3_stub) and L_u3_stub_2 and (not (L_u3_stub_2 and L_u2_2))  # the lock before u3_stub was withdrawn (R8)
        HR_u3_stub = VALID and (not OCC_u3_stub) and (not (L_u3_stub_2 and L_u2_2)) and REL_u3_stub and L_u3_stub_2  # u3_stub released by hand (R8, section fault release)
        SR_u3_stub = VALID and (not OCC_u3_stub) and K_u3_stub and (REL_u3_stub or RELALL)  # u3_stub released after a restart (R16)
        RLS_u3_stub = RT_u3_stub or CA_u3_stub or HR_u3_stub or SR_u3_stub  # u3_stub is released
        TG_PD = (GW_d1_1 or GW_d1_2 or GW_d1_3 or GW_d1_4)  # a grant touches machine PD in this scan
        GPN_PD = (GW_d1_1 or GW_d1_3)  # a grant needs PD N
        MAN_PD = MN_PD and (not MR_PD) and MOV_PD and (not TG_PD)  # machine PD moved N by hand
        GPR_PD = (GW_d1_2 or GW_d1_4)  # a grant needs PD R
        MAR_PD = MR_PD and (not MN_PD) and MOV_PD and (not TG_PD)  # machine PD moved R by hand
        HDN_PD = CN_PD and (not GPR_PD) and (not MAR_PD)  # the command N stays
        HDR_PD = CR_PD and (not GPN_PD) and (not MAN_PD)  # the command R stays
        TG_PU = (GW_u2_1 or GW_u2_2 or GW_u2_3 or GW_u2_4)  # a grant touches machine PU in this scan
        GPN_PU = (GW_u2_1 or GW_u2_3)  # a grant needs PU N
        MAN_PU = MN_PU and (not MR_PU) and MOV_PU and (not TG_PU)  # machine PU moved N by hand
        GPR_PU = (GW_u2_2 or GW_u2_4)  # a grant needs PU R
        MAR_PU = MR_PU and (not MN_PU) and MOV_PU and (not TG_PU)  # machine PU moved R by hand
        HDN_PU = CN_PU and (not GPR_PU) and (not MAR_PU)  # the command N stays
        HDR_PU = CR_PU and (not GPN_PU) and (not MAN_PU)  # the command R stays
        STI_PD = (CN_PD and (not QN_PD)) or (CR_PD and (not QR_PD))  # machine PD is not where it was commanded
        STI_PU = (CN_PU and (not QN_PU)) or (CR_PU and (not QR_PU))  # machine PU is not where it was commanded
        ST_PD = self._timer('ST_PD', STI_PD, dt_ms)  # machine PD: time-out
        ST_PU = self._timer('ST_PU', STI_PU, dt_ms)  # machine PU: time-out
        KP_R1 = (not NU_d1_1) and (not CD_XD2)  # route XD2-XN1 stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_XD2) and (not CAN_XD2)  # proceed for route XD2-XN1 (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route XD2-XN1: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_d1_2) and (not CD_XD3)  # route XD3-XN1 stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_XD3) and (not CAN_XD3)  # proceed for route XD3-XN1 (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route XD3-XN1: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_d3_1) and (not CD_XL)  # route XL-XD3 stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_XL) and (not CAN_XL)  # proceed for route XL-XD3 (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route XL-XD3: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_d1_3) and (not CD_XM)  # route XM-L stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_XM) and (not CAN_XM)  # proceed for route XM-L (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route XM-L: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_d1_3) and (not CD_XM)  # route XM-LB stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_XM) and (not CAN_XM)  # proceed for route XM-LB (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route XM-LB: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_u2_2) and (not CD_XN1)  # route XN1-U stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_XN1) and (not CAN_XN1)  # proceed for route XN1-U (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route XN1-U: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_u2_1) and (not CD_XU)  # route XU-UB stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_XU) and (not CAN_XU)  # proceed for route XU-UB (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route XU-UB: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_u2_1) and (not CD_XU)  # route XU-XM stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_XU) and (not CAN_XU)  # proceed for route XU-XM (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route XU-XM: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_u2_3) and (not CD_XU3)  # route XU3-U stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_XU3) and (not CAN_XU3)  # proceed for route XU3-U (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route XU3-U: a condition was lost; no reopening by itself (R14)
        N_CN_PD = GPN_PD or MAN_PD or HDN_PD  # machine PD commanded N
        N_CR_PD = GPR_PD or MAR_PD or HDR_PD  # machine PD commanded R
        N_CN_PU = GPN_PU or MAN_PU or HDN_PU  # machine PU commanded N
        N_CR_PU = GPR_PU or MAR_PU or HDR_PU  # machine PU commanded R
        N_AL_PD = ST_PD  # alarm: machine PD not detected
        N_AL_PU = ST_PU  # alarm: machine PU not detected
        N_TH_PD = ((CN_PD and QN_PD) or (CR_PD and QR_PD)) and (not (GPN_PD or GPR_PD or MAN_PD or MAR_PD))  # machine PD was detected where it is commanded
        N_TR_PD = (TH_PD and VALID and ((CN_PD and (not QN_PD) and (not GPR_PD) and (not MAR_PD)) or (CR_PD and (not QR_PD) and (not GPN_PD) and (not MAN_PD)))) or (TR_PD and (not (TC_PD and VALID and (not OCC_d1))))  # machine PD was trailed
        N_TH_PU = ((CN_PU and QN_PU) or (CR_PU and QR_PU)) and (not (GPN_PU or GPR_PU or MAN_PU or MAR_PU))  # machine PU was detected where it is commanded
        N_TR_PU = (TH_PU and VALID and ((CN_PU and (not QN_PU) and (not GPR_PU) and (not MAR_PU)) or (CR_PU and (not QR_PU) and (not GPN_PU) and (not MAN_PU)))) or (TR_PU and (not (TC_PU and VALID and (not OCC_u2))))  # machine PU was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route XD2-XN1 active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route XD2-XN1 locked
        N_W_R1 = (W_R1 or LK_R1 or (((LREQ == 1) or ((LREQ == 0) and (REQ == 1))) and B_R1)) and (not LS_R1) and KP_R1 and (not X_XD2) and (not CAN_XD2)  # route XD2-XN1: proceed wanted
        N_S_R1 = PR_R1  # route XD2-XN1: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route XD2-XN1: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route XD3-XN1 active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route XD3-XN1 locked
        N_W_R2 = (W_R2 or LK_R2 or (((LREQ == 2) or ((LREQ == 0) and (REQ == 2))) and B_R2)) and (not LS_R2) and KP_R2 and (not X_XD3) and (not CAN_XD3)  # route XD3-XN1: proceed wanted
        N_S_R2 = PR_R2  # route XD3-XN1: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route XD3-XN1: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route XL-XD3 active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route XL-XD3 locked
        N_W_R3 = (W_R3 or LK_R3 or (((LREQ == 3) or ((LREQ == 0) and (REQ == 3))) and B_R3)) and (not LS_R3) and KP_R3 and (not X_XL) and (not CAN_XL)  # route XL-XD3: proceed wanted
        N_S_R3 = PR_R3  # route XL-XD3: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route XL-XD3: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route XM-L active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route XM-L locked
        N_W_R4 = (W_R4 or LK_R4 or (((LREQ == 4) or ((LREQ == 0) and (REQ == 4))) and B_R4)) and (not LS_R4) and KP_R4 and (not X_XM) and (not CAN_XM)  # route XM-L: proceed wanted
        N_S_R4 = PR_R4  # route XM-L: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route XM-L: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route XM-LB active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route XM-LB locked
        N_W_R5 = (W_R5 or LK_R5 or (((LREQ == 5) or ((LREQ == 0) and (REQ == 5))) and B_R5)) and (not LS_R5) and KP_R5 and (not X_XM) and (not CAN_XM)  # route XM-LB: proceed wanted
        N_S_R5 = PR_R5  # route XM-LB: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route XM-LB: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route XN1-U active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route XN1-U locked
        N_W_R6 = (W_R6 or LK_R6 or (((LREQ == 6) or ((LREQ == 0) and (REQ == 6))) and B_R6)) and (not LS_R6) and KP_R6 and (not X_XN1) and (not CAN_XN1)  # route XN1-U: proceed wanted
        N_S_R6 = PR_R6  # route XN1-U: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route XN1-U: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route XU-UB active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route XU-UB locked
        N_W_R7 = (W_R7 or LK_R7 or (((LREQ == 7) or ((LREQ == 0) and (REQ == 7))) and B_R7)) and (not LS_R7) and KP_R7 and (not X_XU) and (not CAN_XU)  # route XU-UB: proceed wanted
        N_S_R7 = PR_R7  # route XU-UB: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route XU-UB: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route XU-XM active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route XU-XM locked
        N_W_R8 = (W_R8 or LK_R8 or (((LREQ == 8) or ((LREQ == 0) and (REQ == 8))) and B_R8)) and (not LS_R8) and KP_R8 and (not X_XU) and (not CAN_XU)  # route XU-XM: proceed wanted
        N_S_R8 = PR_R8  # route XU-XM: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route XU-XM: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route XU3-U active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route XU3-U locked
        N_W_R9 = (W_R9 or LK_R9 or (((LREQ == 9) or ((LREQ == 0) and (REQ == 9))) and B_R9)) and (not LS_R9) and KP_R9 and (not X_XU3) and (not CAN_XU3)  # route XU3-U: proceed wanted
        N_S_R9 = PR_R9  # route XU3-U: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route XU3-U: signal has been open
        N_X_XD2 = (X_XD2 or CAN_XD2) and A_R1 and (not CD_XD2)  # XD2: cancelling
        N_X_XD3 = (X_XD3 or CAN_XD3) and A_R2 and (not CD_XD3)  # XD3: cancelling
        N_X_XL = (X_XL or CAN_XL) and A_R3 and (not CD_XL)  # XL: cancelling
        N_X_XM = (X_XM or CAN_XM) and (A_R4 or A_R5) and (not CD_XM)  # XM: cancelling
        N_X_XN1 = (X_XN1 or CAN_XN1) and A_R6 and (not CD_XN1)  # XN1: cancelling
        N_X_XU = (X_XU or CAN_XU) and (A_R7 or A_R8) and (not CD_XU)  # XU: cancelling
        N_X_XU3 = (X_XU3 or CAN_XU3) and A_R9 and (not CD_XU3)  # XU3: cancelling
        N_K_d1 = K_d1 and (not RLS_d1)  # d1: restart lock (R16)
        N_L_d1_1 = (L_d1_1 or GW_d1_1) and (not RLS_d1)  # d1 locked from d1|d2@PD.normal to d1|i2@PD.toe
        N_L_d1_2 = (L_d1_2 or GW_d1_2) and (not RLS_d1)  # d1 locked from d1|d3@PD.reverse to d1|i2@PD.toe
        N_L_d1_3 = (L_d1_3 or GW_d1_3) and (not RLS_d1)  # d1 locked from d1|i2@PD.toe to d1|d2@PD.normal
        N_L_d1_4 = (L_d1_4 or GW_d1_4) and (not RLS_d1)  # d1 locked from d1|i2@PD.toe to d1|d3@PD.reverse
        N_F_d1 = (F_d1 or LK_R1 or LK_R2 or LK_R5 or LK_R4) and (not RLS_d1)  # d1 firmly locked
        N_U_d1 = (U_d1 or NU_d1_1 or NU_d1_2 or NU_d1_3) and (not RLS_d1)  # d1 used by a train (R9)
        N_P_d1 = (P_d1 or (U_d1 and OCC_d1 and (NU_d2_2 or NU_d3_2 or NU_i2_1))) and (not RLS_d1)  # d1: the train went on (R9)
        N_D_d1 = (D_d1 or ((not VALID) and (L_d1_1 or L_d1_2 or L_d1_3 or L_d1_4))) and (not RLS_d1)  # d1: detection is not relied on, inputs were lost or a train is called on
        N_K_d2 = K_d2 and (not RLS_d2)  # d2: restart lock (R16)
        N_L_d2_2 = (L_d2_2 or GW_d2_2) and (not RLS_d2)  # d2 locked from d1|d2@PD.normal to LB
        N_F_d2 = (F_d2 or LK_R5) and (not RLS_d2)  # d2 firmly locked
        N_U_d2 = (U_d2 or NU_d2_2) and (not RLS_d2)  # d2 used by a train (R9)
        N_P_d2 = (P_d2 or (U_d2 and OCC_d2 and NU_d1_1)) and (not RLS_d2)  # d2: the train went on (R9)
        N_D_d2 = (D_d2 or ((not VALID) and L_d2_2)) and (not RLS_d2)  # d2: detection is not relied on, inputs were lost or a train is called on
        N_K_d3 = K_d3 and (not RLS_d3)  # d3: restart lock (R16)
        N_L_d3_1 = (L_d3_1 or GW_d3_1) and (not RLS_d3)  # d3 locked from L to d1|d3@PD.reverse
        N_L_d3_2 = (L_d3_2 or GW_d3_2) and (not RLS_d3)  # d3 locked from d1|d3@PD.reverse to L
        N_F_d3 = (F_d3 or LK_R3 or LK_R4) and (not RLS_d3)  # d3 firmly locked
        N_U_d3 = (U_d3 or NU_d3_1 or NU_d3_2) and (not RLS_d3)  # d3 used by a train (R9)
        N_P_d3 = (P_d3 or (U_d3 and OCC_d3 and NU_d1_2)) and (not RLS_d3)  # d3: the train went on (R9)
        N_D_d3 = (D_d3 or ((not VALID) and (L_d3_1 or L_d3_2))) and (not RLS_d3)  # d3: detection is not relied on, inputs were lost or a train is called on
        N_K_i1 = K_i1 and (not RLS_i1)  # i1: restart lock (R16)
        N_L_i1_1 = (L_i1_1 or GW_i1_1) and (not RLS_i1)  # i1 locked from i1|i2@slope.0 to i1|u2@PU.normal
        N_L_i1_2 = (L_i1_2 or GW_i1_2) and (not RLS_i1)  # i1 locked from i1|u2@PU.normal to i1|i2@slope.0
        N_F_i1 = (F_i1 or LK_R1 or LK_R2 or LK_R8) and (not RLS_i1)  # i1 firmly locked
        N_U_i1 = (U_i1 or NU_i1_1 or NU_i1_2) and (not RLS_i1)  # i1 used by a train (R9)
        N_P_i1 = (P_i1 or (U_i1 and OCC_i1 and (NU_i2_2 or NU_u2_2))) and (not RLS_i1)  # i1: the train went on (R9)
        N_D_i1 = (D_i1 or ((not VALID) and (L_i1_1 or L_i1_2))) and (not RLS_i1)  # i1: detection is not relied on, inputs were lost or a train is called on
        N_K_i2 = K_i2 and (not RLS_i2)  # i2: restart lock (R16)
        N_L_i2_1 = (L_i2_1 or GW_i2_1) and (not RLS_i2)  # i2 locked from d1|i2@PD.toe to i1|i2@slope.0
        N_L_i2_2 = (L_i2_2 or GW_i2_2) and (not RLS_i2)  # i2 locked from i1|i2@slope.0 to d1|i2@PD.toe
        N_F_i2 = (F_i2 or LK_R1 or LK_R2 or LK_R8) and (not RLS_i2)  # i2 firmly locked
        N_U_i2 = (U_i2 or NU_i2_1 or NU_i2_2) and (not RLS_i2)  # i2 used by a train (R9)
        N_P_i2 = (P_i2 or (U_i2 and OCC_i2 and (NU_d1_3 or NU_i1_1))) and (not RLS_i2)  # i2: the train went on (R9)
        N_D_i2 = (D_i2 or ((not VALID) and (L_i2_1 or L_i2_2))) and (not RLS_i2)  # i2: detection is not relied on, inputs were lost or a train is called on
        N_K_u2 = K_u2 and (not RLS_u2)  # u2: restart lock (R16)
        N_L_u2_1 = (L_u2_1 or GW_u2_1) and (not RLS_u2)  # u2 locked from U to i1|u2@PU.normal
        N_L_u2_2 = (L_u2_2 or GW_u2_2) and (not RLS_u2)  # u2 locked from U to u2|u3_stub@PU.reverse
        N_L_u2_3 = (L_u2_3 or GW_u2_3) and (not RLS_u2)  # u2 locked from i1|u2@PU.normal to U
        N_L_u2_4 = (L_u2_4 or GW_u2_4) and (not RLS_u2)  # u2 locked from u2|u3_stub@PU.reverse to U
        N_F_u2 = (F_u2 or LK_R8 or LK_R7 or LK_R6 or LK_R9) and (not RLS_u2)  # u2 firmly locked
        N_U_u2 = (U_u2 or NU_u2_1 or NU_u2_2 or NU_u2_3) and (not RLS_u2)  # u2 used by a train (R9)
        N_P_u2 = (P_u2 or (U_u2 and OCC_u2 and (NU_i1_2 or NU_u3_stub_2))) and (not RLS_u2)  # u2: the train went on (R9)
        N_D_u2 = (D_u2 or ((not VALID) and (L_u2_1 or L_u2_2 or L_u2_3 or L_u2_4))) and (not RLS_u2)  # u2: detection is not relied on, inputs were lost or a train is called on
        N_K_u3_stub = K_u3_stub and (not RLS_u3_stub)  # u3_stub: restart lock (R16)
        N_L_u3_stub_2 = (L_u3_stub_2 or GW_u3_stub_2) and (not RLS_u3_stub)  # u3_stub locked from u2|u3_stub@PU.reverse to UB
        N_F_u3_stub = (F_u3_stub or LK_R7) and (not RLS_u3_stub)  # u3_stub firmly locked
        N_U_u3_stub = (U_u3_stub or NU_u3_stub_2) and (not RLS_u3_stub)  # u3_stub used by a train (R9)
        N_P_u3_stub = (P_u3_stub or (U_u3_stub and OCC_u3_stub and NU_u2_3)) and (not RLS_u3_stub)  # u3_stub: the train went on (R9)
        N_D_u3_stub = (D_u3_stub or ((not VALID) and L_u3_stub_2)) and (not RLS_u3_stub)  # u3_stub: detection is not relied on, inputs were lost or a train is called on
        self.state = {
            'CN_PD': bool(N_CN_PD),
            'CR_PD': bool(N_CR_PD),
            'CN_PU': bool(N_CN_PU),
            'CR_PU': bool(N_CR_PU),
            'AL_PD': bool(N_AL_PD),
            'AL_PU': bool(N_AL_PU),
            'TH_PD': bool(N_TH_PD),
            'TR_PD': bool(N_TR_PD),
            'TH_PU': bool(N_TH_PU),
            'TR_PU': bool(N_TR_PU),
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
            'X_XD2': bool(N_X_XD2),
            'X_XD3': bool(N_X_XD3),
            'X_XL': bool(N_X_XL),
            'X_XM': bool(N_X_XM),
            'X_XN1': bool(N_X_XN1),
            'X_XU': bool(N_X_XU),
            'X_XU3': bool(N_X_XU3),
            'K_d1': bool(N_K_d1),
            'L_d1_1': bool(N_L_d1_1),
            'L_d1_2': bool(N_L_d1_2),
            'L_d1_3': bool(N_L_d1_3),
            'L_d1_4': bool(N_L_d1_4),
            'F_d1': bool(N_F_d1),
            'U_d1': bool(N_U_d1),
            'P_d1': bool(N_P_d1),
            'D_d1': bool(N_D_d1),
            'K_d2': bool(N_K_d2),
            'L_d2_2': bool(N_L_d2_2),
            'F_d2': bool(N_F_d2),
            'U_d2': bool(N_U_d2),
            'P_d2': bool(N_P_d2),
            'D_d2': bool(N_D_d2),
            'K_d3': bool(N_K_d3),
            'L_d3_1': bool(N_L_d3_1),
            'L_d3_2': bool(N_L_d3_2),
            'F_d3': bool(N_F_d3),
            'U_d3': bool(N_U_d3),
            'P_d3': bool(N_P_d3),
            'D_d3': bool(N_D_d3),
            'K_i1': bool(N_K_i1),
            'L_i1_1': bool(N_L_i1_1),
            'L_i1_2': bool(N_L_i1_2),
            'F_i1': bool(N_F_i1),
            'U_i1': bool(N_U_i1),
            'P_i1': bool(N_P_i1),
            'D_i1': bool(N_D_i1),
            'K_i2': bool(N_K_i2),
            'L_i2_1': bool(N_L_i2_1),
            'L_i2_2': bool(N_L_i2_2),
            'F_i2': bool(N_F_i2),
            'U_i2': bool(N_U_i2),
            'P_i2': bool(N_P_i2),
            'D_i2': bool(N_D_i2),
            'K_u2': bool(N_K_u2),
            'L_u2_1': bool(N_L_u2_1),
            'L_u2_2': bool(N_L_u2_2),
            'L_u2_3': bool(N_L_u2_3),
            'L_u2_4': bool(N_L_u2_4),
            'F_u2': bool(N_F_u2),
            'U_u2': bool(N_U_u2),
            'P_u2': bool(N_P_u2),
            'D_u2': bool(N_D_u2),
            'K_u3_stub': bool(N_K_u3_stub),
            'L_u3_stub_2': bool(N_L_u3_stub_2),
            'F_u3_stub': bool(N_F_u3_stub),
            'U_u3_stub': bool(N_U_u3_stub),
            'P_u3_stub': bool(N_P_u3_stub),
            'D_u3_stub': bool(N_D_u3_stub),
        }
        CN_PD = self.state['CN_PD']
        CR_PD = self.state['CR_PD']
        CN_PU = self.state['CN_PU']
        CR_PU = self.state['CR_PU']
        AL_PD = self.state['AL_PD']
        AL_PU = self.state['AL_PU']
        TH_PD = self.state['TH_PD']
        TR_PD = self.state['TR_PD']
        TH_PU = self.state['TH_PU']
        TR_PU = self.state['TR_PU']
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
        X_XD2 = self.state['X_XD2']
        X_XD3 = self.state['X_XD3']
        X_XL = self.state['X_XL']
        X_XM = self.state['X_XM']
        X_XN1 = self.state['X_XN1']
        X_XU = self.state['X_XU']
        X_XU3 = self.state['X_XU3']
        K_d1 = self.state['K_d1']
        L_d1_1 = self.state['L_d1_1']
        L_d1_2 = self.state['L_d1_2']
        L_d1_3 = self.state['L_d1_3']
        L_d1_4 = self.state['L_d1_4']
        F_d1 = self.state['F_d1']
        U_d1 = self.state['U_d1']
        P_d1 = self.state['P_d1']
        D_d1 = self.state['D_d1']
        K_d2 = self.state['K_d2']
        L_d2_2 = self.state['L_d2_2']
        F_d2 = self.state['F_d2']
        U_d2 = self.state['U_d2']
        P_d2 = self.state['P_d2']
        D_d2 = self.state['D_d2']
        K_d3 = self.state['K_d3']
        L_d3_1 = self.state['L_d3_1']
        L_d3_2 = self.state['L_d3_2']
        F_d3 = self.state['F_d3']
        U_d3 = self.state['U_d3']
        P_d3 = self.state['P_d3']
        D_d3 = self.state['D_d3']
        K_i1 = self.state['K_i1']
        L_i1_1 = self.state['L_i1_1']
        L_i1_2 = self.state['L_i1_2']
        F_i1 = self.state['F_i1']
        U_i1 = self.state['U_i1']
        P_i1 = self.state['P_i1']
        D_i1 = self.state['D_i1']
        K_i2 = self.state['K_i2']
        L_i2_1 = self.state['L_i2_1']
        L_i2_2 = self.state['L_i2_2']
        F_i2 = self.state['F_i2']
        U_i2 = self.state['U_i2']
        P_i2 = self.state['P_i2']
        D_i2 = self.state['D_i2']
        K_u2 = self.state['K_u2']
        L_u2_1 = self.state['L_u2_1']
        L_u2_2 = self.state['L_u2_2']
        L_u2_3 = self.state['L_u2_3']
        L_u2_4 = self.state['L_u2_4']
        F_u2 = self.state['F_u2']
        U_u2 = self.state['U_u2']
        P_u2 = self.state['P_u2']
        D_u2 = self.state['D_u2']
        K_u3_stub = self.state['K_u3_stub']
        L_u3_stub_2 = self.state['L_u3_stub_2']
        F_u3_stub = self.state['F_u3_stub']
        U_u3_stub = self.state['U_u3_stub']
        P_u3_stub = self.state['P_u3_stub']
        D_u3_stub = self.state['D_u3_stub']
        return {
            'YN_PD': bool(CN_PD),
            'YR_PD': bool(CR_PD),
            'YN_PU': bool(CN_PU),
            'YR_PU': bool(CR_PU),
            'YA_PD': bool(AL_PD),
            'YA_PU': bool(AL_PU),
            'YT_PD': bool(TR_PD),
            'YT_PU': bool(TR_PU),
            'YL_d1': bool(K_d1 or L_d1_1 or L_d1_2 or L_d1_3 or L_d1_4),
            'YL_d2': bool(K_d2 or L_d2_2),
            'YL_d3': bool(K_d3 or L_d3_1 or L_d3_2),
            'YL_i1': bool(K_i1 or L_i1_1 or L_i1_2),
            'YL_i2': bool(K_i2 or L_i2_1 or L_i2_2),
            'YL_u2': bool(K_u2 or L_u2_1 or L_u2_2 or L_u2_3 or L_u2_4),
            'YL_u3_stub': bool(K_u3_stub or L_u3_stub_2),
            'YP_XD2': bool(S_R1),
            'YS_XD2': bool((not S_R1)),
            'YP_XD3': bool(S_R2),
            'YS_XD3': bool((not S_R2)),
            'YP_XL': bool(S_R3),
            'YS_XL': bool((not S_R3)),
            'YP_XM': bool(S_R4 or S_R5),
            'YS_XM': bool((not (S_R4 or S_R5))),
            'YP_XN1': bool(S_R6),
            'YS_XN1': bool((not S_R6)),
            'YP_XU': bool(S_R7 or S_R8),
            'YS_XU': bool((not (S_R7 or S_R8))),
            'YP_XU3': bool(S_R9),
            'YS_XU3': bool((not S_R9)),
        }
