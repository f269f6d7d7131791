package org.robotui.rfic.ros.internal.call;

import java.time.Duration;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.MessageRegistry;
import org.robotui.message.ServiceCodec;
import org.robotui.message.ServiceSchema;
import org.robotui.message.data.MessageRecord;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.ros.RosNode;
import org.robotui.ros.ServiceClient;
import org.robotui.ros.ServiceIdentity;

/** Calls services of any type whose definition is known. */
public final class RosServices implements CallHandler<ServiceRequest, ServiceReply> {
  private final RosNode node;
  private final MessageRegistry registry;

  /**
   * Creates a caller.
   *
   * @param node calls
   * @param registry knows service definitions
   */
  public RosServices(RosNode node, MessageRegistry registry) {
    this.node = node;
    this.registry = registry;
  }

  @Override
  public ServiceReply handle(Invocation<ServiceRequest> invocation) throws CallException {
    ServiceRequest request = invocation.request();
    ServiceIdentity identity = CallOutcomes.value(node.probeService(request.service(), left(invocation)));
    ServiceSchema schema = schema(identity);
    DynamicCodec requests = new DynamicCodec(schema.request());
    DynamicCodec replies = new DynamicCodec(schema.response());
    ServiceCodec<DynamicMessage, DynamicMessage> codec =
        new ServiceCodec<>(identity.type(), schema.md5(), requests, replies);
    try (ServiceClient<DynamicMessage, DynamicMessage> client = node.serviceClient(request.service(), codec, false)) {
      return new ServiceReply(
          new MessageRecord(CallOutcomes.value(client.call(requests.build(request.arguments()), left(invocation)))));
    } catch (MessageException e) {
      throw new CallException(request.service() + " is not asked like this: " + e.getMessage(), e);
    }
  }

  private ServiceSchema schema(ServiceIdentity identity) throws CallException {
    return CallOutcomes.found(registry.service(identity.type(), identity.md5()));
  }

  private static Duration left(Invocation<ServiceRequest> invocation) {
    return Duration.ofNanos(Math.max(1_000_000, invocation.deadlineNanos() - System.nanoTime()));
  }
}
