package org.robotui.rfic.ros2.internal.call;

import java.time.Duration;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.data.MessageRecord;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2ServiceClient;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.Ros2Types.TypedService;
import org.robotui.ros2.name.Ros2Name;

/** Calls services of any type whose definition is known. */
public final class Ros2Services implements CallHandler<ServiceRequest, ServiceReply> {
  private final Ros2Node node;

  /**
   * Creates a caller.
   *
   * @param node calls
   */
  public Ros2Services(Ros2Node node) {
    this.node = node;
  }

  @Override
  public ServiceReply handle(Invocation<ServiceRequest> invocation) throws CallException {
    ServiceRequest request = invocation.request();
    TypedService type = CallOutcomes.found(node.context().types().service(name(request.service())));
    DynamicMessage asked;
    try {
      asked = new DynamicCodec(type.schema().request()).build(request.arguments());
    } catch (MessageException e) {
      throw new CallException(request.service() + " is not asked like this: " + e.getMessage(), e);
    }
    Duration left = Duration.ofNanos(Math.max(1_000_000, invocation.deadlineNanos() - System.nanoTime()));
    try (Ros2ServiceClient<DynamicMessage, DynamicMessage> client =
        node.serviceClient(request.service(), Ros2ServiceCodec.of(type.name(), type.schema()))) {
      return new ServiceReply(new MessageRecord(CallOutcomes.value(client.call(asked, left))));
    }
  }

  static Ros2Name name(String text) throws CallException {
    return Ros2Name.parse(text).orElseThrow(() -> new CallException("'" + text + "' is no name of ROS 2"));
  }
}
