from tactum._tactum import (Body as Body, Contact as Contact, Joint as Joint, Layer as Layer, Mask as Mask, Object as Object,
                            Parameter as Parameter, Place as Place, Preset as Preset, Reading as Reading,
                            Recording as Recording, Scene as Scene, Step as Step, Surface as Surface, World as World,
                            open as open, parameters as parameters, play as play, presets as presets)
from tactum.results import Error as Error, Touch as Touch
from tactum.server import Client as Client, Hand as Hand, State as State, connect as connect, serve as serve
