"""The second checker: a layout, the emitted text and a certificate, read again with code of its own.

It imports nothing of what derives, lowers, proves or prints, but the certificate's checker `interlock.verify`, which
stands alone, too.  Each module has its half of the question:

structured_text  what the emitted text says, statement by statement
scan             what one call of it computes
controller       whether the certificate's written system says the same
reading          YAML, without what has two meanings
language         whether the layout file is one
railway          what it says
speeds           whether delays are made for the speeds that may be shown
words, moves     what the words of the specification mean for it
schema           what its sentences say
claims           whether the system assumes and claims what the specification asks for this layout
plant            whether the world moves as it says
said             whether what the text says of routes is so
outputs          whether the other files say the same, and which nobody reads
"""
