# Interlocking depot, made by interlock 0.1.0. Standard program, not certified.
# Not an F-program.
# layout a1dd5086f88a3c4e07e41bafac02e69ef9bc1f073b46421bb005360615e4d32b
# claims 8d3ae8a5be50c71ed2d2889f35476e150419aec2e679020571266945d6212251
"""Interlocking depot: call `Controller().scan(inputs, dt_ms)` once per cycle.

Inputs and outputs are dictionaries of names; a missing input takes its restrictive value.
"""

# name: (restrictive value, number of values), meaning
INPUTS = {
    'VALID': (0, 2),  # all input devices healthy
    'CAN_A1': (0, 2),  # operator: cancel the route from A1
    'CAN_A2': (0, 2),  # operator: cancel the route from A2
    'CAN_B1': (0, 2),  # operator: cancel the route from B1
    'CAN_E': (0, 2),  # operator: cancel the route from E
    'CAN_K1': (0, 2),  # operator: cancel the route from K1
    'CAN_K2': (0, 2),  # operator: cancel the route from K2
    'CAN_K3': (0, 2),  # operator: cancel the route from K3
    'CAN_W': (0, 2),  # operator: cancel the route from W
    'REQ': (0, 12),  # operator: set route number, 0 = none
    'CLR_ap': (0, 2),  # section ap reported clear
    'CLR_arr': (0, 2),  # section arr reported clear
    'CLR_brg': (0, 2),  # section brg reported clear
    'CLR_p1': (0, 2),  # section p1 reported clear
    'CLR_p2': (0, 2),  # section p2 reported clear
    'CLR_p3': (0, 2),  # section p3 reported clear
    'CLR_ph': (0, 2),  # section ph reported clear
    'CLR_sh1': (0, 2),  # section sh1 reported clear
    'CLR_sh2': (0, 2),  # section sh2 reported clear
    'CLR_sh3': (0, 2),  # section sh3 reported clear
    'CLR_sto': (0, 2),  # section sto reported clear
    'REL_arr': (0, 2),  # operator: release section arr (hold until released)
    'REL_brg': (0, 2),  # operator: release section brg (hold until released)
    'REL_p1': (0, 2),  # operator: release section p1 (hold until released)
    'REL_p2': (0, 2),  # operator: release section p2 (hold until released)
    'REL_p3': (0, 2),  # operator: release section p3 (hold until released)
    'REL_ph': (0, 2),  # operator: release section ph (hold until released)
    'REL_sh1': (0, 2),  # operator: release section sh1 (hold until released)
    'REL_sh2': (0, 2),  # operator: release section sh2 (hold until released)
    'REL_sh3': (0, 2),  # operator: release section sh3 (hold until released)
    'REL_sto': (0, 2),  # operator: release section sto (hold until released)
    'REL_wsh': (0, 2),  # operator: release section wsh (hold until released)
    'BLK_arr': (1, 2),  # operator: section arr is blocked
    'BLK_brg': (1, 2),  # operator: section brg is blocked
    'BLK_p1': (1, 2),  # operator: section p1 is blocked
    'BLK_p2': (1, 2),  # operator: section p2 is blocked
    'BLK_p3': (1, 2),  # operator: section p3 is blocked
    'BLK_ph': (1, 2),  # operator: section ph is blocked
    'BLK_sh1': (1, 2),  # operator: section sh1 is blocked
    'BLK_sh2': (1, 2),  # operator: section sh2 is blocked
    'BLK_sh3': (1, 2),  # operator: section sh3 is blocked
    'BLK_wsh': (1, 2),  # operator: section wsh is blocked
    'RELALL': (0, 2),  # operator: release all clear sections after a restart
    'DN_BRIDGE': (0, 2),  # machine BRIDGE detected open
    'DR_BRIDGE': (0, 2),  # machine BRIDGE detected closed
    'MN_BRIDGE': (0, 2),  # operator: move machine BRIDGE open
    'MR_BRIDGE': (0, 2),  # operator: move machine BRIDGE closed
    'DN_D1': (0, 2),  # machine D1 detected on
    'DR_D1': (0, 2),  # machine D1 detected off
    'MN_D1': (0, 2),  # operator: move machine D1 on
    'MR_D1': (0, 2),  # operator: move machine D1 off
    'TC_D1': (0, 2),  # operator: machine D1 has been looked at after it was trailed
    'DN_D2': (0, 2),  # machine D2 detected on
    'DR_D2': (0, 2),  # machine D2 detected off
    'MN_D2': (0, 2),  # operator: move machine D2 on
    'MR_D2': (0, 2),  # operator: move machine D2 off
    'TC_D2': (0, 2),  # operator: machine D2 has been looked at after it was trailed
    'DN_D3': (0, 2),  # machine D3 detected on
    'DR_D3': (0, 2),  # machine D3 detected off
    'MN_D3': (0, 2),  # operator: move machine D3 on
    'MR_D3': (0, 2),  # operator: move machine D3 off
    'TC_D3': (0, 2),  # operator: machine D3 has been looked at after it was trailed
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
    'DN_PH': (0, 2),  # machine PH detected locked by its key
    'DR_PH': (0, 2),  # machine PH detected released by its key
    'MN_PH': (0, 2),  # operator: move machine PH locked by its key
    'MR_PH': (0, 2),  # operator: move machine PH released by its key
}
# name: value at a restart, meaning
STATE = {
    'CN_BRIDGE': False,  # machine BRIDGE commanded N
    'CR_BRIDGE': False,  # machine BRIDGE commanded R
    'CN_D1': False,  # machine D1 commanded N
    'CR_D1': False,  # machine D1 commanded R
    'CN_D2': False,  # machine D2 commanded N
    'CR_D2': False,  # machine D2 commanded R
    'CN_D3': False,  # machine D3 commanded N
    'CR_D3': False,  # machine D3 commanded R
    'CN_P1': False,  # machine P1 commanded N
    'CR_P1': False,  # machine P1 commanded R
    'CN_P2': False,  # machine P2 commanded N
    'CR_P2': False,  # machine P2 commanded R
    'CN_P3': False,  # machine P3 commanded N
    'CR_P3': False,  # machine P3 commanded R
    'CN_PH': False,  # machine PH commanded N
    'CR_PH': False,  # machine PH commanded R
    'AL_BRIDGE': False,  # alarm: machine BRIDGE not detected
    'AL_D1': False,  # alarm: machine D1 not detected
    'AL_D2': False,  # alarm: machine D2 not detected
    'AL_D3': False,  # alarm: machine D3 not detected
    'AL_P1': False,  # alarm: machine P1 not detected
    'AL_P2': False,  # alarm: machine P2 not detected
    'AL_P3': False,  # alarm: machine P3 not detected
    'AL_PH': False,  # alarm: machine PH not detected
    'TH_D1': False,  # machine D1 was detected where it is commanded
    'TR_D1': False,  # machine D1 was trailed
    'TH_D2': False,  # machine D2 was detected where it is commanded
    'TR_D2': False,  # machine D2 was trailed
    'TH_D3': False,  # machine D3 was detected where it is commanded
    'TR_D3': False,  # machine D3 was trailed
    'TH_P1': False,  # machine P1 was detected where it is commanded
    'TR_P1': False,  # machine P1 was trailed
    'TH_P2': False,  # machine P2 was detected where it is commanded
    'TR_P2': False,  # machine P2 was trailed
    'TH_P3': False,  # machine P3 was detected where it is commanded
    'TR_P3': False,  # machine P3 was trailed
    'A_R1': False,  # route A1-B1.s active
    'B_R1': False,  # route A1-B1.s locked
    'W_R1': False,  # route A1-B1.s: proceed wanted
    'S_R1': False,  # route A1-B1.s: proceed
    'H_R1': False,  # route A1-B1.s: signal has been open
    'A_R2': False,  # route A2-LINE active
    'B_R2': False,  # route A2-LINE locked
    'W_R2': False,  # route A2-LINE: proceed wanted
    'S_R2': False,  # route A2-LINE: proceed
    'H_R2': False,  # route A2-LINE: signal has been open
    'A_R3': False,  # route B1-H1 active
    'B_R3': False,  # route B1-H1 locked
    'W_R3': False,  # route B1-H1: proceed wanted
    'S_R3': False,  # route B1-H1: proceed
    'H_R3': False,  # route B1-H1: signal has been open
    'A_R4': False,  # route B1-H2 active
    'B_R4': False,  # route B1-H2 locked
    'W_R4': False,  # route B1-H2: proceed wanted
    'S_R4': False,  # route B1-H2: proceed
    'H_R4': False,  # route B1-H2: signal has been open
    'A_R5': False,  # route B1-H3 active
    'B_R5': False,  # route B1-H3 locked
    'W_R5': False,  # route B1-H3: proceed wanted
    'S_R5': False,  # route B1-H3: proceed
    'H_R5': False,  # route B1-H3: signal has been open
    'A_R6': False,  # route B1-WASH active
    'B_R6': False,  # route B1-WASH locked
    'W_R6': False,  # route B1-WASH: proceed wanted
    'S_R6': False,  # route B1-WASH: proceed
    'H_R6': False,  # route B1-WASH: signal has been open
    'A_R7': False,  # route E-A1 active
    'B_R7': False,  # route E-A1 locked
    'W_R7': False,  # route E-A1: proceed wanted
    'S_R7': False,  # route E-A1: proceed
    'H_R7': False,  # route E-A1: signal has been open
    'A_R8': False,  # route K1-A2 active
    'B_R8': False,  # route K1-A2 locked
    'W_R8': False,  # route K1-A2: proceed wanted
    'S_R8': False,  # route K1-A2: proceed
    'H_R8': False,  # route K1-A2: signal has been open
    'A_R9': False,  # route K2-A2 active
    'B_R9': False,  # route K2-A2 locked
    'W_R9': False,  # route K2-A2: proceed wanted
    'S_R9': False,  # route K2-A2: proceed
    'H_R9': False,  # route K2-A2: signal has been open
    'A_R10': False,  # route K3-A2 active
    'B_R10': False,  # route K3-A2 locked
    'W_R10': False,  # route K3-A2: proceed wanted
    'S_R10': False,  # route K3-A2: proceed
    'H_R10': False,  # route K3-A2: signal has been open
    'A_R11': False,  # route W-A2 active
    'B_R11': False,  # route W-A2 locked
    'W_R11': False,  # route W-A2: proceed wanted
    'S_R11': False,  # route W-A2: proceed
    'H_R11': False,  # route W-A2: signal has been open
    'X_A1': False,  # A1: cancelling
    'X_A2': False,  # A2: cancelling
    'X_B1': False,  # B1: cancelling
    'X_E': False,  # E: cancelling
    'X_K1': False,  # K1: cancelling
    'X_K2': False,  # K2: cancelling
    'X_K3': False,  # K3: cancelling
    'X_W': False,  # W: cancelling
    'K_arr': True,  # arr: restart lock (R16)
    'L_arr_1': False,  # arr locked from LINE to arr|ph@PH.toe
    'L_arr_2': False,  # arr locked from arr|ph@PH.toe to LINE
    'M_arr': False,  # arr locked for a train movement
    'F_arr': False,  # arr firmly locked
    'U_arr': True,  # arr used by a train (R9)
    'P_arr': False,  # arr: the train went on (R9)
    'D_arr': False,  # arr: detection is not relied on, inputs were lost or a train is called on
    'K_brg': True,  # brg: restart lock (R16)
    'L_brg_1': False,  # brg locked from brg|p1@P1.toe to brg|ph@PH.normal
    'L_brg_2': False,  # brg locked from brg|ph@PH.normal to brg|p1@P1.toe
    'M_brg': False,  # brg locked for a train movement
    'F_brg': False,  # brg firmly locked
    'U_brg': True,  # brg used by a train (R9)
    'P_brg': False,  # brg: the train went on (R9)
    'D_brg': False,  # brg: detection is not relied on, inputs were lost or a train is called on
    'K_p1': True,  # p1: restart lock (R16)
    'L_p1_1': False,  # p1 locked from brg|p1@P1.toe to p1|p2@P1.normal
    'L_p1_2': False,  # p1 locked from brg|p1@P1.toe to p1|wsh@P1.reverse
    'L_p1_3': False,  # p1 locked from p1|p2@P1.normal to brg|p1@P1.toe
    'L_p1_4': False,  # p1 locked from p1|wsh@P1.reverse to brg|p1@P1.toe
    'M_p1': False,  # p1 locked for a train movement
    'F_p1': False,  # p1 firmly locked
    'U_p1': True,  # p1 used by a train (R9)
    'P_p1': False,  # p1: the train went on (R9)
    'D_p1': False,  # p1: detection is not relied on, inputs were lost or a train is called on
    'K_p2': True,  # p2: restart lock (R16)
    'L_p2_2': False,  # p2 locked from p1|p2@P1.normal to p2|p3@P2.normal
    'L_p2_3': False,  # p2 locked from p1|p2@P1.normal to p2|sh1@D1.outer
    'L_p2_4': False,  # p2 locked from p2|p3@P2.normal to p1|p2@P1.normal
    'L_p2_5': False,  # p2 locked from p2|sh1@D1.outer to p1|p2@P1.normal
    'M_p2': False,  # p2 locked for a train movement
    'F_p2': False,  # p2 firmly locked
    'U_p2': True,  # p2 used by a train (R9)
    'P_p2': False,  # p2: the train went on (R9)
    'D_p2': False,  # p2: detection is not relied on, inputs were lost or a train is called on
    'K_p3': True,  # p3: restart lock (R16)
    'L_p3_3': False,  # p3 locked from p2|p3@P2.normal to p3|sh2@D2.outer
    'L_p3_4': False,  # p3 locked from p2|p3@P2.normal to p3|sh3@D3.outer
    'L_p3_5': False,  # p3 locked from p3|sh2@D2.outer to p2|p3@P2.normal
    'L_p3_6': False,  # p3 locked from p3|sh3@D3.outer to p2|p3@P2.normal
    'M_p3': False,  # p3 locked for a train movement
    'F_p3': False,  # p3 firmly locked
    'U_p3': True,  # p3 used by a train (R9)
    'P_p3': False,  # p3: the train went on (R9)
    'D_p3': False,  # p3: detection is not relied on, inputs were lost or a train is called on
    'K_ph': True,  # ph: restart lock (R16)
    'L_ph_1': False,  # ph locked from arr|ph@PH.toe to brg|ph@PH.normal
    'L_ph_3': False,  # ph locked from brg|ph@PH.normal to arr|ph@PH.toe
    'M_ph': False,  # ph locked for a train movement
    'F_ph': False,  # ph firmly locked
    'U_ph': True,  # ph used by a train (R9)
    'P_ph': False,  # ph: the train went on (R9)
    'D_ph': False,  # ph: detection is not relied on, inputs were lost or a train is called on
    'K_sh1': True,  # sh1: restart lock (R16)
    'L_sh1_2': False,  # sh1 locked from p2|sh1@D1.outer to H1
    'M_sh1': False,  # sh1 locked for a train movement
    'F_sh1': False,  # sh1 firmly locked
    'U_sh1': True,  # sh1 used by a train (R9)
    'P_sh1': False,  # sh1: the train went on (R9)
    'D_sh1': False,  # sh1: detection is not relied on, inputs were lost or a train is called on
    'K_sh2': True,  # sh2: restart lock (R16)
    'L_sh2_2': False,  # sh2 locked from p3|sh2@D2.outer to H2
    'M_sh2': False,  # sh2 locked for a train movement
    'F_sh2': False,  # sh2 firmly locked
    'U_sh2': True,  # sh2 used by a train (R9)
    'P_sh2': False,  # sh2: the train went on (R9)
    'D_sh2': False,  # sh2: detection is not relied on, inputs were lost or a train is called on
    'K_sh3': True,  # sh3: restart lock (R16)
    'L_sh3_2': False,  # sh3 locked from p3|sh3@D3.outer to H3
    'M_sh3': False,  # sh3 locked for a train movement
    'F_sh3': False,  # sh3 firmly locked
    'U_sh3': True,  # sh3 used by a train (R9)
    'P_sh3': False,  # sh3: the train went on (R9)
    'D_sh3': False,  # sh3: detection is not relied on, inputs were lost or a train is called on
    'K_sto': True,  # sto: restart lock (R16)
    'M_sto': False,  # sto locked for a train movement
    'F_sto': False,  # sto firmly locked
    'U_sto': True,  # sto used by a train (R9)
    'P_sto': False,  # sto: the train went on (R9)
    'D_sto': False,  # sto: detection is not relied on, inputs were lost or a train is called on
    'K_wsh': True,  # wsh: restart lock (R16)
    'L_wsh_2': False,  # wsh locked from p1|wsh@P1.reverse to WASH
    'M_wsh': False,  # wsh locked for a train movement
    'F_wsh': False,  # wsh firmly locked
    'U_wsh': True,  # wsh used by a train (R9)
    'P_wsh': False,  # wsh: the train went on (R9)
    'D_wsh': False,  # wsh: detection is not relied on, inputs were lost or a train is called on
    'C_A2': False,  # A2 shows clear
    'C_E': False,  # E shows clear
}
# name: time in milliseconds, meaning
TIMERS = {
    'AT_A1': 180000,  # A1: approach locking delay (R8)
    'AT_A2': 180000,  # A2: approach locking delay (R8)
    'AT_B1': 30000,  # B1: approach locking delay (R8)
    'AT_E': 180000,  # E: approach locking delay (R8)
    'AT_K1': 30000,  # K1: approach locking delay (R8)
    'AT_K2': 30000,  # K2: approach locking delay (R8)
    'AT_K3': 30000,  # K3: approach locking delay (R8)
    'AT_W': 30000,  # W: approach locking delay (R8)
    'RT_arr': 3000,  # arr: release delay (R9)
    'RT_brg': 3000,  # brg: release delay (R9)
    'RT_p1': 3000,  # p1: release delay (R9)
    'RT_p2': 3000,  # p2: release delay (R9)
    'RT_p3': 3000,  # p3: release delay (R9)
    'RT_ph': 3000,  # ph: release delay (R9)
    'RT_sh1': 3000,  # sh1: release delay (R9)
    'RT_sh2': 3000,  # sh2: release delay (R9)
    'RT_sh3': 3000,  # sh3: release delay (R9)
    'RT_sto': 3000,  # sto: release delay (R9)
    'RT_wsh': 3000,  # wsh: release delay (R9)
    'ST_BRIDGE': 13000,  # machine BRIDGE: time-out
    'ST_D1': 13000,  # machine D1: time-out
    'ST_D2': 13000,  # machine D2: time-out
    'ST_D3': 13000,  # machine D3: time-out
    'ST_P1': 13000,  # machine P1: time-out
    'ST_P2': 13000,  # machine P2: time-out
    'ST_P3': 13000,  # machine P3: time-out
    'ST_PH': 13000,  # machine PH: time-out
}
# name: restrictive value, meaning
OUTPUTS = {
    'YN_BRIDGE': False,  # machine BRIDGE: open
    'YR_BRIDGE': False,  # machine BRIDGE: closed
    'YN_D1': False,  # machine D1: on
    'YR_D1': False,  # machine D1: off
    'YN_D2': False,  # machine D2: on
    'YR_D2': False,  # machine D2: off
    'YN_D3': False,  # machine D3: on
    'YR_D3': False,  # machine D3: off
    'YN_P1': False,  # machine P1: normal
    'YR_P1': False,  # machine P1: reverse
    'YN_P2': False,  # machine P2: normal
    'YR_P2': False,  # machine P2: reverse
    'YN_P3': False,  # machine P3: normal
    'YR_P3': False,  # machine P3: reverse
    'YN_PH': False,  # machine PH: locked by its key
    'YR_PH': False,  # machine PH: released by its key
    'YA_BRIDGE': False,  # alarm: machine BRIDGE not detected in time
    'YA_D1': False,  # alarm: machine D1 not detected in time
    'YA_D2': False,  # alarm: machine D2 not detected in time
    'YA_D3': False,  # alarm: machine D3 not detected in time
    'YA_P1': False,  # alarm: machine P1 not detected in time
    'YA_P2': False,  # alarm: machine P2 not detected in time
    'YA_P3': False,  # alarm: machine P3 not detected in time
    'YA_PH': False,  # alarm: machine PH not detected in time
    'YT_D1': False,  # alarm: machine D1 was trailed
    'YT_D2': False,  # alarm: machine D2 was trailed
    'YT_D3': False,  # alarm: machine D3 was trailed
    'YT_P1': False,  # alarm: machine P1 was trailed
    'YT_P2': False,  # alarm: machine P2 was trailed
    'YT_P3': False,  # alarm: machine P3 was trailed
    'YL_arr': True,  # indication: arr is locked
    'YL_brg': True,  # indication: brg is locked
    'YL_p1': True,  # indication: p1 is locked
    'YL_p2': True,  # indication: p2 is locked
    'YL_p3': True,  # indication: p3 is locked
    'YL_ph': True,  # indication: ph is locked
    'YL_sh1': True,  # indication: sh1 is locked
    'YL_sh2': True,  # indication: sh2 is locked
    'YL_sh3': True,  # indication: sh3 is locked
    'YL_sto': True,  # indication: sto is locked
    'YL_wsh': True,  # indication: wsh is locked
    'YP_A1': False,  # signal A1: clear (green)
    'YY_A1': False,  # signal A1: caution (yellow)
    'YW_A1': False,  # signal A1: shunt (white)
    'YS_A1': True,  # signal A1: stop
    'YP_A2': False,  # signal A2: clear (green)
    'YY_A2': False,  # signal A2: caution (yellow)
    'YW_A2': False,  # signal A2: shunt (white)
    'YS_A2': True,  # signal A2: stop
    'YW_B1': False,  # signal B1: shunt (white)
    'YS_B1': True,  # signal B1: stop
    'YP_E': False,  # signal E: clear (green)
    'YY_E': False,  # signal E: caution (yellow)
    'YS_E': True,  # signal E: stop
    'YW_K1': False,  # signal K1: shunt (white)
    'YS_K1': True,  # signal K1: stop
    'YW_K2': False,  # signal K2: shunt (white)
    'YS_K2': True,  # signal K2: stop
    'YW_K3': False,  # signal K3: shunt (white)
    'YS_K3': True,  # signal K3: stop
    'YW_W': False,  # signal W: shunt (white)
    'YS_W': True,  # signal W: stop
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
        CAN_A1 = read['CAN_A1']
        CAN_A2 = read['CAN_A2']
        CAN_B1 = read['CAN_B1']
        CAN_E = read['CAN_E']
        CAN_K1 = read['CAN_K1']
        CAN_K2 = read['CAN_K2']
        CAN_K3 = read['CAN_K3']
        CAN_W = read['CAN_W']
        REQ = read['REQ']
        CLR_ap = read['CLR_ap']
        CLR_arr = read['CLR_arr']
        CLR_brg = read['CLR_brg']
        CLR_p1 = read['CLR_p1']
        CLR_p2 = read['CLR_p2']
        CLR_p3 = read['CLR_p3']
        CLR_ph = read['CLR_ph']
        CLR_sh1 = read['CLR_sh1']
        CLR_sh2 = read['CLR_sh2']
        CLR_sh3 = read['CLR_sh3']
        CLR_sto = read['CLR_sto']
        REL_arr = read['REL_arr']
        REL_brg = read['REL_brg']
        REL_p1 = read['REL_p1']
        REL_p2 = read['REL_p2']
        REL_p3 = read['REL_p3']
        REL_ph = read['REL_ph']
        REL_sh1 = read['REL_sh1']
        REL_sh2 = read['REL_sh2']
        REL_sh3 = read['REL_sh3']
        REL_sto = read['REL_sto']
        REL_wsh = read['REL_wsh']
        BLK_arr = read['BLK_arr']
        BLK_brg = read['BLK_brg']
        BLK_p1 = read['BLK_p1']
        BLK_p2 = read['BLK_p2']
        BLK_p3 = read['BLK_p3']
        BLK_ph = read['BLK_ph']
        BLK_sh1 = read['BLK_sh1']
        BLK_sh2 = read['BLK_sh2']
        BLK_sh3 = read['BLK_sh3']
        BLK_wsh = read['BLK_wsh']
        RELALL = read['RELALL']
        DN_BRIDGE = read['DN_BRIDGE']
        DR_BRIDGE = read['DR_BRIDGE']
        MN_BRIDGE = read['MN_BRIDGE']
        MR_BRIDGE = read['MR_BRIDGE']
        DN_D1 = read['DN_D1']
        DR_D1 = read['DR_D1']
        MN_D1 = read['MN_D1']
        MR_D1 = read['MR_D1']
        TC_D1 = read['TC_D1']
        DN_D2 = read['DN_D2']
        DR_D2 = read['DR_D2']
        MN_D2 = read['MN_D2']
        MR_D2 = read['MR_D2']
        TC_D2 = read['TC_D2']
        DN_D3 = read['DN_D3']
        DR_D3 = read['DR_D3']
        MN_D3 = read['MN_D3']
        MR_D3 = read['MR_D3']
        TC_D3 = read['TC_D3']
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
        DN_PH = read['DN_PH']
        DR_PH = read['DR_PH']
        MN_PH = read['MN_PH']
        MR_PH = read['MR_PH']
        CN_BRIDGE = old['CN_BRIDGE']
        CR_BRIDGE = old['CR_BRIDGE']
        CN_D1 = old['CN_D1']
        CR_D1 = old['CR_D1']
        CN_D2 = old['CN_D2']
        CR_D2 = old['CR_D2']
        CN_D3 = old['CN_D3']
        CR_D3 = old['CR_D3']
        CN_P1 = old['CN_P1']
        CR_P1 = old['CR_P1']
        CN_P2 = old['CN_P2']
        CR_P2 = old['CR_P2']
        CN_P3 = old['CN_P3']
        CR_P3 = old['CR_P3']
        CN_PH = old['CN_PH']
        CR_PH = old['CR_PH']
        AL_BRIDGE = old['AL_BRIDGE']
        AL_D1 = old['AL_D1']
        AL_D2 = old['AL_D2']
        AL_D3 = old['AL_D3']
        AL_P1 = old['AL_P1']
        AL_P2 = old['AL_P2']
        AL_P3 = old['AL_P3']
        AL_PH = old['AL_PH']
        TH_D1 = old['TH_D1']
        TR_D1 = old['TR_D1']
        TH_D2 = old['TH_D2']
        TR_D2 = old['TR_D2']
        TH_D3 = old['TH_D3']
        TR_D3 = old['TR_D3']
        TH_P1 = old['TH_P1']
        TR_P1 = old['TR_P1']
        TH_P2 = old['TH_P2']
        TR_P2 = old['TR_P2']
        TH_P3 = old['TH_P3']
        TR_P3 = old['TR_P3']
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
        X_A1 = old['X_A1']
        X_A2 = old['X_A2']
        X_B1 = old['X_B1']
        X_E = old['X_E']
        X_K1 = old['X_K1']
        X_K2 = old['X_K2']
        X_K3 = old['X_K3']
        X_W = old['X_W']
        K_arr = old['K_arr']
        L_arr_1 = old['L_arr_1']
        L_arr_2 = old['L_arr_2']
        M_arr = old['M_arr']
        F_arr = old['F_arr']
        U_arr = old['U_arr']
        P_arr = old['P_arr']
        D_arr = old['D_arr']
        K_brg = old['K_brg']
        L_brg_1 = old['L_brg_1']
        L_brg_2 = old['L_brg_2']
        M_brg = old['M_brg']
        F_brg = old['F_brg']
        U_brg = old['U_brg']
        P_brg = old['P_brg']
        D_brg = old['D_brg']
        K_p1 = old['K_p1']
        L_p1_1 = old['L_p1_1']
        L_p1_2 = old['L_p1_2']
        L_p1_3 = old['L_p1_3']
        L_p1_4 = old['L_p1_4']
        M_p1 = old['M_p1']
        F_p1 = old['F_p1']
        U_p1 = old['U_p1']
        P_p1 = old['P_p1']
        D_p1 = old['D_p1']
        K_p2 = old['K_p2']
        L_p2_2 = old['L_p2_2']
        L_p2_3 = old['L_p2_3']
        L_p2_4 = old['L_p2_4']
        L_p2_5 = old['L_p2_5']
        M_p2 = old['M_p2']
        F_p2 = old['F_p2']
        U_p2 = old['U_p2']
        P_p2 = old['P_p2']
        D_p2 = old['D_p2']
        K_p3 = old['K_p3']
        L_p3_3 = old['L_p3_3']
        L_p3_4 = old['L_p3_4']
        L_p3_5 = old['L_p3_5']
        L_p3_6 = old['L_p3_6']
        M_p3 = old['M_p3']
        F_p3 = old['F_p3']
        U_p3 = old['U_p3']
        P_p3 = old['P_p3']
        D_p3 = old['D_p3']
        K_ph = old['K_ph']
        L_ph_1 = old['L_ph_1']
        L_ph_3 = old['L_ph_3']
        M_ph = old['M_ph']
        F_ph = old['F_ph']
        U_ph = old['U_ph']
        P_ph = old['P_ph']
        D_ph = old['D_ph']
        K_sh1 = old['K_sh1']
        L_sh1_2 = old['L_sh1_2']
        M_sh1 = old['M_sh1']
        F_sh1 = old['F_sh1']
        U_sh1 = old['U_sh1']
        P_sh1 = old['P_sh1']
        D_sh1 = old['D_sh1']
        K_sh2 = old['K_sh2']
        L_sh2_2 = old['L_sh2_2']
        M_sh2 = old['M_sh2']
        F_sh2 = old['F_sh2']
        U_sh2 = old['U_sh2']
        P_sh2 = old['P_sh2']
        D_sh2 = old['D_sh2']
        K_sh3 = old['K_sh3']
        L_sh3_2 = old['L_sh3_2']
        M_sh3 = old['M_sh3']
        F_sh3 = old['F_sh3']
        U_sh3 = old['U_sh3']
        P_sh3 = old['P_sh3']
        D_sh3 = old['D_sh3']
        K_sto = old['K_sto']
        M_sto = old['M_sto']
        F_sto = old['F_sto']
        U_sto = old['U_sto']
        P_sto = old['P_sto']
        D_sto = old['D_sto']
        K_wsh = old['K_wsh']
        L_wsh_2 = old['L_wsh_2']
        M_wsh = old['M_wsh']
        F_wsh = old['F_wsh']
        U_wsh = old['U_wsh']
        P_wsh = old['P_wsh']
        D_wsh = old['D_wsh']
        C_A2 = old['C_A2']
        C_E = old['C_E']
        OCC_ap = (not CLR_ap) or (not VALID)  # ap counts as occupied
        OCC_arr = (not CLR_arr) or (not VALID)  # arr counts as occupied
        OCC_brg = (not CLR_brg) or (not VALID)  # brg counts as occupied
        OCC_p1 = (not CLR_p1) or (not VALID)  # p1 counts as occupied
        OCC_p2 = (not CLR_p2) or (not VALID)  # p2 counts as occupied
        OCC_p3 = (not CLR_p3) or (not VALID)  # p3 counts as occupied
        OCC_ph = (not CLR_ph) or (not VALID)  # ph counts as occupied
        OCC_sh1 = (not CLR_sh1) or (not VALID)  # sh1 counts as occupied
        OCC_sh2 = (not CLR_sh2) or (not VALID)  # sh2 counts as occupied
        OCC_sh3 = (not CLR_sh3) or (not VALID)  # sh3 counts as occupied
        OCC_sto = (not CLR_sto) or (not VALID)  # sto counts as occupied
        FREE_arr = (not K_arr) and (not L_arr_1) and (not L_arr_2)  # arr is not locked by anybody
        FREE_brg = (not K_brg) and (not L_brg_1) and (not L_brg_2)  # brg is not locked by anybody
        FREE_p1 = (not K_p1) and (not L_p1_1) and (not L_p1_2) and (not L_p1_3) and (not L_p1_4)  # p1 is not locked by anybody
        FREE_p2 = (not K_p2) and (not L_p2_2) and (not L_p2_3) and (not L_p2_4) and (not L_p2_5)  # p2 is not locked by anybody
        FREE_p3 = (not K_p3) and (not L_p3_3) and (not L_p3_4) and (not L_p3_5) and (not L_p3_6)  # p3 is not locked by anybody
        FREE_ph = (not K_ph) and (not L_ph_1) and (not L_ph_3)  # ph is not locked by anybody
        FREE_sh1 = (not K_sh1) and (not L_sh1_2)  # sh1 is not locked by anybody
        FREE_sh2 = (not K_sh2) and (not L_sh2_2)  # sh2 is not locked by anybody
        FREE_sh3 = (not K_sh3) and (not L_sh3_2)  # sh3 is not locked by anybody
        FREE_sto = (not K_sto)  # sto is not locked by anybody
        FREE_wsh = (not K_wsh) and (not L_wsh_2)  # wsh is not locked by anybody
        QN_BRIDGE = VALID and DN_BRIDGE and (not DR_BRIDGE)  # machine BRIDGE lies N (R10)
        QR_BRIDGE = VALID and DR_BRIDGE and (not DN_BRIDGE)  # machine BRIDGE lies R (R10)
        QN_D1 = VALID and DN_D1 and (not DR_D1)  # machine D1 lies N (R10)
        QR_D1 = VALID and DR_D1 and (not DN_D1)  # machine D1 lies R (R10)
        QN_D2 = VALID and DN_D2 and (not DR_D2)  # machine D2 lies N (R10)
        QR_D2 = VALID and DR_D2 and (not DN_D2)  # machine D2 lies R (R10)
        QN_D3 = VALID and DN_D3 and (not DR_D3)  # machine D3 lies N (R10)
        QR_D3 = VALID and DR_D3 and (not DN_D3)  # machine D3 lies R (R10)
        QN_P1 = VALID and DN_P1 and (not DR_P1)  # machine P1 lies N (R10)
        QR_P1 = VALID and DR_P1 and (not DN_P1)  # machine P1 lies R (R10)
        QN_P2 = VALID and DN_P2 and (not DR_P2)  # machine P2 lies N (R10)
        QR_P2 = VALID and DR_P2 and (not DN_P2)  # machine P2 lies R (R10)
        QN_P3 = VALID and DN_P3 and (not DR_P3)  # machine P3 lies N (R10)
        QR_P3 = VALID and DR_P3 and (not DN_P3)  # machine P3 lies R (R10)
        QN_PH = VALID and DN_PH and (not DR_PH)  # machine PH lies N (R10)
        QR_PH = VALID and DR_PH and (not DN_PH)  # machine PH lies R (R10)
        MOV_BRIDGE = VALID and FREE_brg and (not OCC_brg) and True and True  # machine BRIDGE is free to move (R10)
        AVN_BRIDGE = CN_BRIDGE or MOV_BRIDGE or (QN_BRIDGE and (not CN_BRIDGE) and (not CR_BRIDGE))  # machine BRIDGE can be demanded N
        AVR_BRIDGE = CR_BRIDGE or MOV_BRIDGE or (QR_BRIDGE and (not CN_BRIDGE) and (not CR_BRIDGE))  # machine BRIDGE can be demanded R
        MOV_D1 = VALID and FREE_p2 and (not OCC_p2) and (not (L_p1_2 or L_p1_4 or L_p2_2 or L_p2_4)) and True  # machine D1 is free to move (R10)
        AVN_D1 = CN_D1 or MOV_D1 or (QN_D1 and (not CN_D1) and (not CR_D1))  # machine D1 can be demanded N
        AVR_D1 = CR_D1 or MOV_D1 or (QR_D1 and (not CN_D1) and (not CR_D1))  # machine D1 can be demanded R
        MOV_D2 = VALID and FREE_p3 and (not OCC_p3) and (not (L_p1_2 or L_p1_4 or L_p2_3 or L_p2_5 or L_p3_4 or L_p3_6)) and True  # machine D2 is free to move (R10)
        AVN_D2 = CN_D2 or MOV_D2 or (QN_D2 and (not CN_D2) and (not CR_D2))  # machine D2 can be demanded N
        AVR_D2 = CR_D2 or MOV_D2 or (QR_D2 and (not CN_D2) and (not CR_D2))  # machine D2 can be demanded R
        MOV_D3 = VALID and FREE_p3 and (not OCC_p3) and (not (L_p1_2 or L_p1_4 or L_p2_3 or L_p2_5 or L_p3_3 or L_p3_5)) and True  # machine D3 is free to move (R10)
        AVN_D3 = CN_D3 or MOV_D3 or (QN_D3 and (not CN_D3) and (not CR_D3))  # machine D3 can be demanded N
        AVR_D3 = CR_D3 or MOV_D3 or (QR_D3 and (not CN_D3) and (not CR_D3))  # machine D3 can be demanded R
        MOV_P1 = VALID and FREE_p1 and (not OCC_p1) and True and True  # machine P1 is free to move (R10)
        AVN_P1 = CN_P1 or MOV_P1 or (QN_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded N
        AVR_P1 = CR_P1 or MOV_P1 or (QR_P1 and (not CN_P1) and (not CR_P1))  # machine P1 can be demanded R
        MOV_P2 = VALID and FREE_p2 and (not OCC_p2) and True and True  # machine P2 is free to move (R10)
        AVN_P2 = CN_P2 or MOV_P2 or (QN_P2 and (not CN_P2) and (not CR_P2))  # machine P2 can be demanded N
        AVR_P2 = CR_P2 or MOV_P2 or (QR_P2 and (not CN_P2) and (not CR_P2))  # machine P2 can be demanded R
        MOV_P3 = VALID and FREE_p3 and (not OCC_p3) and True and True  # machine P3 is free to move (R10)
        AVN_P3 = CN_P3 or MOV_P3 or (QN_P3 and (not CN_P3) and (not CR_P3))  # machine P3 can be demanded N
        AVR_P3 = CR_P3 or MOV_P3 or (QR_P3 and (not CN_P3) and (not CR_P3))  # machine P3 can be demanded R
        MOV_PH = VALID and FREE_ph and (not OCC_ph) and True and True  # machine PH is free to move (R10)
        AVN_PH = CN_PH or MOV_PH or (QN_PH and (not CN_PH) and (not CR_PH))  # machine PH can be demanded N
        AVR_PH = CR_PH or MOV_PH or (QR_PH and (not CN_PH) and (not CR_PH))  # machine PH can be demanded R
        WF_arr_1 = FREE_arr and (not OCC_arr) and (not BLK_arr)  # arr from LINE to arr|ph@PH.toe: free for a route (R6)
        WF_arr_2 = FREE_arr and (not OCC_arr) and (not BLK_arr)  # arr from arr|ph@PH.toe to LINE: free for a route (R6)
        WA_brg_1 = AVR_BRIDGE  # brg from brg|p1@P1.toe to brg|ph@PH.normal: could be locked
        WF_brg_1 = FREE_brg and (not OCC_brg) and (not BLK_brg) and WA_brg_1  # brg from brg|p1@P1.toe to brg|ph@PH.normal: free for a route (R6)
        WA_brg_2 = AVR_BRIDGE  # brg from brg|ph@PH.normal to brg|p1@P1.toe: could be locked
        WF_brg_2 = FREE_brg and (not OCC_brg) and (not BLK_brg) and WA_brg_2  # brg from brg|ph@PH.normal to brg|p1@P1.toe: free for a route (R6)
        WA_p1_1 = AVN_P1 and (not TR_P1)  # p1 from brg|p1@P1.toe to p1|p2@P1.normal: could be locked
        WF_p1_1 = FREE_p1 and (not OCC_p1) and (not BLK_p1) and WA_p1_1  # p1 from brg|p1@P1.toe to p1|p2@P1.normal: free for a route (R6)
        WA_p1_2 = AVR_P1 and AVN_D2 and AVN_D3 and AVN_D1 and (not TR_P1) and (not TR_D2) and (not TR_D3) and (not TR_D1)  # p1 from brg|p1@P1.toe to p1|wsh@P1.reverse: could be locked
        WF_p1_2 = FREE_p1 and (not OCC_p1) and (not BLK_p1) and WA_p1_2  # p1 from brg|p1@P1.toe to p1|wsh@P1.reverse: free for a route (R6)
        WA_p1_3 = AVN_P1 and (not TR_P1)  # p1 from p1|p2@P1.normal to brg|p1@P1.toe: could be locked
        WF_p1_3 = FREE_p1 and (not OCC_p1) and (not BLK_p1) and WA_p1_3  # p1 from p1|p2@P1.normal to brg|p1@P1.toe: free for a route (R6)
        WA_p1_4 = AVR_P1 and AVN_D2 and AVN_D3 and AVN_D1 and (not TR_P1) and (not TR_D2) and (not TR_D3) and (not TR_D1)  # p1 from p1|wsh@P1.reverse to brg|p1@P1.toe: could be locked
        WF_p1_4 = FREE_p1 and (not OCC_p1) and (not BLK_p1) and WA_p1_4  # p1 from p1|wsh@P1.reverse to brg|p1@P1.toe: free for a route (R6)
        WA_p2_2 = AVN_P2 and AVN_D1 and (not TR_P2) and (not TR_D1)  # p2 from p1|p2@P1.normal to p2|p3@P2.normal: could be locked
        WF_p2_2 = FREE_p2 and (not OCC_p2) and (not BLK_p2) and WA_p2_2  # p2 from p1|p2@P1.normal to p2|p3@P2.normal: free for a route (R6)
        WA_p2_3 = AVR_P2 and AVR_D1 and AVN_D2 and AVN_D3 and (not TR_P2) and (not TR_D1) and (not TR_D2) and (not TR_D3)  # p2 from p1|p2@P1.normal to p2|sh1@D1.outer: could be locked
        WF_p2_3 = FREE_p2 and (not OCC_p2) and (not BLK_p2) and WA_p2_3  # p2 from p1|p2@P1.normal to p2|sh1@D1.outer: free for a route (R6)
        WA_p2_4 = AVN_P2 and AVN_D1 and (not TR_P2) and (not TR_D1)  # p2 from p2|p3@P2.normal to p1|p2@P1.normal: could be locked
        WF_p2_4 = FREE_p2 and (not OCC_p2) and (not BLK_p2) and WA_p2_4  # p2 from p2|p3@P2.normal to p1|p2@P1.normal: free for a route (R6)
        WA_p2_5 = AVR_D1 and AVR_P2 and AVN_D2 and AVN_D3 and (not TR_D1) and (not TR_P2) and (not TR_D2) and (not TR_D3)  # p2 from p2|sh1@D1.outer to p1|p2@P1.normal: could be locked
        WF_p2_5 = FREE_p2 and (not OCC_p2) and (not BLK_p2) and WA_p2_5  # p2 from p2|sh1@D1.outer to p1|p2@P1.normal: free for a route (R6)
        WA_p3_3 = AVN_P3 and AVR_D2 and AVN_D3 and (not TR_P3) and (not TR_D2) and (not TR_D3)  # p3 from p2|p3@P2.normal to p3|sh2@D2.outer: could be locked
        WF_p3_3 = FREE_p3 and (not OCC_p3) and (not BLK_p3) and WA_p3_3  # p3 from p2|p3@P2.normal to p3|sh2@D2.outer: free for a route (R6)
        WA_p3_4 = AVR_P3 and AVR_D3 and AVN_D2 and (not TR_P3) and (not TR_D3) and (not TR_D2)  # p3 from p2|p3@P2.normal to p3|sh3@D3.outer: could be locked
        WF_p3_4 = FREE_p3 and (not OCC_p3) and (not BLK_p3) and WA_p3_4  # p3 from p2|p3@P2.normal to p3|sh3@D3.outer: free for a route (R6)
        WA_p3_5 = AVR_D2 and AVN_P3 and AVN_D3 and (not TR_D2) and (not TR_P3) and (not TR_D3)  # p3 from p3|sh2@D2.outer to p2|p3@P2.normal: could be locked
        WF_p3_5 = FREE_p3 and (not OCC_p3) and (not BLK_p3) and WA_p3_5  # p3 from p3|sh2@D2.outer to p2|p3@P2.normal: free for a route (R6)
        WA_p3_6 = AVR_D3 and AVR_P3 and AVN_D2 and (not TR_D3) and (not TR_P3) and (not TR_D2)  # p3 from p3|sh3@D3.outer to p2|p3@P2.normal: could be locked
        WF_p3_6 = FREE_p3 and (not OCC_p3) and (not BLK_p3) and WA_p3_6  # p3 from p3|sh3@D3.outer to p2|p3@P2.normal: free for a route (R6)
        WA_ph_1 = AVN_PH  # ph from arr|ph@PH.toe to brg|ph@PH.normal: could be locked
        WF_ph_1 = FREE_ph and (not OCC_ph) and (not BLK_ph) and WA_ph_1  # ph from arr|ph@PH.toe to brg|ph@PH.normal: free for a route (R6)
        WA_ph_3 = AVN_PH  # ph from brg|ph@PH.normal to arr|ph@PH.toe: could be locked
        WF_ph_3 = FREE_ph and (not OCC_ph) and (not BLK_ph) and WA_ph_3  # ph from brg|ph@PH.normal to arr|ph@PH.toe: free for a route (R6)
        WL_arr_1 = (not OCC_arr)  # arr from LINE to arr|ph@PH.toe: lies and is clear
        WP_arr_1 = WL_arr_1 and (not BLK_arr)  # arr from LINE to arr|ph@PH.toe: proceed may be shown over it (R3)
        WL_arr_2 = (not OCC_arr)  # arr from arr|ph@PH.toe to LINE: lies and is clear
        WP_arr_2 = WL_arr_2 and (not BLK_arr)  # arr from arr|ph@PH.toe to LINE: proceed may be shown over it (R3)
        WD_brg_1 = QR_BRIDGE  # brg from brg|p1@P1.toe to brg|ph@PH.normal: its points lie, nothing is foul of it
        WL_brg_1 = (not OCC_brg) and WD_brg_1  # brg from brg|p1@P1.toe to brg|ph@PH.normal: lies and is clear
        WP_brg_1 = WL_brg_1 and (not BLK_brg)  # brg from brg|p1@P1.toe to brg|ph@PH.normal: proceed may be shown over it (R3)
        WD_brg_2 = QR_BRIDGE  # brg from brg|ph@PH.normal to brg|p1@P1.toe: its points lie, nothing is foul of it
        WL_brg_2 = (not OCC_brg) and WD_brg_2  # brg from brg|ph@PH.normal to brg|p1@P1.toe: lies and is clear
        WP_brg_2 = WL_brg_2 and (not BLK_brg)  # brg from brg|ph@PH.normal to brg|p1@P1.toe: proceed may be shown over it (R3)
        WD_p1_1 = QN_P1 and (not TR_P1)  # p1 from brg|p1@P1.toe to p1|p2@P1.normal: its points lie, nothing is foul of it
        WL_p1_1 = (not OCC_p1) and WD_p1_1  # p1 from brg|p1@P1.toe to p1|p2@P1.normal: lies and is clear
        WP_p1_1 = WL_p1_1 and (not BLK_p1)  # p1 from brg|p1@P1.toe to p1|p2@P1.normal: proceed may be shown over it (R3)
        WD_p1_2 = QR_P1 and QN_D2 and QN_D3 and QN_D1 and (not TR_P1) and (not TR_D2) and (not TR_D3) and (not TR_D1)  # p1 from brg|p1@P1.toe to p1|wsh@P1.reverse: its points lie, nothing is foul of it
        WL_p1_2 = (not OCC_p1) and WD_p1_2  # p1 from brg|p1@P1.toe to p1|wsh@P1.reverse: lies and is clear
        WP_p1_2 = WL_p1_2 and (not BLK_p1)  # p1 from brg|p1@P1.toe to p1|wsh@P1.reverse: proceed may be shown over it (R3)
        WD_p1_3 = QN_P1 and (not TR_P1)  # p1 from p1|p2@P1.normal to brg|p1@P1.toe: its points lie, nothing is foul of it
        WL_p1_3 = (not OCC_p1) and WD_p1_3  # p1 from p1|p2@P1.normal to brg|p1@P1.toe: lies and is clear
        WP_p1_3 = WL_p1_3 and (not BLK_p1)  # p1 from p1|p2@P1.normal to brg|p1@P1.toe: proceed may be shown over it (R3)
        WD_p1_4 = QR_P1 and QN_D2 and QN_D3 and QN_D1 and (not TR_P1) and (not TR_D2) and (not TR_D3) and (not TR_D1)  # p1 from p1|wsh@P1.reverse to brg|p1@P1.toe: its points lie, nothing is foul of it
        WL_p1_4 = (not OCC_p1) and WD_p1_4  # p1 from p1|wsh@P1.reverse to brg|p1@P1.toe: lies and is clear
        WP_p1_4 = WL_p1_4 and (not BLK_p1)  # p1 from p1|wsh@P1.reverse to brg|p1@P1.toe: proceed may be shown over it (R3)
        WD_p2_2 = QN_P2 and QN_D1 and (not TR_P2) and (not TR_D1)  # p2 from p1|p2@P1.normal to p2|p3@P2.normal: its points lie, nothing is foul of it
        WL_p2_2 = (not OCC_p2) and WD_p2_2  # p2 from p1|p2@P1.normal to p2|p3@P2.normal: lies and is clear
        WP_p2_2 = WL_p2_2 and (not BLK_p2)  # p2 from p1|p2@P1.normal to p2|p3@P2.normal: proceed may be shown over it (R3)
        WD_p2_3 = QR_P2 and QR_D1 and QN_D2 and QN_D3 and (not TR_P2) and (not TR_D1) and (not TR_D2) and (not TR_D3)  # p2 from p1|p2@P1.normal to p2|sh1@D1.outer: its points lie, nothing is foul of it
        WL_p2_3 = (not OCC_p2) and WD_p2_3  # p2 from p1|p2@P1.normal to p2|sh1@D1.outer: lies and is clear
        WP_p2_3 = WL_p2_3 and (not BLK_p2)  # p2 from p1|p2@P1.normal to p2|sh1@D1.outer: proceed may be shown over it (R3)
        WD_p2_4 = QN_P2 and QN_D1 and (not TR_P2) and (not TR_D1)  # p2 from p2|p3@P2.normal to p1|p2@P1.normal: its points lie, nothing is foul of it
        WL_p2_4 = (not OCC_p2) and WD_p2_4  # p2 from p2|p3@P2.normal to p1|p2@P1.normal: lies and is clear
        WP_p2_4 = WL_p2_4 and (not BLK_p2)  # p2 from p2|p3@P2.normal to p1|p2@P1.normal: proceed may be shown over it (R3)
        WD_p2_5 = QR_D1 and QR_P2 and QN_D2 and QN_D3 and (not TR_D1) and (not TR_P2) and (not TR_D2) and (not TR_D3)  # p2 from p2|sh1@D1.outer to p1|p2@P1.normal: its points lie, nothing is foul of it
        WL_p2_5 = (not OCC_p2) and WD_p2_5  # p2 from p2|sh1@D1.outer to p1|p2@P1.normal: lies and is clear
        WP_p2_5 = WL_p2_5 and (not BLK_p2)  # p2 from p2|sh1@D1.outer to p1|p2@P1.normal: proceed may be shown over it (R3)
        WD_p3_3 = QN_P3 and QR_D2 and QN_D3 and (not TR_P3) and (not TR_D2) and (not TR_D3)  # p3 from p2|p3@P2.normal to p3|sh2@D2.outer: its points lie, nothing is foul of it
        WL_p3_3 = (not OCC_p3) and WD_p3_3  # p3 from p2|p3@P2.normal to p3|sh2@D2.outer: lies and is clear
        WP_p3_3 = WL_p3_3 and (not BLK_p3)  # p3 from p2|p3@P2.normal to p3|sh2@D2.outer: proceed may be shown over it (R3)
        WD_p3_4 = QR_P3 and QR_D3 and QN_D2 and (not TR_P3) and (not TR_D3) and (not TR_D2)  # p3 from p2|p3@P2.normal to p3|sh3@D3.outer: its points lie, nothing is foul of it
        WL_p3_4 = (not OCC_p3) and WD_p3_4  # p3 from p2|p3@P2.normal to p3|sh3@D3.outer: lies and is clear
        WP_p3_4 = WL_p3_4 and (not BLK_p3)  # p3 from p2|p3@P2.normal to p3|sh3@D3.outer: proceed may be shown over it (R3)
        WD_p3_5 = QR_D2 and QN_P3 and QN_D3 and (not TR_D2) and (not TR_P3) and (not TR_D3)  # p3 from p3|sh2@D2.outer to p2|p3@P2.normal: its points lie, nothing is foul of it
        WL_p3_5 = (not OCC_p3) and WD_p3_5  # p3 from p3|sh2@D2.outer to p2|p3@P2.normal: lies and is clear
        WP_p3_5 = WL_p3_5 and (not BLK_p3)  # p3 from p3|sh2@D2.outer to p2|p3@P2.normal: proceed may be shown over it (R3)
        WD_p3_6 = QR_D3 and QR_P3 and QN_D2 and (not TR_D3) and (not TR_P3) and (not TR_D2)  # p3 from p3|sh3@D3.outer to p2|p3@P2.normal: its points lie, nothing is foul of it
        WL_p3_6 = (not OCC_p3) and WD_p3_6  # p3 from p3|sh3@D3.outer to p2|p3@P2.normal: lies and is clear
        WP_p3_6 = WL_p3_6 and (not BLK_p3)  # p3 from p3|sh3@D3.outer to p2|p3@P2.normal: proceed may be shown over it (R3)
        WD_ph_1 = QN_PH  # ph from arr|ph@PH.toe to brg|ph@PH.normal: its points lie, nothing is foul of it
        WL_ph_1 = (not OCC_ph) and WD_ph_1  # ph from arr|ph@PH.toe to brg|ph@PH.normal: lies and is clear
        WP_ph_1 = WL_ph_1 and (not BLK_ph)  # ph from arr|ph@PH.toe to brg|ph@PH.normal: proceed may be shown over it (R3)
        WD_ph_3 = QN_PH  # ph from brg|ph@PH.normal to arr|ph@PH.toe: its points lie, nothing is foul of it
        WL_ph_3 = (not OCC_ph) and WD_ph_3  # ph from brg|ph@PH.normal to arr|ph@PH.toe: lies and is clear
        WP_ph_3 = WL_ph_3 and (not BLK_ph)  # ph from brg|ph@PH.normal to arr|ph@PH.toe: proceed may be shown over it (R3)
        WL_sh1_2 = (not OCC_sh1)  # sh1 from p2|sh1@D1.outer to H1: lies and is clear
        WL_sh2_2 = (not OCC_sh2)  # sh2 from p3|sh2@D2.outer to H2: lies and is clear
        WL_sh3_2 = (not OCC_sh3)  # sh3 from p3|sh3@D3.outer to H3: lies and is clear
        WL_wsh_2 = False  # wsh from p1|wsh@P1.reverse to WASH: lies and is clear
        G_R1 = (REQ == 1) and VALID and WF_ph_1 and WF_brg_2  # grant of route A1-B1.s (R6)
        G_R2 = (REQ == 2) and VALID and WF_arr_2  # grant of route A2-LINE (R6)
        G_R3 = (REQ == 3) and VALID and WF_p1_1 and WF_p2_3 and (not BLK_sh1) and (not M_sh1)  # grant of route B1-H1 (R6)
        G_R4 = (REQ == 4) and VALID and WF_p1_1 and WF_p2_2 and WF_p3_3 and (not BLK_sh2) and (not M_sh2)  # grant of route B1-H2 (R6)
        G_R5 = (REQ == 5) and VALID and WF_p1_1 and WF_p2_2 and WF_p3_4 and (not BLK_sh3) and (not M_sh3)  # grant of route B1-H3 (R6)
        G_R6 = (REQ == 6) and VALID and WF_p1_2 and (not BLK_wsh) and (not M_wsh)  # grant of route B1-WASH (R6)
        G_R7 = (REQ == 7) and VALID and WF_arr_1  # grant of route E-A1 (R6)
        G_R8 = (REQ == 8) and VALID and WF_p2_5 and WF_p1_3 and WF_brg_1 and WF_ph_3  # grant of route K1-A2 (R6)
        G_R9 = (REQ == 9) and VALID and WF_p3_5 and WF_p2_4 and WF_p1_3 and WF_brg_1 and WF_ph_3  # grant of route K2-A2 (R6)
        G_R10 = (REQ == 10) and VALID and WF_p3_6 and WF_p2_4 and WF_p1_3 and WF_brg_1 and WF_ph_3  # grant of route K3-A2 (R6)
        G_R11 = (REQ == 11) and VALID and WF_p1_4 and WF_brg_1 and WF_ph_3  # grant of route W-A2 (R6)
        GW_arr_1 = G_R7  # arr from LINE to arr|ph@PH.toe: granted
        GW_arr_2 = G_R2  # arr from arr|ph@PH.toe to LINE: granted
        GW_brg_1 = G_R8 or G_R9 or G_R10 or G_R11  # brg from brg|p1@P1.toe to brg|ph@PH.normal: granted
        GW_brg_2 = G_R1  # brg from brg|ph@PH.normal to brg|p1@P1.toe: granted
        GW_p1_1 = G_R3 or G_R4 or G_R5  # p1 from brg|p1@P1.toe to p1|p2@P1.normal: granted
        GW_p1_2 = G_R6  # p1 from brg|p1@P1.toe to p1|wsh@P1.reverse: granted
        GW_p1_3 = G_R8 or G_R9 or G_R10  # p1 from p1|p2@P1.normal to brg|p1@P1.toe: granted
        GW_p1_4 = G_R11  # p1 from p1|wsh@P1.reverse to brg|p1@P1.toe: granted
        GW_p2_2 = G_R4 or G_R5  # p2 from p1|p2@P1.normal to p2|p3@P2.normal: granted
        GW_p2_3 = G_R3  # p2 from p1|p2@P1.normal to p2|sh1@D1.outer: granted
        GW_p2_4 = G_R9 or G_R10  # p2 from p2|p3@P2.normal to p1|p2@P1.normal: granted
        GW_p2_5 = G_R8  # p2 from p2|sh1@D1.outer to p1|p2@P1.normal: granted
        GW_p3_3 = G_R4  # p3 from p2|p3@P2.normal to p3|sh2@D2.outer: granted
        GW_p3_4 = G_R5  # p3 from p2|p3@P2.normal to p3|sh3@D3.outer: granted
        GW_p3_5 = G_R9  # p3 from p3|sh2@D2.outer to p2|p3@P2.normal: granted
        GW_p3_6 = G_R10  # p3 from p3|sh3@D3.outer to p2|p3@P2.normal: granted
        GW_ph_1 = G_R1  # ph from arr|ph@PH.toe to brg|ph@PH.normal: granted
        GW_ph_3 = G_R8 or G_R9 or G_R10 or G_R11  # ph from brg|ph@PH.normal to arr|ph@PH.toe: granted
        GB_sh1_2 = G_R3  # sh1 from p2|sh1@D1.outer to H1: granted
        GB_sh2_2 = G_R4  # sh2 from p3|sh2@D2.outer to H2: granted
        GB_sh3_2 = G_R5  # sh3 from p3|sh3@D3.outer to H3: granted
        GB_wsh_2 = G_R6  # wsh from p1|wsh@P1.reverse to WASH: granted
        LK_R1 = A_R1 and (not B_R1) and VALID and (not X_A1) and (not CAN_A1) and WL_ph_1 and WL_brg_2  # route A1-B1.s becomes locked (R3)
        CO_R1 = VALID and WP_ph_1 and WP_brg_2 and (not D_ph)  # conditions of proceed for route A1-B1.s (R3)
        LK_R2 = A_R2 and (not B_R2) and VALID and (not X_A2) and (not CAN_A2) and WL_arr_2  # route A2-LINE becomes locked (R3)
        CO_R2 = VALID and WP_arr_2 and (not OCC_ap) and (not D_arr)  # conditions of proceed for route A2-LINE (R3)
        LK_R3 = A_R3 and (not B_R3) and VALID and (not X_B1) and (not CAN_B1) and WL_p1_1 and WL_p2_3  # route B1-H1 becomes locked (R3)
        CO_R3 = VALID and WP_p1_1 and WP_p2_3 and (not BLK_sh1) and (not D_p1)  # conditions of proceed for route B1-H1 (R3)
        LK_R4 = A_R4 and (not B_R4) and VALID and (not X_B1) and (not CAN_B1) and WL_p1_1 and WL_p2_2 and WL_p3_3  # route B1-H2 becomes locked (R3)
        CO_R4 = VALID and WP_p1_1 and WP_p2_2 and WP_p3_3 and (not BLK_sh2) and (not D_p1)  # conditions of proceed for route B1-H2 (R3)
        LK_R5 = A_R5 and (not B_R5) and VALID and (not X_B1) and (not CAN_B1) and WL_p1_1 and WL_p2_2 and WL_p3_4  # route B1-H3 becomes locked (R3)
        CO_R5 = VALID and WP_p1_1 and WP_p2_2 and WP_p3_4 and (not BLK_sh3) and (not D_p1)  # conditions of proceed for route B1-H3 (R3)
        LK_R6 = A_R6 and (not B_R6) and VALID and (not X_B1) and (not CAN_B1) and WL_p1_2  # route B1-WASH becomes locked (R3)
        CO_R6 = VALID and WP_p1_2 and (not BLK_wsh) and (not D_p1)  # conditions of proceed for route B1-WASH (R3)
        LK_R7 = A_R7 and (not B_R7) and VALID and (not X_E) and (not CAN_E) and WL_arr_1  # route E-A1 becomes locked (R3)
        CO_R7 = VALID and WP_arr_1 and (not D_arr)  # conditions of proceed for route E-A1 (R3)
        LK_R8 = A_R8 and (not B_R8) and VALID and (not X_K1) and (not CAN_K1) and WL_p2_5 and WL_p1_3 and WL_brg_1 and WL_ph_3  # route K1-A2 becomes locked (R3)
        CO_R8 = VALID and WP_p2_5 and WP_p1_3 and WP_brg_1 and WP_ph_3 and (not D_p2)  # conditions of proceed for route K1-A2 (R3)
        LK_R9 = A_R9 and (not B_R9) and VALID and (not X_K2) and (not CAN_K2) and WL_p3_5 and WL_p2_4 and WL_p1_3 and WL_brg_1 and WL_ph_3  # route K2-A2 becomes locked (R3)
        CO_R9 = VALID and WP_p3_5 and WP_p2_4 and WP_p1_3 and WP_brg_1 and WP_ph_3 and (not D_p3)  # conditions of proceed for route K2-A2 (R3)
        LK_R10 = A_R10 and (not B_R10) and VALID and (not X_K3) and (not CAN_K3) and WL_p3_6 and WL_p2_4 and WL_p1_3 and WL_brg_1 and WL_ph_3  # route K3-A2 becomes locked (R3)
        CO_R10 = VALID and WP_p3_6 and WP_p2_4 and WP_p1_3 and WP_brg_1 and WP_ph_3 and (not D_p3)  # conditions of proceed for route K3-A2 (R3)
        LK_R11 = A_R11 and (not B_R11) and VALID and (not X_W) and (not CAN_W) and WL_p1_4 and WL_brg_1 and WL_ph_3  # route W-A2 becomes locked (R3)
        CO_R11 = VALID and WP_p1_4 and WP_brg_1 and WP_ph_3 and (not D_p1)  # conditions of proceed for route W-A2 (R3)
        NU_arr_1 = VALID and F_arr and (not D_arr) and (not U_arr) and L_arr_1 and OCC_arr and OCC_ap  # a train comes into arr at LINE (R9)
        NU_arr_2 = VALID and F_arr and (not D_arr) and (not U_arr) and L_arr_2 and OCC_arr and OCC_ph  # a train comes into arr at arr|ph@PH.toe (R9)
        NU_brg_1 = VALID and F_brg and (not D_brg) and (not U_brg) and L_brg_1 and OCC_brg and OCC_p1 and U_p1 and (L_p1_3 or L_p1_4)  # a train comes into brg at brg|p1@P1.toe (R9)
        NU_brg_2 = VALID and F_brg and (not D_brg) and (not U_brg) and L_brg_2 and OCC_brg and OCC_ph and U_ph and L_ph_1  # a train comes into brg at brg|ph@PH.normal (R9)
        NU_p1_1 = VALID and F_p1 and (not D_p1) and (not U_p1) and (L_p1_1 or L_p1_2) and OCC_p1 and OCC_brg and ((not M_p1) or U_brg) and ((not M_p1) or L_brg_2)  # a train comes into p1 at brg|p1@P1.toe (R9)
        NU_p1_2 = VALID and F_p1 and (not D_p1) and (not U_p1) and L_p1_3 and OCC_p1 and OCC_p2 and U_p2 and (L_p2_4 or L_p2_5)  # a train comes into p1 at p1|p2@P1.normal (R9)
        NU_p1_3 = VALID and F_p1 and (not D_p1) and (not U_p1) and L_p1_4 and OCC_p1 and True and ((not M_p1) or U_wsh) and (not M_p1)  # a train comes into p1 at p1|wsh@P1.reverse (R9)
        NU_p2_2 = VALID and F_p2 and (not D_p2) and (not U_p2) and (L_p2_2 or L_p2_3) and OCC_p2 and OCC_p1 and U_p1 and L_p1_1  # a train comes into p2 at p1|p2@P1.normal (R9)
        NU_p2_3 = VALID and F_p2 and (not D_p2) and (not U_p2) and L_p2_4 and OCC_p2 and OCC_p3 and U_p3 and (L_p3_5 or L_p3_6)  # a train comes into p2 at p2|p3@P2.normal (R9)
        NU_p2_4 = VALID and F_p2 and (not D_p2) and (not U_p2) and L_p2_5 and OCC_p2 and OCC_sh1 and ((not M_p2) or U_sh1) and (not M_p2)  # a train comes into p2 at p2|sh1@D1.outer (R9)
        NU_p3_3 = VALID and F_p3 and (not D_p3) and (not U_p3) and (L_p3_3 or L_p3_4) and OCC_p3 and OCC_p2 and U_p2 and L_p2_2  # a train comes into p3 at p2|p3@P2.normal (R9)
        NU_p3_4 = VALID and F_p3 and (not D_p3) and (not U_p3) and L_p3_5 and OCC_p3 and OCC_sh2 and ((not M_p3) or U_sh2) and (not M_p3)  # a train comes into p3 at p3|sh2@D2.outer (R9)
        NU_p3_5 = VALID and F_p3 and (not D_p3) and (not U_p3) and L_p3_6 and OCC_p3 and OCC_sh3 and ((not M_p3) or U_sh3) and (not M_p3)  # a train comes into p3 at p3|sh3@D3.outer (R9)
        NU_ph_1 = VALID and F_ph and (not D_ph) and (not U_ph) and L_ph_1 and OCC_ph and OCC_arr  # a train comes into ph at arr|ph@PH.toe (R9)
        NU_ph_2 = VALID and F_ph and (not D_ph) and (not U_ph) and L_ph_3 and OCC_ph and OCC_brg and U_brg and L_brg_1  # a train comes into ph at brg|ph@PH.normal (R9)
        NU_sh1_2 = VALID and F_sh1 and (not D_sh1) and (not U_sh1) and L_sh1_2 and OCC_sh1 and OCC_p2 and U_p2 and L_p2_3  # a train comes into sh1 at p2|sh1@D1.outer (R9)
        NU_sh2_2 = VALID and F_sh2 and (not D_sh2) and (not U_sh2) and L_sh2_2 and OCC_sh2 and OCC_p3 and U_p3 and L_p3_3  # a train comes into sh2 at p3|sh2@D2.outer (R9)
        NU_sh3_2 = VALID and F_sh3 and (not D_sh3) and (not U_sh3) and L_sh3_2 and OCC_sh3 and OCC_p3 and U_p3 and L_p3_4  # a train comes into sh3 at p3|sh3@D3.outer (R9)
        NU_wsh_2 = VALID and F_wsh and (not D_wsh) and (not U_wsh) and L_wsh_2 and True and OCC_p1 and U_p1 and L_p1_2  # a train comes into wsh at p1|wsh@P1.reverse (R9)
        ATI_A1 = X_A1 or ((not A_R1) and L_ph_1 and REL_ph)  # A1 at stop, waiting for a train that may still come (R8)
        ATI_A2 = X_A2 or ((not A_R2) and L_arr_2 and (REL_arr or (L_arr_2 and U_arr and (not OCC_arr))))  # A2 at stop, waiting for a train that may still come (R8)
        ATI_B1 = X_B1 or ((not (A_R3 or A_R4 or A_R5 or A_R6)) and (L_p1_1 or L_p1_2) and (REL_p1 or (L_p1_2 and (not M_p1) and U_p1 and (not OCC_p1))))  # B1 at stop, waiting for a train that may still come (R8)
        ATI_E = X_E or ((not A_R7) and L_arr_1 and REL_arr)  # E at stop, waiting for a train that may still come (R8)
        ATI_K1 = X_K1 or ((not A_R8) and L_p2_5 and REL_p2)  # K1 at stop, waiting for a train that may still come (R8)
        ATI_K2 = X_K2 or ((not A_R9) and L_p3_5 and REL_p3)  # K2 at stop, waiting for a train that may still come (R8)
        ATI_K3 = X_K3 or ((not A_R10) and L_p3_6 and REL_p3)  # K3 at stop, waiting for a train that may still come (R8)
        ATI_W = X_W or ((not A_R11) and L_p1_4 and REL_p1)  # W at stop, waiting for a train that may still come (R8)
        AT_A1 = self._timer('AT_A1', ATI_A1, dt_ms)  # A1: approach locking delay (R8)
        AT_A2 = self._timer('AT_A2', ATI_A2, dt_ms)  # A2: approach locking delay (R8)
        AT_B1 = self._timer('AT_B1', ATI_B1, dt_ms)  # B1: approach locking delay (R8)
        AT_E = self._timer('AT_E', ATI_E, dt_ms)  # E: approach locking delay (R8)
        AT_K1 = self._timer('AT_K1', ATI_K1, dt_ms)  # K1: approach locking delay (R8)
        AT_K2 = self._timer('AT_K2', ATI_K2, dt_ms)  # K2: approach locking delay (R8)
        AT_K3 = self._timer('AT_K3', ATI_K3, dt_ms)  # K3: approach locking delay (R8)
        AT_W = self._timer('AT_W', ATI_W, dt_ms)  # W: approach locking delay (R8)
        CD_A1 = X_A1 and A_R1 and VALID and (not OCC_ph) and ((not OCC_arr) or AT_A1 or (not H_R1))  # the route from A1 is cancelled (R8)
        CD_A2 = X_A2 and A_R2 and VALID and (not OCC_arr) and ((not OCC_ph) or AT_A2 or (not H_R2))  # the route from A2 is cancelled (R8)
        CD_B1 = X_B1 and (A_R3 or A_R4 or A_R5 or A_R6) and VALID and (not OCC_p1) and ((not OCC_brg) or AT_B1 or (not (H_R3 or H_R4 or H_R5 or H_R6)))  # the route from B1 is cancelled (R8)
        CD_E = X_E and A_R7 and VALID and (not OCC_arr) and ((not OCC_ap) or AT_E or (not H_R7))  # the route from E is cancelled (R8)
        CD_K1 = X_K1 and A_R8 and VALID and (not OCC_p2) and ((not OCC_sh1) or AT_K1 or (not H_R8))  # the route from K1 is cancelled (R8)
        CD_K2 = X_K2 and A_R9 and VALID and (not OCC_p3) and ((not OCC_sh2) or AT_K2 or (not H_R9))  # the route from K2 is cancelled (R8)
        CD_K3 = X_K3 and A_R10 and VALID and (not OCC_p3) and ((not OCC_sh3) or AT_K3 or (not H_R10))  # the route from K3 is cancelled (R8)
        CD_W = X_W and A_R11 and VALID and (not OCC_p1) and (AT_W or (not H_R11))  # the route from W is cancelled (R8)
        EX_arr = P_arr or (L_arr_2 and ((not OCC_ph) or AT_A2))  # a train in arr leaves over a boundary, or has passed on
        RTI_arr = VALID and U_arr and (not OCC_arr) and EX_arr  # arr may be released behind the train (R9)
        EX_brg = P_brg  # a train in brg leaves over a boundary, or has passed on
        RTI_brg = VALID and U_brg and (not OCC_brg) and (not (L_brg_1 and (L_p1_3 or L_p1_4))) and (not (L_brg_2 and L_ph_1)) and EX_brg  # brg may be released behind the train (R9)
        EX_p1 = P_p1 or (L_p1_2 and (not M_p1) and ((not OCC_brg) or AT_B1))  # a train in p1 leaves over a boundary, or has passed on
        RTI_p1 = VALID and U_p1 and (not OCC_p1) and (not ((L_p1_1 or L_p1_2) and L_brg_2 and M_p1 and M_brg)) and (not (L_p1_3 and (L_p2_4 or L_p2_5))) and EX_p1  # p1 may be released behind the train (R9)
        EX_p2 = P_p2 or (L_p2_3 and (not M_p2) and OCC_sh1)  # a train in p2 leaves over a boundary, or has passed on
        RTI_p2 = VALID and U_p2 and (not OCC_p2) and (not ((L_p2_2 or L_p2_3) and L_p1_1)) and (not (L_p2_4 and (L_p3_5 or L_p3_6))) and EX_p2  # p2 may be released behind the train (R9)
        EX_p3 = P_p3 or (L_p3_3 and (not M_p3) and OCC_sh2) or (L_p3_4 and (not M_p3) and OCC_sh3)  # a train in p3 leaves over a boundary, or has passed on
        RTI_p3 = VALID and U_p3 and (not OCC_p3) and (not ((L_p3_3 or L_p3_4) and L_p2_2)) and EX_p3  # p3 may be released behind the train (R9)
        EX_ph = P_ph  # a train in ph leaves over a boundary, or has passed on
        RTI_ph = VALID and U_ph and (not OCC_ph) and (not (L_ph_3 and L_brg_1)) and EX_ph  # ph may be released behind the train (R9)
        EX_sh1 = P_sh1  # a train in sh1 leaves over a boundary, or has passed on
        RTI_sh1 = VALID and U_sh1 and (not OCC_sh1) and (not G_R3) and (not L_p2_3) and EX_sh1  # sh1 may be released behind the train (R9)
        EX_sh2 = P_sh2  # a train in sh2 leaves over a boundary, or has passed on
        RTI_sh2 = VALID and U_sh2 and (not OCC_sh2) and (not G_R4) and (not L_p3_3) and EX_sh2  # sh2 may be released behind the train (R9)
        EX_sh3 = P_sh3  # a train in sh3 leaves over a boundary, or has passed on
        RTI_sh3 = VALID and U_sh3 and (not OCC_sh3) and (not G_R5) and (not L_p3_4) and EX_sh3  # sh3 may be released behind the train (R9)
        EX_sto = P_sto  # a train in sto leaves over a boundary, or has passed on
        RTI_sto = VALID and U_sto and (not OCC_sto) and EX_sto  # sto may be released behind the train (R9)
        EX_wsh = P_wsh  # a train in wsh leaves over a boundary, or has passed on
        RTI_wsh = VALID and U_wsh and False and (not G_R6) and (not L_p1_2) and EX_wsh  # wsh may be released behind the train (R9)
        RT_arr = self._timer('RT_arr', RTI_arr, dt_ms)  # arr: release delay (R9)
        RT_brg = self._timer('RT_brg', RTI_brg, dt_ms)  # brg: release delay (R9)
        RT_p1 = self._timer('RT_p1', RTI_p1, dt_ms)  # p1: release delay (R9)
        RT_p2 = self._timer('RT_p2', RTI_p2, dt_ms)  # p2: release delay (R9)
        RT_p3 = self._timer('RT_p3', RTI_p3, dt_ms)  # p3: release delay (R9)
        RT_ph = self._timer('RT_ph', RTI_ph, dt_ms)  # ph: release delay (R9)
        RT_sh1 = self._timer('RT_sh1', RTI_sh1, dt_ms)  # sh1: release delay (R9)
        RT_sh2 = self._timer('RT_sh2', RTI_sh2, dt_ms)  # sh2: release delay (R9)
        RT_sh3 = self._timer('RT_sh3', RTI_sh3, dt_ms)  # sh3: release delay (R9)
        RT_sto = self._timer('RT_sto', RTI_sto, dt_ms)  # sto: release delay (R9)
        RT_wsh = self._timer('RT_wsh', RTI_wsh, dt_ms)  # wsh: release delay (R9)
        CA_arr = VALID and (not OCC_arr) and (not U_arr) and False  # the lock before arr was withdrawn (R8)
        HR_arr = VALID and (not OCC_arr) and REL_arr and (L_arr_1 or L_arr_2) and ((not L_arr_1) or ((not A_R7) and ((not OCC_ap) or AT_E))) and ((not L_arr_2) or ((not A_R2) and ((not OCC_ph) or AT_A2)))  # arr released by hand (R8, section fault release)
        SR_arr = VALID and (not OCC_arr) and K_arr and (REL_arr or RELALL)  # arr released after a restart (R16)
        RLS_arr = RT_arr or CA_arr or CD_E or CD_A2 or HR_arr or SR_arr  # arr is released
        CA_brg = VALID and (not OCC_brg) and (not U_brg) and (L_brg_1 or L_brg_2) and (not (L_brg_1 and (L_p1_3 or L_p1_4))) and (not (L_brg_2 and L_ph_1))  # the lock before brg was withdrawn (R8)
        HR_brg = VALID and (not OCC_brg) and (not (L_brg_1 and (L_p1_3 or L_p1_4))) and (not (L_brg_2 and L_ph_1)) and REL_brg and (L_brg_1 or L_brg_2)  # brg released by hand (R8, section fault release)
        SR_brg = VALID and (not OCC_brg) and K_brg and (REL_brg or RELALL)  # brg released after a restart (R16)
        RLS_brg = RT_brg or CA_brg or HR_brg or SR_brg  # brg is released
        CA_p1 = VALID and (not OCC_p1) and (not U_p1) and (((L_p1_1 or L_p1_2) and M_p1) or L_p1_3 or (L_p1_4 and M_p1)) and (not ((L_p1_1 or L_p1_2) and L_brg_2 and M_p1 and M_brg)) and (not (L_p1_3 and (L_p2_4 or L_p2_5)))  # the lock before p1 was withdrawn (R8)
        HR_p1 = VALID and (not OCC_p1) and (not ((L_p1_1 or L_p1_2) and L_brg_2 and M_p1 and M_brg)) and (not (L_p1_3 and (L_p2_4 or L_p2_5))) and REL_p1 and (L_p1_1 or L_p1_2 or L_p1_3 or L_p1_4) and ((not (L_p1_1 or L_p1_2)) or ((not (A_R3 or A_R4 or A_R5 or A_R6)) and ((not OCC_brg) or AT_B1))) and ((not L_p1_4) or ((not A_R11) and AT_W))  # p1 released by hand (R8, section fault release)
        SR_p1 = VALID and (not OCC_p1) and K_p1 and (REL_p1 or RELALL)  # p1 released after a restart (R16)
        RLS_p1 = RT_p1 or CA_p1 or CD_B1 or CD_W or HR_p1 or SR_p1  # p1 is released
        CA_p2 = VALID and (not OCC_p2) and (not U_p2) and (L_p2_2 or L_p2_3 or L_p2_4 or (L_p2_5 and M_p2)) and (not ((L_p2_2 or L_p2_3) and L_p1_1)) and (not (L_p2_4 and (L_p3_5 or L_p3_6)))  # the lock before p2 was withdrawn (R8)
        HR_p2 = VALID and (not OCC_p2) and (not ((L_p2_2 or L_p2_3) and L_p1_1)) and (not (L_p2_4 and (L_p3_5 or L_p3_6))) and REL_p2 and (L_p2_2 or L_p2_3 or L_p2_4 or L_p2_5) and ((not L_p2_5) or ((not A_R8) and ((not OCC_sh1) or AT_K1)))  # p2 released by hand (R8, section fault release)
        SR_p2 = VALID and (not OCC_p2) and K_p2 and (REL_p2 or RELALL)  # p2 released after a restart (R16)
        RLS_p2 = RT_p2 or CA_p2 or CD_K1 or HR_p2 or SR_p2  # p2 is released
        CA_p3 = VALID and (not OCC_p3) and (not U_p3) and (L_p3_3 or L_p3_4 or (L_p3_5 and M_p3) or (L_p3_6 and M_p3)) and (not ((L_p3_3 or L_p3_4) and L_p2_2))  # the lock before p3 was withdrawn (R8)
        HR_p3 = VALID and (not OCC_p3) and (not ((L_p3_3 or L_p3_4) and L_p2_2)) and REL_p3 and (L_p3_3 or L_p3_4 or L_p3_5 or L_p3_6) and ((not L_p3_5) or ((not A_R9) and ((not OCC_sh2) or AT_K2))) and ((not L_p3_6) or ((not A_R10) and ((not OCC_sh3) or AT_K3)))  # p3 released by hand (R8, section fault release)
        SR_p3 = VALID and (not OCC_p3) and K_p3 and (REL_p3 or RELALL)  # p3 released after a restart (R16)
        RLS_p3 = RT_p3 or CA_p3 or CD_K2 or CD_K3 or HR_p3 or SR_p3  # p3 is released
        CA_ph = VALID and (not OCC_ph) and (not U_ph) and L_ph_3 and (not (L_ph_3 and L_brg_1))  # the lock before ph was withdrawn (R8)
        HR_ph = VALID and (not OCC_ph) and (not (L_ph_3 and L_brg_1)) and REL_ph and (L_ph_1 or L_ph_3) and ((not L_ph_1) or ((not A_R1) and ((not OCC_arr) or AT_A1)))  # ph released by hand (R8, section fault release)
        SR_ph = VALID and (not OCC_ph) and K_ph and (REL_ph or RELALL)  # ph released after a restart (R16)
        RLS_ph = RT_ph or CA_ph or CD_A1 or HR_ph or SR_ph  # ph is released
        AR_sh1 = VALID and U_sh1 and (not G_R3) and (not L_p2_3)  # a train has arrived in sh1, wholly (R2)
        CA_sh1 = VALID and (not OCC_sh1) and (not U_sh1) and L_sh1_2 and (not G_R3) and (not L_p2_3)  # the lock before sh1 was withdrawn (R8)
        HR_sh1 = VALID and (not OCC_sh1) and (not G_R3) and (not L_p2_3) and REL_sh1 and L_sh1_2  # sh1 released by hand (R8, section fault release)
        SR_sh1 = VALID and (not OCC_sh1) and K_sh1 and (REL_sh1 or RELALL) and (not G_R3) and (not L_p2_3)  # sh1 released after a restart (R16)
        RLS_sh1 = RT_sh1 or CA_sh1 or HR_sh1 or SR_sh1  # sh1 is released
        AR_sh2 = VALID and U_sh2 and (not G_R4) and (not L_p3_3)  # a train has arrived in sh2, wholly (R2)
        CA_sh2 = VALID and (not OCC_sh2) and (not U_sh2) and L_sh2_2 and (not G_R4) and (not L_p3_3)  # the lock before sh2 was withdrawn (R8)
        HR_sh2 = VALID and (not OCC_sh2) and (not G_R4) and (not L_p3_3) and REL_sh2 and L_sh2_2  # sh2 released by hand (R8, section fault release)
        SR_sh2 = VALID and (not OCC_sh2) and K_sh2 and (REL_sh2 or RELALL) and (not G_R4) and (not L_p3_3)  # sh2 released after a restart (R16)
        RLS_sh2 = RT_sh2 or CA_sh2 or HR_sh2 or SR_sh2  # sh2 is released
        AR_sh3 = VALID and U_sh3 and (not G_R5) and (not L_p3_4)  # a train has arrived in sh3, wholly (R2)
        CA_sh3 = VALID and (not OCC_sh3) and (not U_sh3) and L_sh3_2 and (not G_R5) and (not L_p3_4)  # the lock before sh3 was withdrawn (R8)
        HR_sh3 = VALID and (not OCC_sh3) and (not G_R5) and (not L_p3_4) and REL_sh3 and L_sh3_2  # sh3 released by hand (R8, section fault release)
        SR_sh3 = VALID and (not OCC_sh3) and K_sh3 and (REL_sh3 or RELALL) and (not G_R5) and (not L_p3_4)  # sh3 released after a restart (R16)
        RLS_sh3 = RT_sh3 or CA_sh3 or HR_sh3 or SR_sh3  # sh3 is released
        CA_sto = VALID and (not OCC_sto) and (not U_sto) and False  # the lock before sto was withdrawn (R8)
        HR_sto = VALID and (not OCC_sto) and REL_sto and False  # sto released by hand (R8, section fault release)
        SR_sto = VALID and (not OCC_sto) and K_sto and (REL_sto or RELALL)  # sto released after a restart (R16)
        RLS_sto = RT_sto or CA_sto or HR_sto or SR_sto  # sto is released
        AR_wsh = VALID and U_wsh and (not G_R6) and (not L_p1_2)  # a train has arrived in wsh, wholly (R2)
        CA_wsh = VALID and False and (not U_wsh) and L_wsh_2 and (not G_R6) and (not L_p1_2)  # the lock before wsh was withdrawn (R8)
        HR_wsh = VALID and False and (not G_R6) and (not L_p1_2) and REL_wsh and L_wsh_2  # wsh released by hand (R8, section fault release)
        SR_wsh = VALID and False and K_wsh and (REL_wsh or RELALL) and (not G_R6) and (not L_p1_2)  # wsh released after a restart (R16)
        RLS_wsh = RT_wsh or CA_wsh or HR_wsh or SR_wsh  # wsh is released
        TG_BRIDGE = (GW_brg_1 or GW_brg_2)  # a grant touches machine BRIDGE in this scan
        GPN_BRIDGE = False or (MOV_BRIDGE and (not TG_BRIDGE) and (not MR_BRIDGE))  # a grant needs BRIDGE N
        MAN_BRIDGE = MN_BRIDGE and (not MR_BRIDGE) and MOV_BRIDGE and (not TG_BRIDGE)  # machine BRIDGE moved N by hand
        GPR_BRIDGE = (GW_brg_1 or GW_brg_2)  # a grant needs BRIDGE R
        MAR_BRIDGE = MR_BRIDGE and (not MN_BRIDGE) and MOV_BRIDGE and (not TG_BRIDGE)  # machine BRIDGE moved R by hand
        HDN_BRIDGE = CN_BRIDGE and (not GPR_BRIDGE) and (not MAR_BRIDGE)  # the command N stays
        HDR_BRIDGE = CR_BRIDGE and (not GPN_BRIDGE) and (not MAN_BRIDGE)  # the command R stays
        TG_D1 = (GW_p1_2 or GW_p1_4 or GW_p2_2 or GW_p2_3 or GW_p2_4 or GW_p2_5)  # a grant touches machine D1 in this scan
        GPN_D1 = (GW_p1_2 or GW_p1_4 or GW_p2_2 or GW_p2_4)  # a grant needs D1 N
        MAN_D1 = MN_D1 and (not MR_D1) and MOV_D1 and (not TG_D1)  # machine D1 moved N by hand
        GPR_D1 = (GW_p2_3 or GW_p2_5)  # a grant needs D1 R
        MAR_D1 = MR_D1 and (not MN_D1) and MOV_D1 and (not TG_D1)  # machine D1 moved R by hand
        HDN_D1 = CN_D1 and (not GPR_D1) and (not MAR_D1)  # the command N stays
        HDR_D1 = CR_D1 and (not GPN_D1) and (not MAN_D1)  # the command R stays
        TG_D2 = (GW_p1_2 or GW_p1_4 or GW_p2_3 or GW_p2_5 or GW_p3_3 or GW_p3_4 or GW_p3_5 or GW_p3_6)  # a grant touches machine D2 in this scan
        GPN_D2 = (GW_p1_2 or GW_p1_4 or GW_p2_3 or GW_p2_5 or GW_p3_4 or GW_p3_6)  # a grant needs D2 N
        MAN_D2 = MN_D2 and (not MR_D2) and MOV_D2 and (not TG_D2)  # machine D2 moved N by hand
        GPR_D2 = (GW_p3_3 or GW_p3_5)  # a grant needs D2 R
        MAR_D2 = MR_D2 and (not MN_D2) and MOV_D2 and (not TG_D2)  # machine D2 moved R by hand
        HDN_D2 = CN_D2 and (not GPR_D2) and (not MAR_D2)  # the command N stays
        HDR_D2 = CR_D2 and (not GPN_D2) and (not MAN_D2)  # the command R stays
        TG_D3 = (GW_p1_2 or GW_p1_4 or GW_p2_3 or GW_p2_5 or GW_p3_3 or GW_p3_4 or GW_p3_5 or GW_p3_6)  # a grant touches machine D3 in this scan
        GPN_D3 = (GW_p1_2 or GW_p1_4 or GW_p2_3 or GW_p2_5 or GW_p3_3 or GW_p3_5)  # a grant needs D3 N
        MAN_D3 = MN_D3 and (not MR_D3) and MOV_D3 and (not TG_D3)  # machine D3 moved N by hand
        GPR_D3 = (GW_p3_4 or GW_p3_6)  # a grant needs D3 R
        MAR_D3 = MR_D3 and (not MN_D3) and MOV_D3 and (not TG_D3)  # machine D3 moved R by hand
        HDN_D3 = CN_D3 and (not GPR_D3) and (not MAR_D3)  # the command N stays
        HDR_D3 = CR_D3 and (not GPN_D3) and (not MAN_D3)  # the command R stays
        TG_P1 = (GW_p1_1 or GW_p1_2 or GW_p1_3 or GW_p1_4)  # a grant touches machine P1 in this scan
        GPN_P1 = (GW_p1_1 or GW_p1_3)  # a grant needs P1 N
        MAN_P1 = MN_P1 and (not MR_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved N by hand
        GPR_P1 = (GW_p1_2 or GW_p1_4)  # a grant needs P1 R
        MAR_P1 = MR_P1 and (not MN_P1) and MOV_P1 and (not TG_P1)  # machine P1 moved R by hand
        HDN_P1 = CN_P1 and (not GPR_P1) and (not MAR_P1)  # the command N stays
        HDR_P1 = CR_P1 and (not GPN_P1) and (not MAN_P1)  # the command R stays
        TG_P2 = (GW_p2_2 or GW_p2_3 or GW_p2_4 or GW_p2_5)  # a grant touches machine P2 in this scan
        GPN_P2 = (GW_p2_2 or GW_p2_4)  # a grant needs P2 N
        MAN_P2 = MN_P2 and (not MR_P2) and MOV_P2 and (not TG_P2)  # machine P2 moved N by hand
        GPR_P2 = (GW_p2_3 or GW_p2_5)  # a grant needs P2 R
        MAR_P2 = MR_P2 and (not MN_P2) and MOV_P2 and (not TG_P2)  # machine P2 moved R by hand
        HDN_P2 = CN_P2 and (not GPR_P2) and (not MAR_P2)  # the command N stays
        HDR_P2 = CR_P2 and (not GPN_P2) and (not MAN_P2)  # the command R stays
        TG_P3 = (GW_p3_3 or GW_p3_4 or GW_p3_5 or GW_p3_6)  # a grant touches machine P3 in this scan
        GPN_P3 = (GW_p3_3 or GW_p3_5)  # a grant needs P3 N
        MAN_P3 = MN_P3 and (not MR_P3) and MOV_P3 and (not TG_P3)  # machine P3 moved N by hand
        GPR_P3 = (GW_p3_4 or GW_p3_6)  # a grant needs P3 R
        MAR_P3 = MR_P3 and (not MN_P3) and MOV_P3 and (not TG_P3)  # machine P3 moved R by hand
        HDN_P3 = CN_P3 and (not GPR_P3) and (not MAR_P3)  # the command N stays
        HDR_P3 = CR_P3 and (not GPN_P3) and (not MAN_P3)  # the command R stays
        TG_PH = (GW_ph_1 or GW_ph_3)  # a grant touches machine PH in this scan
        GPN_PH = (GW_ph_1 or GW_ph_3)  # a grant needs PH N
        MAN_PH = MN_PH and (not MR_PH) and MOV_PH and (not TG_PH)  # machine PH moved N by hand
        GPR_PH = False  # a grant needs PH R
        MAR_PH = MR_PH and (not MN_PH) and MOV_PH and (not TG_PH)  # machine PH moved R by hand
        HDN_PH = CN_PH and (not GPR_PH) and (not MAR_PH)  # the command N stays
        HDR_PH = CR_PH and (not GPN_PH) and (not MAN_PH)  # the command R stays
        STI_BRIDGE = (CN_BRIDGE and (not QN_BRIDGE)) or (CR_BRIDGE and (not QR_BRIDGE))  # machine BRIDGE is not where it was commanded
        STI_D1 = (CN_D1 and (not QN_D1)) or (CR_D1 and (not QR_D1))  # machine D1 is not where it was commanded
        STI_D2 = (CN_D2 and (not QN_D2)) or (CR_D2 and (not QR_D2))  # machine D2 is not where it was commanded
        STI_D3 = (CN_D3 and (not QN_D3)) or (CR_D3 and (not QR_D3))  # machine D3 is not where it was commanded
        STI_P1 = (CN_P1 and (not QN_P1)) or (CR_P1 and (not QR_P1))  # machine P1 is not where it was commanded
        STI_P2 = (CN_P2 and (not QN_P2)) or (CR_P2 and (not QR_P2))  # machine P2 is not where it was commanded
        STI_P3 = (CN_P3 and (not QN_P3)) or (CR_P3 and (not QR_P3))  # machine P3 is not where it was commanded
        STI_PH = (CN_PH and (not QN_PH)) or (CR_PH and (not QR_PH))  # machine PH is not where it was commanded
        ST_BRIDGE = self._timer('ST_BRIDGE', STI_BRIDGE, dt_ms)  # machine BRIDGE: time-out
        ST_D1 = self._timer('ST_D1', STI_D1, dt_ms)  # machine D1: time-out
        ST_D2 = self._timer('ST_D2', STI_D2, dt_ms)  # machine D2: time-out
        ST_D3 = self._timer('ST_D3', STI_D3, dt_ms)  # machine D3: time-out
        ST_P1 = self._timer('ST_P1', STI_P1, dt_ms)  # machine P1: time-out
        ST_P2 = self._timer('ST_P2', STI_P2, dt_ms)  # machine P2: time-out
        ST_P3 = self._timer('ST_P3', STI_P3, dt_ms)  # machine P3: time-out
        ST_PH = self._timer('ST_PH', STI_PH, dt_ms)  # machine PH: time-out
        KP_R1 = (not NU_ph_1) and (not CD_A1)  # route A1-B1.s stays set
        PR_R1 = A_R1 and B_R1 and W_R1 and CO_R1 and KP_R1 and (not X_A1) and (not CAN_A1)  # proceed for route A1-B1.s (R3, R11)
        LS_R1 = S_R1 and (not CO_R1)  # route A1-B1.s: a condition was lost; no reopening by itself (R14)
        KP_R2 = (not NU_arr_2) and (not CD_A2)  # route A2-LINE stays set
        PR_R2 = A_R2 and B_R2 and W_R2 and CO_R2 and KP_R2 and (not X_A2) and (not CAN_A2)  # proceed for route A2-LINE (R3, R11)
        LS_R2 = S_R2 and (not CO_R2)  # route A2-LINE: a condition was lost; no reopening by itself (R14)
        KP_R3 = (not NU_p1_1) and (not CD_B1)  # route B1-H1 stays set
        PR_R3 = A_R3 and B_R3 and W_R3 and CO_R3 and KP_R3 and (not X_B1) and (not CAN_B1)  # proceed for route B1-H1 (R3, R11)
        LS_R3 = S_R3 and (not CO_R3)  # route B1-H1: a condition was lost; no reopening by itself (R14)
        KP_R4 = (not NU_p1_1) and (not CD_B1)  # route B1-H2 stays set
        PR_R4 = A_R4 and B_R4 and W_R4 and CO_R4 and KP_R4 and (not X_B1) and (not CAN_B1)  # proceed for route B1-H2 (R3, R11)
        LS_R4 = S_R4 and (not CO_R4)  # route B1-H2: a condition was lost; no reopening by itself (R14)
        KP_R5 = (not NU_p1_1) and (not CD_B1)  # route B1-H3 stays set
        PR_R5 = A_R5 and B_R5 and W_R5 and CO_R5 and KP_R5 and (not X_B1) and (not CAN_B1)  # proceed for route B1-H3 (R3, R11)
        LS_R5 = S_R5 and (not CO_R5)  # route B1-H3: a condition was lost; no reopening by itself (R14)
        KP_R6 = (not NU_p1_1) and (not CD_B1)  # route B1-WASH stays set
        PR_R6 = A_R6 and B_R6 and W_R6 and CO_R6 and KP_R6 and (not X_B1) and (not CAN_B1)  # proceed for route B1-WASH (R3, R11)
        LS_R6 = S_R6 and (not CO_R6)  # route B1-WASH: a condition was lost; no reopening by itself (R14)
        KP_R7 = (not NU_arr_1) and (not CD_E)  # route E-A1 stays set
        PR_R7 = A_R7 and B_R7 and W_R7 and CO_R7 and KP_R7 and (not X_E) and (not CAN_E)  # proceed for route E-A1 (R3, R11)
        LS_R7 = S_R7 and (not CO_R7)  # route E-A1: a condition was lost; no reopening by itself (R14)
        KP_R8 = (not NU_p2_4) and (not CD_K1)  # route K1-A2 stays set
        PR_R8 = A_R8 and B_R8 and W_R8 and CO_R8 and KP_R8 and (not X_K1) and (not CAN_K1)  # proceed for route K1-A2 (R3, R11)
        LS_R8 = S_R8 and (not CO_R8)  # route K1-A2: a condition was lost; no reopening by itself (R14)
        KP_R9 = (not NU_p3_4) and (not CD_K2)  # route K2-A2 stays set
        PR_R9 = A_R9 and B_R9 and W_R9 and CO_R9 and KP_R9 and (not X_K2) and (not CAN_K2)  # proceed for route K2-A2 (R3, R11)
        LS_R9 = S_R9 and (not CO_R9)  # route K2-A2: a condition was lost; no reopening by itself (R14)
        KP_R10 = (not NU_p3_5) and (not CD_K3)  # route K3-A2 stays set
        PR_R10 = A_R10 and B_R10 and W_R10 and CO_R10 and KP_R10 and (not X_K3) and (not CAN_K3)  # proceed for route K3-A2 (R3, R11)
        LS_R10 = S_R10 and (not CO_R10)  # route K3-A2: a condition was lost; no reopening by itself (R14)
        KP_R11 = (not NU_p1_3) and (not CD_W)  # route W-A2 stays set
        PR_R11 = A_R11 and B_R11 and W_R11 and CO_R11 and KP_R11 and (not X_W) and (not CAN_W)  # proceed for route W-A2 (R3, R11)
        LS_R11 = S_R11 and (not CO_R11)  # route W-A2: a condition was lost; no reopening by itself (R14)
        N_CN_BRIDGE = GPN_BRIDGE or MAN_BRIDGE or HDN_BRIDGE  # machine BRIDGE commanded N
        N_CR_BRIDGE = GPR_BRIDGE or MAR_BRIDGE or HDR_BRIDGE  # machine BRIDGE commanded R
        N_CN_D1 = GPN_D1 or MAN_D1 or HDN_D1  # machine D1 commanded N
        N_CR_D1 = GPR_D1 or MAR_D1 or HDR_D1  # machine D1 commanded R
        N_CN_D2 = GPN_D2 or MAN_D2 or HDN_D2  # machine D2 commanded N
        N_CR_D2 = GPR_D2 or MAR_D2 or HDR_D2  # machine D2 commanded R
        N_CN_D3 = GPN_D3 or MAN_D3 or HDN_D3  # machine D3 commanded N
        N_CR_D3 = GPR_D3 or MAR_D3 or HDR_D3  # machine D3 commanded R
        N_CN_P1 = GPN_P1 or MAN_P1 or HDN_P1  # machine P1 commanded N
        N_CR_P1 = GPR_P1 or MAR_P1 or HDR_P1  # machine P1 commanded R
        N_CN_P2 = GPN_P2 or MAN_P2 or HDN_P2  # machine P2 commanded N
        N_CR_P2 = GPR_P2 or MAR_P2 or HDR_P2  # machine P2 commanded R
        N_CN_P3 = GPN_P3 or MAN_P3 or HDN_P3  # machine P3 commanded N
        N_CR_P3 = GPR_P3 or MAR_P3 or HDR_P3  # machine P3 commanded R
        N_CN_PH = GPN_PH or MAN_PH or HDN_PH  # machine PH commanded N
        N_CR_PH = GPR_PH or MAR_PH or HDR_PH  # machine PH commanded R
        N_AL_BRIDGE = ST_BRIDGE  # alarm: machine BRIDGE not detected
        N_AL_D1 = ST_D1  # alarm: machine D1 not detected
        N_AL_D2 = ST_D2  # alarm: machine D2 not detected
        N_AL_D3 = ST_D3  # alarm: machine D3 not detected
        N_AL_P1 = ST_P1  # alarm: machine P1 not detected
        N_AL_P2 = ST_P2  # alarm: machine P2 not detected
        N_AL_P3 = ST_P3  # alarm: machine P3 not detected
        N_AL_PH = ST_PH  # alarm: machine PH not detected
        N_TH_D1 = ((CN_D1 and QN_D1) or (CR_D1 and QR_D1)) and (not (GPN_D1 or GPR_D1 or MAN_D1 or MAR_D1))  # machine D1 was detected where it is commanded
        N_TR_D1 = (TH_D1 and VALID and ((CN_D1 and (not QN_D1) and (not GPR_D1) and (not MAR_D1)) or (CR_D1 and (not QR_D1) and (not GPN_D1) and (not MAN_D1)))) or (TR_D1 and (not (TC_D1 and VALID and (not OCC_p2))))  # machine D1 was trailed
        N_TH_D2 = ((CN_D2 and QN_D2) or (CR_D2 and QR_D2)) and (not (GPN_D2 or GPR_D2 or MAN_D2 or MAR_D2))  # machine D2 was detected where it is commanded
        N_TR_D2 = (TH_D2 and VALID and ((CN_D2 and (not QN_D2) and (not GPR_D2) and (not MAR_D2)) or (CR_D2 and (not QR_D2) and (not GPN_D2) and (not MAN_D2)))) or (TR_D2 and (not (TC_D2 and VALID and (not OCC_p3))))  # machine D2 was trailed
        N_TH_D3 = ((CN_D3 and QN_D3) or (CR_D3 and QR_D3)) and (not (GPN_D3 or GPR_D3 or MAN_D3 or MAR_D3))  # machine D3 was detected where it is commanded
        N_TR_D3 = (TH_D3 and VALID and ((CN_D3 and (not QN_D3) and (not GPR_D3) and (not MAR_D3)) or (CR_D3 and (not QR_D3) and (not GPN_D3) and (not MAN_D3)))) or (TR_D3 and (not (TC_D3 and VALID and (not OCC_p3))))  # machine D3 was trailed
        N_TH_P1 = ((CN_P1 and QN_P1) or (CR_P1 and QR_P1)) and (not (GPN_P1 or GPR_P1 or MAN_P1 or MAR_P1))  # machine P1 was detected where it is commanded
        N_TR_P1 = (TH_P1 and VALID and ((CN_P1 and (not QN_P1) and (not GPR_P1) and (not MAR_P1)) or (CR_P1 and (not QR_P1) and (not GPN_P1) and (not MAN_P1)))) or (TR_P1 and (not (TC_P1 and VALID and (not OCC_p1))))  # machine P1 was trailed
        N_TH_P2 = ((CN_P2 and QN_P2) or (CR_P2 and QR_P2)) and (not (GPN_P2 or GPR_P2 or MAN_P2 or MAR_P2))  # machine P2 was detected where it is commanded
        N_TR_P2 = (TH_P2 and VALID and ((CN_P2 and (not QN_P2) and (not GPR_P2) and (not MAR_P2)) or (CR_P2 and (not QR_P2) and (not GPN_P2) and (not MAN_P2)))) or (TR_P2 and (not (TC_P2 and VALID and (not OCC_p2))))  # machine P2 was trailed
        N_TH_P3 = ((CN_P3 and QN_P3) or (CR_P3 and QR_P3)) and (not (GPN_P3 or GPR_P3 or MAN_P3 or MAR_P3))  # machine P3 was detected where it is commanded
        N_TR_P3 = (TH_P3 and VALID and ((CN_P3 and (not QN_P3) and (not GPR_P3) and (not MAR_P3)) or (CR_P3 and (not QR_P3) and (not GPN_P3) and (not MAN_P3)))) or (TR_P3 and (not (TC_P3 and VALID and (not OCC_p3))))  # machine P3 was trailed
        N_A_R1 = (A_R1 or G_R1) and KP_R1  # route A1-B1.s active
        N_B_R1 = (B_R1 or LK_R1) and KP_R1  # route A1-B1.s locked
        N_W_R1 = (W_R1 or LK_R1 or ((REQ == 1) and B_R1)) and (not LS_R1) and KP_R1 and (not X_A1) and (not CAN_A1)  # route A1-B1.s: proceed wanted
        N_S_R1 = PR_R1  # route A1-B1.s: proceed
        N_H_R1 = (H_R1 or PR_R1) and KP_R1  # route A1-B1.s: signal has been open
        N_A_R2 = (A_R2 or G_R2) and KP_R2  # route A2-LINE active
        N_B_R2 = (B_R2 or LK_R2) and KP_R2  # route A2-LINE locked
        N_W_R2 = (W_R2 or LK_R2 or ((REQ == 2) and B_R2)) and (not LS_R2) and KP_R2 and (not X_A2) and (not CAN_A2)  # route A2-LINE: proceed wanted
        N_S_R2 = PR_R2  # route A2-LINE: proceed
        N_H_R2 = (H_R2 or PR_R2) and KP_R2  # route A2-LINE: signal has been open
        N_A_R3 = (A_R3 or G_R3) and KP_R3  # route B1-H1 active
        N_B_R3 = (B_R3 or LK_R3) and KP_R3  # route B1-H1 locked
        N_W_R3 = (W_R3 or LK_R3 or ((REQ == 3) and B_R3)) and (not LS_R3) and KP_R3 and (not X_B1) and (not CAN_B1)  # route B1-H1: proceed wanted
        N_S_R3 = PR_R3  # route B1-H1: proceed
        N_H_R3 = (H_R3 or PR_R3) and KP_R3  # route B1-H1: signal has been open
        N_A_R4 = (A_R4 or G_R4) and KP_R4  # route B1-H2 active
        N_B_R4 = (B_R4 or LK_R4) and KP_R4  # route B1-H2 locked
        N_W_R4 = (W_R4 or LK_R4 or ((REQ == 4) and B_R4)) and (not LS_R4) and KP_R4 and (not X_B1) and (not CAN_B1)  # route B1-H2: proceed wanted
        N_S_R4 = PR_R4  # route B1-H2: proceed
        N_H_R4 = (H_R4 or PR_R4) and KP_R4  # route B1-H2: signal has been open
        N_A_R5 = (A_R5 or G_R5) and KP_R5  # route B1-H3 active
        N_B_R5 = (B_R5 or LK_R5) and KP_R5  # route B1-H3 locked
        N_W_R5 = (W_R5 or LK_R5 or ((REQ == 5) and B_R5)) and (not LS_R5) and KP_R5 and (not X_B1) and (not CAN_B1)  # route B1-H3: proceed wanted
        N_S_R5 = PR_R5  # route B1-H3: proceed
        N_H_R5 = (H_R5 or PR_R5) and KP_R5  # route B1-H3: signal has been open
        N_A_R6 = (A_R6 or G_R6) and KP_R6  # route B1-WASH active
        N_B_R6 = (B_R6 or LK_R6) and KP_R6  # route B1-WASH locked
        N_W_R6 = (W_R6 or LK_R6 or ((REQ == 6) and B_R6)) and (not LS_R6) and KP_R6 and (not X_B1) and (not CAN_B1)  # route B1-WASH: proceed wanted
        N_S_R6 = PR_R6  # route B1-WASH: proceed
        N_H_R6 = (H_R6 or PR_R6) and KP_R6  # route B1-WASH: signal has been open
        N_A_R7 = (A_R7 or G_R7) and KP_R7  # route E-A1 active
        N_B_R7 = (B_R7 or LK_R7) and KP_R7  # route E-A1 locked
        N_W_R7 = (W_R7 or LK_R7 or ((REQ == 7) and B_R7)) and (not LS_R7) and KP_R7 and (not X_E) and (not CAN_E)  # route E-A1: proceed wanted
        N_S_R7 = PR_R7  # route E-A1: proceed
        N_H_R7 = (H_R7 or PR_R7) and KP_R7  # route E-A1: signal has been open
        N_A_R8 = (A_R8 or G_R8) and KP_R8  # route K1-A2 active
        N_B_R8 = (B_R8 or LK_R8) and KP_R8  # route K1-A2 locked
        N_W_R8 = (W_R8 or LK_R8 or ((REQ == 8) and B_R8)) and (not LS_R8) and KP_R8 and (not X_K1) and (not CAN_K1)  # route K1-A2: proceed wanted
        N_S_R8 = PR_R8  # route K1-A2: proceed
        N_H_R8 = (H_R8 or PR_R8) and KP_R8  # route K1-A2: signal has been open
        N_A_R9 = (A_R9 or G_R9) and KP_R9  # route K2-A2 active
        N_B_R9 = (B_R9 or LK_R9) and KP_R9  # route K2-A2 locked
        N_W_R9 = (W_R9 or LK_R9 or ((REQ == 9) and B_R9)) and (not LS_R9) and KP_R9 and (not X_K2) and (not CAN_K2)  # route K2-A2: proceed wanted
        N_S_R9 = PR_R9  # route K2-A2: proceed
        N_H_R9 = (H_R9 or PR_R9) and KP_R9  # route K2-A2: signal has been open
        N_A_R10 = (A_R10 or G_R10) and KP_R10  # route K3-A2 active
        N_B_R10 = (B_R10 or LK_R10) and KP_R10  # route K3-A2 locked
        N_W_R10 = (W_R10 or LK_R10 or ((REQ == 10) and B_R10)) and (not LS_R10) and KP_R10 and (not X_K3) and (not CAN_K3)  # route K3-A2: proceed wanted
        N_S_R10 = PR_R10  # route K3-A2: proceed
        N_H_R10 = (H_R10 or PR_R10) and KP_R10  # route K3-A2: signal has been open
        N_A_R11 = (A_R11 or G_R11) and KP_R11  # route W-A2 active
        N_B_R11 = (B_R11 or LK_R11) and KP_R11  # route W-A2 locked
        N_W_R11 = (W_R11 or LK_R11 or ((REQ == 11) and B_R11)) and (not LS_R11) and KP_R11 and (not X_W) and (not CAN_W)  # route W-A2: proceed wanted
        N_S_R11 = PR_R11  # route W-A2: proceed
        N_H_R11 = (H_R11 or PR_R11) and KP_R11  # route W-A2: signal has been open
        N_X_A1 = (X_A1 or CAN_A1) and A_R1 and (not CD_A1)  # A1: cancelling
        N_X_A2 = (X_A2 or CAN_A2) and A_R2 and (not CD_A2)  # A2: cancelling
        N_X_B1 = (X_B1 or CAN_B1) and (A_R3 or A_R4 or A_R5 or A_R6) and (not CD_B1)  # B1: cancelling
        N_X_E = (X_E or CAN_E) and A_R7 and (not CD_E)  # E: cancelling
        N_X_K1 = (X_K1 or CAN_K1) and A_R8 and (not CD_K1)  # K1: cancelling
        N_X_K2 = (X_K2 or CAN_K2) and A_R9 and (not CD_K2)  # K2: cancelling
        N_X_K3 = (X_K3 or CAN_K3) and A_R10 and (not CD_K3)  # K3: cancelling
        N_X_W = (X_W or CAN_W) and A_R11 and (not CD_W)  # W: cancelling
        N_K_arr = K_arr and (not RLS_arr)  # arr: restart lock (R16)
        N_L_arr_1 = (L_arr_1 or GW_arr_1) and (not RLS_arr)  # arr locked from LINE to arr|ph@PH.toe
        N_L_arr_2 = (L_arr_2 or GW_arr_2) and (not RLS_arr)  # arr locked from arr|ph@PH.toe to LINE
        N_M_arr = (M_arr or G_R7 or G_R2) and (not RLS_arr)  # arr locked for a train movement
        N_F_arr = (F_arr or LK_R7 or LK_R2) and (not RLS_arr)  # arr firmly locked
        N_U_arr = (U_arr or NU_arr_1 or NU_arr_2) and (not RLS_arr)  # arr used by a train (R9)
        N_P_arr = (P_arr or (U_arr and OCC_arr and NU_ph_1)) and (not RLS_arr)  # arr: the train went on (R9)
        N_D_arr = (D_arr or ((not VALID) and (L_arr_1 or L_arr_2))) and (not RLS_arr)  # arr: detection is not relied on, inputs were lost or a train is called on
        N_K_brg = K_brg and (not RLS_brg)  # brg: restart lock (R16)
        N_L_brg_1 = (L_brg_1 or GW_brg_1) and (not RLS_brg)  # brg locked from brg|p1@P1.toe to brg|ph@PH.normal
        N_L_brg_2 = (L_brg_2 or GW_brg_2) and (not RLS_brg)  # brg locked from brg|ph@PH.normal to brg|p1@P1.toe
        N_M_brg = M_brg and (not RLS_brg)  # brg locked for a train movement
        N_F_brg = (F_brg or LK_R8 or LK_R9 or LK_R10 or LK_R11 or LK_R1) and (not RLS_brg)  # brg firmly locked
        N_U_brg = (U_brg or NU_brg_1 or NU_brg_2) and (not RLS_brg)  # brg used by a train (R9)
        N_P_brg = (P_brg or (U_brg and OCC_brg and (NU_p1_1 or NU_ph_2))) and (not RLS_brg)  # brg: the train went on (R9)
        N_D_brg = (D_brg or ((not VALID) and (L_brg_1 or L_brg_2))) and (not RLS_brg)  # brg: detection is not relied on, inputs were lost or a train is called on
        N_K_p1 = K_p1 and (not RLS_p1)  # p1: restart lock (R16)
        N_L_p1_1 = (L_p1_1 or GW_p1_1) and (not RLS_p1)  # p1 locked from brg|p1@P1.toe to p1|p2@P1.normal
        N_L_p1_2 = (L_p1_2 or GW_p1_2) and (not RLS_p1)  # p1 locked from brg|p1@P1.toe to p1|wsh@P1.reverse
        N_L_p1_3 = (L_p1_3 or GW_p1_3) and (not RLS_p1)  # p1 locked from p1|p2@P1.normal to brg|p1@P1.toe
        N_L_p1_4 = (L_p1_4 or GW_p1_4) and (not RLS_p1)  # p1 locked from p1|wsh@P1.reverse to brg|p1@P1.toe
        N_M_p1 = M_p1 and (not RLS_p1)  # p1 locked for a train movement
        N_F_p1 = (F_p1 or LK_R3 or LK_R4 or LK_R5 or LK_R6 or LK_R8 or LK_R9 or LK_R10 or LK_R11) and (not RLS_p1)  # p1 firmly locked
        N_U_p1 = (U_p1 or NU_p1_1 or NU_p1_2 or NU_p1_3) and (not RLS_p1)  # p1 used by a train (R9)
        N_P_p1 = (P_p1 or (U_p1 and OCC_p1 and (NU_brg_1 or NU_p2_2 or NU_wsh_2))) and (not RLS_p1)  # p1: the train went on (R9)
        N_D_p1 = (D_p1 or ((not VALID) and (L_p1_1 or L_p1_2 or L_p1_3 or L_p1_4))) and (not RLS_p1)  # p1: detection is not relied on, inputs were lost or a train is called on
        N_K_p2 = K_p2 and (not RLS_p2)  # p2: restart lock (R16)
        N_L_p2_2 = (L_p2_2 or GW_p2_2) and (not RLS_p2)  # p2 locked from p1|p2@P1.normal to p2|p3@P2.normal
        N_L_p2_3 = (L_p2_3 or GW_p2_3) and (not RLS_p2)  # p2 locked from p1|p2@P1.normal to p2|sh1@D1.outer
        N_L_p2_4 = (L_p2_4 or GW_p2_4) and (not RLS_p2)  # p2 locked from p2|p3@P2.normal to p1|p2@P1.normal
        N_L_p2_5 = (L_p2_5 or GW_p2_5) and (not RLS_p2)  # p2 locked from p2|sh1@D1.outer to p1|p2@P1.normal
        N_M_p2 = M_p2 and (not RLS_p2)  # p2 locked for a train movement
        N_F_p2 = (F_p2 or LK_R4 or LK_R5 or LK_R3 or LK_R9 or LK_R10 or LK_R8) and (not RLS_p2)  # p2 firmly locked
        N_U_p2 = (U_p2 or NU_p2_2 or NU_p2_3 or NU_p2_4) and (not RLS_p2)  # p2 used by a train (R9)
        N_P_p2 = (P_p2 or (U_p2 and OCC_p2 and (NU_p1_2 or NU_p3_3 or NU_sh1_2))) and (not RLS_p2)  # p2: the train went on (R9)
        N_D_p2 = (D_p2 or ((not VALID) and (L_p2_2 or L_p2_3 or L_p2_4 or L_p2_5))) and (not RLS_p2)  # p2: detection is not relied on, inputs were lost or a train is called on
        N_K_p3 = K_p3 and (not RLS_p3)  # p3: restart lock (R16)
        N_L_p3_3 = (L_p3_3 or GW_p3_3) and (not RLS_p3)  # p3 locked from p2|p3@P2.normal to p3|sh2@D2.outer
        N_L_p3_4 = (L_p3_4 or GW_p3_4) and (not RLS_p3)  # p3 locked from p2|p3@P2.normal to p3|sh3@D3.outer
        N_L_p3_5 = (L_p3_5 or GW_p3_5) and (not RLS_p3)  # p3 locked from p3|sh2@D2.outer to p2|p3@P2.normal
        N_L_p3_6 = (L_p3_6 or GW_p3_6) and (not RLS_p3)  # p3 locked from p3|sh3@D3.outer to p2|p3@P2.normal
        N_M_p3 = M_p3 and (not RLS_p3)  # p3 locked for a train movement
        N_F_p3 = (F_p3 or LK_R4 or LK_R5 or LK_R9 or LK_R10) and (not RLS_p3)  # p3 firmly locked
        N_U_p3 = (U_p3 or NU_p3_3 or NU_p3_4 or NU_p3_5) and (not RLS_p3)  # p3 used by a train (R9)
        N_P_p3 = (P_p3 or (U_p3 and OCC_p3 and (NU_p2_3 or NU_sh2_2 or NU_sh3_2))) and (not RLS_p3)  # p3: the train went on (R9)
        N_D_p3 = (D_p3 or ((not VALID) and (L_p3_3 or L_p3_4 or L_p3_5 or L_p3_6))) and (not RLS_p3)  # p3: detection is not relied on, inputs were lost or a train is called on
        N_K_ph = K_ph and (not RLS_ph)  # ph: restart lock (R16)
        N_L_ph_1 = (L_ph_1 or GW_ph_1) and (not RLS_ph)  # ph locked from arr|ph@PH.toe to brg|ph@PH.normal
        N_L_ph_3 = (L_ph_3 or GW_ph_3) and (not RLS_ph)  # ph locked from brg|ph@PH.normal to arr|ph@PH.toe
        N_M_ph = M_ph and (not RLS_ph)  # ph locked for a train movement
        N_F_ph = (F_ph or LK_R1 or LK_R8 or LK_R9 or LK_R10 or LK_R11) and (not RLS_ph)  # ph firmly locked
        N_U_ph = (U_ph or NU_ph_1 or NU_ph_2) and (not RLS_ph)  # ph used by a train (R9)
        N_P_ph = (P_ph or (U_ph and OCC_ph and (NU_arr_2 or NU_brg_2))) and (not RLS_ph)  # ph: the train went on (R9)
        N_D_ph = (D_ph or ((not VALID) and (L_ph_1 or L_ph_3))) and (not RLS_ph)  # ph: detection is not relied on, inputs were lost or a train is called on
        N_K_sh1 = K_sh1 and (not RLS_sh1)  # sh1: restart lock (R16)
        N_L_sh1_2 = (L_sh1_2 or (GB_sh1_2 and FREE_sh1)) and (not RLS_sh1)  # sh1 locked from p2|sh1@D1.outer to H1
        N_M_sh1 = M_sh1 and (not RLS_sh1) and (not AR_sh1)  # sh1 locked for a train movement
        N_F_sh1 = (F_sh1 or (LK_R3 and L_sh1_2)) and (not RLS_sh1)  # sh1 firmly locked
        N_U_sh1 = (U_sh1 or NU_sh1_2) and (not RLS_sh1)  # sh1 used by a train (R9)
        N_P_sh1 = (P_sh1 or (U_sh1 and OCC_sh1 and NU_p2_4)) and (not RLS_sh1)  # sh1: the train went on (R9)
        N_D_sh1 = (D_sh1 or ((not VALID) and L_sh1_2)) and (not RLS_sh1)  # sh1: detection is not relied on, inputs were lost or a train is called on
        N_K_sh2 = K_sh2 and (not RLS_sh2)  # sh2: restart lock (R16)
        N_L_sh2_2 = (L_sh2_2 or (GB_sh2_2 and FREE_sh2)) and (not RLS_sh2)  # sh2 locked from p3|sh2@D2.outer to H2
        N_M_sh2 = M_sh2 and (not RLS_sh2) and (not AR_sh2)  # sh2 locked for a train movement
        N_F_sh2 = (F_sh2 or (LK_R4 and L_sh2_2)) and (not RLS_sh2)  # sh2 firmly locked
        N_U_sh2 = (U_sh2 or NU_sh2_2) and (not RLS_sh2)  # sh2 used by a train (R9)
        N_P_sh2 = (P_sh2 or (U_sh2 and OCC_sh2 and NU_p3_4)) and (not RLS_sh2)  # sh2: the train went on (R9)
        N_D_sh2 = (D_sh2 or ((not VALID) and L_sh2_2)) and (not RLS_sh2)  # sh2: detection is not relied on, inputs were lost or a train is called on
        N_K_sh3 = K_sh3 and (not RLS_sh3)  # sh3: restart lock (R16)
        N_L_sh3_2 = (L_sh3_2 or (GB_sh3_2 and FREE_sh3)) and (not RLS_sh3)  # sh3 locked from p3|sh3@D3.outer to H3
        N_M_sh3 = M_sh3 and (not RLS_sh3) and (not AR_sh3)  # sh3 locked for a train movement
        N_F_sh3 = (F_sh3 or (LK_R5 and L_sh3_2)) and (not RLS_sh3)  # sh3 firmly locked
        N_U_sh3 = (U_sh3 or NU_sh3_2) and (not RLS_sh3)  # sh3 used by a train (R9)
        N_P_sh3 = (P_sh3 or (U_sh3 and OCC_sh3 and NU_p3_5)) and (not RLS_sh3)  # sh3: the train went on (R9)
        N_D_sh3 = (D_sh3 or ((not VALID) and L_sh3_2)) and (not RLS_sh3)  # sh3: detection is not relied on, inputs were lost or a train is called on
        N_K_sto = K_sto and (not RLS_sto)  # sto: restart lock (R16)
        N_M_sto = M_sto and (not RLS_sto)  # sto locked for a train movement
        N_F_sto = F_sto and (not RLS_sto)  # sto firmly locked
        N_U_sto = U_sto and (not RLS_sto)  # sto used by a train (R9)
        N_P_sto = P_sto and (not RLS_sto)  # sto: the train went on (R9)
        N_D_sto = D_sto and (not RLS_sto)  # sto: detection is not relied on, inputs were lost or a train is called on
        N_K_wsh = K_wsh and (not RLS_wsh)  # wsh: restart lock (R16)
        N_L_wsh_2 = (L_wsh_2 or (GB_wsh_2 and FREE_wsh)) and (not RLS_wsh)  # wsh locked from p1|wsh@P1.reverse to WASH
        N_M_wsh = M_wsh and (not RLS_wsh) and (not AR_wsh)  # wsh locked for a train movement
        N_F_wsh = (F_wsh or (LK_R6 and L_wsh_2)) and (not RLS_wsh)  # wsh firmly locked
        N_U_wsh = (U_wsh or NU_wsh_2) and (not RLS_wsh)  # wsh used by a train (R9)
        N_P_wsh = (P_wsh or (U_wsh and NU_p1_3)) and (not RLS_wsh)  # wsh: the train went on (R9)
        N_D_wsh = (D_wsh or ((not VALID) and L_wsh_2)) and (not RLS_wsh)  # wsh: detection is not relied on, inputs were lost or a train is called on
        N_C_A2 = PR_R2 and PR_R2  # A2 shows clear
        N_C_E = PR_R7 and False  # E shows clear
        self.state = {
            'CN_BRIDGE': bool(N_CN_BRIDGE),
            'CR_BRIDGE': bool(N_CR_BRIDGE),
            'CN_D1': bool(N_CN_D1),
            'CR_D1': bool(N_CR_D1),
            'CN_D2': bool(N_CN_D2),
            'CR_D2': bool(N_CR_D2),
            'CN_D3': bool(N_CN_D3),
            'CR_D3': bool(N_CR_D3),
            'CN_P1': bool(N_CN_P1),
            'CR_P1': bool(N_CR_P1),
            'CN_P2': bool(N_CN_P2),
            'CR_P2': bool(N_CR_P2),
            'CN_P3': bool(N_CN_P3),
            'CR_P3': bool(N_CR_P3),
            'CN_PH': bool(N_CN_PH),
            'CR_PH': bool(N_CR_PH),
            'AL_BRIDGE': bool(N_AL_BRIDGE),
            'AL_D1': bool(N_AL_D1),
            'AL_D2': bool(N_AL_D2),
            'AL_D3': bool(N_AL_D3),
            'AL_P1': bool(N_AL_P1),
            'AL_P2': bool(N_AL_P2),
            'AL_P3': bool(N_AL_P3),
            'AL_PH': bool(N_AL_PH),
            'TH_D1': bool(N_TH_D1),
            'TR_D1': bool(N_TR_D1),
            'TH_D2': bool(N_TH_D2),
            'TR_D2': bool(N_TR_D2),
            'TH_D3': bool(N_TH_D3),
            'TR_D3': bool(N_TR_D3),
            'TH_P1': bool(N_TH_P1),
            'TR_P1': bool(N_TR_P1),
            'TH_P2': bool(N_TH_P2),
            'TR_P2': bool(N_TR_P2),
            'TH_P3': bool(N_TH_P3),
            'TR_P3': bool(N_TR_P3),
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
            'X_A1': bool(N_X_A1),
            'X_A2': bool(N_X_A2),
            'X_B1': bool(N_X_B1),
            'X_E': bool(N_X_E),
            'X_K1': bool(N_X_K1),
            'X_K2': bool(N_X_K2),
            'X_K3': bool(N_X_K3),
            'X_W': bool(N_X_W),
            'K_arr': bool(N_K_arr),
            'L_arr_1': bool(N_L_arr_1),
            'L_arr_2': bool(N_L_arr_2),
            'M_arr': bool(N_M_arr),
            'F_arr': bool(N_F_arr),
            'U_arr': bool(N_U_arr),
            'P_arr': bool(N_P_arr),
            'D_arr': bool(N_D_arr),
            'K_brg': bool(N_K_brg),
            'L_brg_1': bool(N_L_brg_1),
            'L_brg_2': bool(N_L_brg_2),
            'M_brg': bool(N_M_brg),
            'F_brg': bool(N_F_brg),
            'U_brg': bool(N_U_brg),
            'P_brg': bool(N_P_brg),
            'D_brg': bool(N_D_brg),
            'K_p1': bool(N_K_p1),
            'L_p1_1': bool(N_L_p1_1),
            'L_p1_2': bool(N_L_p1_2),
            'L_p1_3': bool(N_L_p1_3),
            'L_p1_4': bool(N_L_p1_4),
            'M_p1': bool(N_M_p1),
            'F_p1': bool(N_F_p1),
            'U_p1': bool(N_U_p1),
            'P_p1': bool(N_P_p1),
            'D_p1': bool(N_D_p1),
            'K_p2': bool(N_K_p2),
            'L_p2_2': bool(N_L_p2_2),
            'L_p2_3': bool(N_L_p2_3),
            'L_p2_4': bool(N_L_p2_4),
            'L_p2_5': bool(N_L_p2_5),
            'M_p2': bool(N_M_p2),
            'F_p2': bool(N_F_p2),
            'U_p2': bool(N_U_p2),
            'P_p2': bool(N_P_p2),
            'D_p2': bool(N_D_p2),
            'K_p3': bool(N_K_p3),
            'L_p3_3': bool(N_L_p3_3),
            'L_p3_4': bool(N_L_p3_4),
            'L_p3_5': bool(N_L_p3_5),
            'L_p3_6': bool(N_L_p3_6),
            'M_p3': bool(N_M_p3),
            'F_p3': bool(N_F_p3),
            'U_p3': bool(N_U_p3),
            'P_p3': bool(N_P_p3),
            'D_p3': bool(N_D_p3),
            'K_ph': bool(N_K_ph),
            'L_ph_1': bool(N_L_ph_1),
            'L_ph_3': bool(N_L_ph_3),
            'M_ph': bool(N_M_ph),
            'F_ph': bool(N_F_ph),
            'U_ph': bool(N_U_ph),
            'P_ph': bool(N_P_ph),
            'D_ph': bool(N_D_ph),
            'K_sh1': bool(N_K_sh1),
            'L_sh1_2': bool(N_L_sh1_2),
            'M_sh1': bool(N_M_sh1),
            'F_sh1': bool(N_F_sh1),
            'U_sh1': bool(N_U_sh1),
            'P_sh1': bool(N_P_sh1),
            'D_sh1': bool(N_D_sh1),
            'K_sh2': bool(N_K_sh2),
            'L_sh2_2': bool(N_L_sh2_2),
            'M_sh2': bool(N_M_sh2),
            'F_sh2': bool(N_F_sh2),
            'U_sh2': bool(N_U_sh2),
            'P_sh2': bool(N_P_sh2),
            'D_sh2': bool(N_D_sh2),
            'K_sh3': bool(N_K_sh3),
            'L_sh3_2': bool(N_L_sh3_2),
            'M_sh3': bool(N_M_sh3),
            'F_sh3': bool(N_F_sh3),
            'U_sh3': bool(N_U_sh3),
            'P_sh3': bool(N_P_sh3),
            'D_sh3': bool(N_D_sh3),
            'K_sto': bool(N_K_sto),
            'M_sto': bool(N_M_sto),
            'F_sto': bool(N_F_sto),
            'U_sto': bool(N_U_sto),
            'P_sto': bool(N_P_sto),
            'D_sto': bool(N_D_sto),
            'K_wsh': bool(N_K_wsh),
            'L_wsh_2': bool(N_L_wsh_2),
            'M_wsh': bool(N_M_wsh),
            'F_wsh': bool(N_F_wsh),
            'U_wsh': bool(N_U_wsh),
            'P_wsh': bool(N_P_wsh),
            'D_wsh': bool(N_D_wsh),
            'C_A2': bool(N_C_A2),
            'C_E': bool(N_C_E),
        }
        CN_BRIDGE = self.state['CN_BRIDGE']
        CR_BRIDGE = self.state['CR_BRIDGE']
        CN_D1 = self.state['CN_D1']
        CR_D1 = self.state['CR_D1']
        CN_D2 = self.state['CN_D2']
        CR_D2 = self.state['CR_D2']
        CN_D3 = self.state['CN_D3']
        CR_D3 = self.state['CR_D3']
        CN_P1 = self.state['CN_P1']
        CR_P1 = self.state['CR_P1']
        CN_P2 = self.state['CN_P2']
        CR_P2 = self.state['CR_P2']
        CN_P3 = self.state['CN_P3']
        CR_P3 = self.state['CR_P3']
        CN_PH = self.state['CN_PH']
        CR_PH = self.state['CR_PH']
        AL_BRIDGE = self.state['AL_BRIDGE']
        AL_D1 = self.state['AL_D1']
        AL_D2 = self.state['AL_D2']
        AL_D3 = self.state['AL_D3']
        AL_P1 = self.state['AL_P1']
        AL_P2 = self.state['AL_P2']
        AL_P3 = self.state['AL_P3']
        AL_PH = self.state['AL_PH']
        TH_D1 = self.state['TH_D1']
        TR_D1 = self.state['TR_D1']
        TH_D2 = self.state['TH_D2']
        TR_D2 = self.state['TR_D2']
        TH_D3 = self.state['TH_D3']
        TR_D3 = self.state['TR_D3']
        TH_P1 = self.state['TH_P1']
        TR_P1 = self.state['TR_P1']
        TH_P2 = self.state['TH_P2']
        TR_P2 = self.state['TR_P2']
        TH_P3 = self.state['TH_P3']
        TR_P3 = self.state['TR_P3']
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
        X_A1 = self.state['X_A1']
        X_A2 = self.state['X_A2']
        X_B1 = self.state['X_B1']
        X_E = self.state['X_E']
        X_K1 = self.state['X_K1']
        X_K2 = self.state['X_K2']
        X_K3 = self.state['X_K3']
        X_W = self.state['X_W']
        K_arr = self.state['K_arr']
        L_arr_1 = self.state['L_arr_1']
        L_arr_2 = self.state['L_arr_2']
        M_arr = self.state['M_arr']
        F_arr = self.state['F_arr']
        U_arr = self.state['U_arr']
        P_arr = self.state['P_arr']
        D_arr = self.state['D_arr']
        K_brg = self.state['K_brg']
        L_brg_1 = self.state['L_brg_1']
        L_brg_2 = self.state['L_brg_2']
        M_brg = self.state['M_brg']
        F_brg = self.state['F_brg']
        U_brg = self.state['U_brg']
        P_brg = self.state['P_brg']
        D_brg = self.state['D_brg']
        K_p1 = self.state['K_p1']
        L_p1_1 = self.state['L_p1_1']
        L_p1_2 = self.state['L_p1_2']
        L_p1_3 = self.state['L_p1_3']
        L_p1_4 = self.state['L_p1_4']
        M_p1 = self.state['M_p1']
        F_p1 = self.state['F_p1']
        U_p1 = self.state['U_p1']
        P_p1 = self.state['P_p1']
        D_p1 = self.state['D_p1']
        K_p2 = self.state['K_p2']
        L_p2_2 = self.state['L_p2_2']
        L_p2_3 = self.state['L_p2_3']
        L_p2_4 = self.state['L_p2_4']
        L_p2_5 = self.state['L_p2_5']
        M_p2 = self.state['M_p2']
        F_p2 = self.state['F_p2']
        U_p2 = self.state['U_p2']
        P_p2 = self.state['P_p2']
        D_p2 = self.state['D_p2']
        K_p3 = self.state['K_p3']
        L_p3_3 = self.state['L_p3_3']
        L_p3_4 = self.state['L_p3_4']
        L_p3_5 = self.state['L_p3_5']
        L_p3_6 = self.state['L_p3_6']
        M_p3 = self.state['M_p3']
        F_p3 = self.state['F_p3']
        U_p3 = self.state['U_p3']
        P_p3 = self.state['P_p3']
        D_p3 = self.state['D_p3']
        K_ph = self.state['K_ph']
        L_ph_1 = self.state['L_ph_1']
        L_ph_3 = self.state['L_ph_3']
        M_ph = self.state['M_ph']
        F_ph = self.state['F_ph']
        U_ph = self.state['U_ph']
        P_ph = self.state['P_ph']
        D_ph = self.state['D_ph']
        K_sh1 = self.state['K_sh1']
        L_sh1_2 = self.state['L_sh1_2']
        M_sh1 = self.state['M_sh1']
        F_sh1 = self.state['F_sh1']
        U_sh1 = self.state['U_sh1']
        P_sh1 = self.state['P_sh1']
        D_sh1 = self.state['D_sh1']
        K_sh2 = self.state['K_sh2']
        L_sh2_2 = self.state['L_sh2_2']
        M_sh2 = self.state['M_sh2']
        F_sh2 = self.state['F_sh2']
        U_sh2 = self.state['U_sh2']
        P_sh2 = self.state['P_sh2']
        D_sh2 = self.state['D_sh2']
        K_sh3 = self.state['K_sh3']
        L_sh3_2 = self.state['L_sh3_2']
        M_sh3 = self.state['M_sh3']
        F_sh3 = self.state['F_sh3']
        U_sh3 = self.state['U_sh3']
        P_sh3 = self.state['P_sh3']
        D_sh3 = self.state['D_sh3']
        K_sto = self.state['K_sto']
        M_sto = self.state['M_sto']
        F_sto = self.state['F_sto']
        U_sto = self.state['U_sto']
        P_sto = self.state['P_sto']
        D_sto = self.state['D_sto']
        K_wsh = self.state['K_wsh']
        L_wsh_2 = self.state['L_wsh_2']
        M_wsh = self.state['M_wsh']
        F_wsh = self.state['F_wsh']
        U_wsh = self.state['U_wsh']
        P_wsh = self.state['P_wsh']
        D_wsh = self.state['D_wsh']
        C_A2 = self.state['C_A2']
        C_E = self.state['C_E']
        return {
            'YN_BRIDGE': bool(CN_BRIDGE),
            'YR_BRIDGE': bool(CR_BRIDGE),
            'YN_D1': bool(CN_D1),
            'YR_D1': bool(CR_D1),
            'YN_D2': bool(CN_D2),
            'YR_D2': bool(CR_D2),
            'YN_D3': bool(CN_D3),
            'YR_D3': bool(CR_D3),
            'YN_P1': bool(CN_P1),
            'YR_P1': bool(CR_P1),
            'YN_P2': bool(CN_P2),
            'YR_P2': bool(CR_P2),
            'YN_P3': bool(CN_P3),
            'YR_P3': bool(CR_P3),
            'YN_PH': bool(CN_PH),
            'YR_PH': bool(CR_PH),
            'YA_BRIDGE': bool(AL_BRIDGE),
            'YA_D1': bool(AL_D1),
            'YA_D2': bool(AL_D2),
            'YA_D3': bool(AL_D3),
            'YA_P1': bool(AL_P1),
            'YA_P2': bool(AL_P2),
            'YA_P3': bool(AL_P3),
            'YA_PH': bool(AL_PH),
            'YT_D1': bool(TR_D1),
            'YT_D2': bool(TR_D2),
            'YT_D3': bool(TR_D3),
            'YT_P1': bool(TR_P1),
            'YT_P2': bool(TR_P2),
            'YT_P3': bool(TR_P3),
            'YL_arr': bool(K_arr or L_arr_1 or L_arr_2),
            'YL_brg': bool(K_brg or L_brg_1 or L_brg_2),
            'YL_p1': bool(K_p1 or L_p1_1 or L_p1_2 or L_p1_3 or L_p1_4),
            'YL_p2': bool(K_p2 or L_p2_2 or L_p2_3 or L_p2_4 or L_p2_5),
            'YL_p3': bool(K_p3 or L_p3_3 or L_p3_4 or L_p3_5 or L_p3_6),
            'YL_ph': bool(K_ph or L_ph_1 or L_ph_3),
            'YL_sh1': bool(K_sh1 or L_sh1_2),
            'YL_sh2': bool(K_sh2 or L_sh2_2),
            'YL_sh3': bool(K_sh3 or L_sh3_2),
            'YL_sto': bool(K_sto),
            'YL_wsh': bool(K_wsh or L_wsh_2),
            'YP_A1': bool(False),
            'YY_A1': bool(False),
            'YW_A1': bool(S_R1),
            'YS_A1': bool((not S_R1)),
            'YP_A2': bool(C_A2),
            'YY_A2': bool(S_R2 and (not C_A2)),
            'YW_A2': bool(False),
            'YS_A2': bool((not S_R2)),
            'YW_B1': bool(S_R3 or S_R4 or S_R5 or S_R6),
            'YS_B1': bool((not (S_R3 or S_R4 or S_R5 or S_R6))),
            'YP_E': bool(C_E),
            'YY_E': bool(S_R7 and (not C_E)),
            'YS_E': bool((not S_R7)),
            'YW_K1': bool(S_R8),
            'YS_K1': bool((not S_R8)),
            'YW_K2': bool(S_R9),
            'YS_K2': bool((not S_R9)),
            'YW_K3': bool(S_R10),
            'YS_K3': bool((not S_R10)),
            'YW_W': bool(S_R11),
            'YS_W': bool((not S_R11)),
        }
