// The generated messages and calls, through this one header: they take a compiler as long as ten of ours.
#pragma once

#include <grpcpp/grpcpp.h>

#include <tactum.grpc.pb.h>
