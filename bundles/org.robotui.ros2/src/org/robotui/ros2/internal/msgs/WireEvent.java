package org.robotui.ros2.internal.msgs;

import java.util.List;
import org.robotui.message.MessageType;

/**
 * Parameters of a node that changed ({@code rcl_interfaces/ParameterEvent}).
 *
 * @param stamp when
 * @param node whose
 * @param newParameters those that are new
 * @param changedParameters those that have another value
 * @param deletedParameters those that are gone
 */
@MessageType("rcl_interfaces/ParameterEvent")
public record WireEvent(long stamp, String node, List<WireParameter> newParameters,
    List<WireParameter> changedParameters, List<WireParameter> deletedParameters) {

  /** Copies the lists. */
  public WireEvent {
    newParameters = List.copyOf(newParameters);
    changedParameters = List.copyOf(changedParameters);
    deletedParameters = List.copyOf(deletedParameters);
  }
}
