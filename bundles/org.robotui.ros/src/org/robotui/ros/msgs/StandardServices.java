package org.robotui.ros.msgs;

import org.robotui.message.RecordCodec;
import org.robotui.message.ServiceCodec;
import org.robotui.message.ros.nav_msgs.GetMapRequest;
import org.robotui.message.ros.nav_msgs.GetMapResponse;
import org.robotui.message.ros.std_srvs.EmptyRequest;
import org.robotui.message.ros.std_srvs.EmptyResponse;
import org.robotui.message.ros.std_srvs.SetBoolRequest;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.message.ros.std_srvs.TriggerRequest;
import org.robotui.message.ros.std_srvs.TriggerResponse;
import org.robotui.ros.msgs.dynamic_reconfigure.ReconfigureRequest;
import org.robotui.ros.msgs.dynamic_reconfigure.ReconfigureResponse;

/** The service types whose requests and responses are records. */
public final class StandardServices {

  /** An action without arguments or result. */
  public static final ServiceCodec<EmptyRequest, EmptyResponse> EMPTY =
      RecordCodec.service("std_srvs/Empty", EmptyRequest.class, EmptyResponse.class);
  /** A switch. */
  public static final ServiceCodec<SetBoolRequest, SetBoolResponse> SET_BOOL =
      RecordCodec.service("std_srvs/SetBool", SetBoolRequest.class, SetBoolResponse.class);
  /** An action without arguments that may fail. */
  public static final ServiceCodec<TriggerRequest, TriggerResponse> TRIGGER =
      RecordCodec.service("std_srvs/Trigger", TriggerRequest.class, TriggerResponse.class);
  /** The current map. */
  public static final ServiceCodec<GetMapRequest, GetMapResponse> GET_MAP =
      RecordCodec.service("nav_msgs/GetMap", GetMapRequest.class, GetMapResponse.class);
  /** Changes parameters of a running node. */
  public static final ServiceCodec<ReconfigureRequest, ReconfigureResponse> RECONFIGURE = RecordCodec.service(
      "dynamic_reconfigure/Reconfigure", ReconfigureRequest.class, ReconfigureResponse.class);

  private StandardServices() {}
}
