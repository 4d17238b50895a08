from tactum._tactum import (Contact as Contact, Layer as Layer, Object as Object, Parameter as Parameter, Preset as Preset,
                            Recording as Recording, Scene as Scene, Step as Step, Surface as Surface, World as World,
                            open as open, parameters as parameters, play as play, presets as presets)
from tactum.results import Error as Error, Touch as Touch
from tactum.server import Client as Client, State as State, connect as connect, serve as serve
