package org.robotui.rfic.rosbridge.internal.call;

import java.time.Duration;
import java.util.Map;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.message.DefinitionException;
import org.robotui.message.MessageSchema;
import org.robotui.message.payload.JsonFormat;
import org.robotui.message.payload.JsonRecord;
import org.robotui.message.topic.CallOutcomes;
import org.robotui.net.call.Outcome;
import org.robotui.rfic.rosbridge.internal.session.BridgeDefinitions;
import org.robotui.rfic.rosbridge.internal.session.BridgeDefinitions.ServiceText;
import org.robotui.rfic.rosbridge.internal.session.BridgeTopics;
import org.robotui.rosbridge.RosApi;
import org.robotui.rosbridge.RosbridgeClient;

/** Calls services. Where the robot tells what a request looks like, it is checked before it is sent. */
public final class BridgeServices implements CallHandler<ServiceRequest, ServiceReply> {
  private final RosbridgeClient client;
  private final RosApi api;
  private final BridgeDefinitions definitions;
  private final BridgeTopics topics;

  /**
   * Creates a caller.
   *
   * @param client calls
   * @param api knows what there is
   * @param definitions of services
   * @param topics knows how the robot writes messages
   */
  public BridgeServices(RosbridgeClient client, RosApi api, BridgeDefinitions definitions, BridgeTopics topics) {
    this.client = client;
    this.api = api;
    this.definitions = definitions;
    this.topics = topics;
  }

  @Override
  public ServiceReply handle(Invocation<ServiceRequest> invocation) throws CallException, InterruptedException {
    ServiceRequest request = invocation.request();
    String type = CallOutcomes.asked(() -> api.serviceType(request.service()));
    Map<String, Object> arguments = arguments(type, request);
    Duration left = Duration.ofNanos(Math.max(1_000_000, invocation.deadlineNanos() - System.nanoTime()));
    return new ServiceReply(new JsonRecord(type + "Response",
        CallOutcomes.asked(() -> client.call(request.service(), arguments, left))));
  }

  private Map<String, Object> arguments(String type, ServiceRequest request)
      throws CallException, InterruptedException {
    Outcome<ServiceText> text = definitions.service(type);
    if (!(text instanceof Outcome.Done<ServiceText> done)) {
      return request.arguments();
    }
    try {
      MessageSchema schema =
          MessageSchema.parse(type + "Request", done.value().request(), topics.commandFormat().generation());
      return topics.commandFormat().tree(JsonFormat.message(schema, request.arguments()));
    } catch (DefinitionException e) {
      return request.arguments();
    } catch (IllegalArgumentException e) {
      throw new CallException(request.service() + " is not asked like this: " + e.getMessage(), e);
    }
  }
}
