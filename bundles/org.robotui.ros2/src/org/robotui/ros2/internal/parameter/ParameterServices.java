package org.robotui.ros2.internal.parameter;

import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.internal.msgs.DescribeParametersAsk;
import org.robotui.ros2.internal.msgs.DescribeParametersReply;
import org.robotui.ros2.internal.msgs.GetParameterTypesAsk;
import org.robotui.ros2.internal.msgs.GetParameterTypesReply;
import org.robotui.ros2.internal.msgs.GetParametersAsk;
import org.robotui.ros2.internal.msgs.GetParametersReply;
import org.robotui.ros2.internal.msgs.ListParametersAsk;
import org.robotui.ros2.internal.msgs.ListParametersReply;
import org.robotui.ros2.internal.msgs.SetParametersAsk;
import org.robotui.ros2.internal.msgs.SetParametersAtomicallyAsk;
import org.robotui.ros2.internal.msgs.SetParametersAtomicallyReply;
import org.robotui.ros2.internal.msgs.SetParametersReply;

/** The services about parameters that each node has. */
final class ParameterServices {

  static final String EVENTS = "/parameter_events";

  private static final String PACKAGE = "rcl_interfaces/srv/";

  private ParameterServices() {}

  static Ros2ServiceCodec<ListParametersAsk, ListParametersReply> list() {
    return Ros2ServiceCodec.of(PACKAGE + "ListParameters", ListParametersAsk.class, ListParametersReply.class);
  }

  static Ros2ServiceCodec<GetParametersAsk, GetParametersReply> get() {
    return Ros2ServiceCodec.of(PACKAGE + "GetParameters", GetParametersAsk.class, GetParametersReply.class);
  }

  static Ros2ServiceCodec<GetParameterTypesAsk, GetParameterTypesReply> types() {
    return Ros2ServiceCodec.of(PACKAGE + "GetParameterTypes", GetParameterTypesAsk.class,
        GetParameterTypesReply.class);
  }

  static Ros2ServiceCodec<DescribeParametersAsk, DescribeParametersReply> describe() {
    return Ros2ServiceCodec.of(PACKAGE + "DescribeParameters", DescribeParametersAsk.class,
        DescribeParametersReply.class);
  }

  static Ros2ServiceCodec<SetParametersAsk, SetParametersReply> set() {
    return Ros2ServiceCodec.of(PACKAGE + "SetParameters", SetParametersAsk.class, SetParametersReply.class);
  }

  static Ros2ServiceCodec<SetParametersAtomicallyAsk, SetParametersAtomicallyReply> setAll() {
    return Ros2ServiceCodec.of(PACKAGE + "SetParametersAtomically", SetParametersAtomicallyAsk.class,
        SetParametersAtomicallyReply.class);
  }
}
