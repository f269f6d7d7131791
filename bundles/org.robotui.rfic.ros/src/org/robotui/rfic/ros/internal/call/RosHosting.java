package org.robotui.rfic.ros.internal.call;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import org.robotui.api.port.Offer;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageRegistry;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceCodec;
import org.robotui.message.ServiceSchema;
import org.robotui.message.topic.ServiceHosting;
import org.robotui.net.call.Outcome;
import org.robotui.ros.RosNode;
import org.robotui.ros.ServiceException;
import org.robotui.ros.ServiceIdentity;

/**
 * Offers services to nodes of ROS 1.
 *
 * @param node offers them
 * @param registry knows service definitions
 */
public record RosHosting(RosNode node, MessageRegistry registry) implements ServiceHosting {
  private static final Duration PROBE = Duration.ofSeconds(2);

  @Override
  public SchemaLookup<ServiceSchema> schema(String type) {
    return registry.service(type);
  }

  /** A service that nobody answers for is only registered, by a node that has gone without a word. */
  @Override
  public Optional<String> provider(String service) {
    return node.probeService(service, PROBE).toOptional().map(ServiceIdentity::node)
        .filter(name -> !name.equals(node.name().text()));
  }

  @Override
  public Offer open(String service, ServiceSchema schema, Host host) {
    ServiceCodec<DynamicMessage, DynamicMessage> codec = new ServiceCodec<>(schema.type(), schema.md5(),
        new DynamicCodec(schema.request()), new DynamicCodec(schema.response()));
    return node.serviceServer(service, codec, (request, caller) -> answered(host, request, caller))::close;
  }

  /** Runs on the thread of the client's connection, which waits as its client does. */
  private static DynamicMessage answered(Host host, DynamicMessage request, String caller) throws ServiceException {
    CompletableFuture<Outcome<DynamicMessage>> answer = host.answer(request, caller).toCompletableFuture();
    try {
      Outcome<DynamicMessage> outcome = answer.get();
      return outcome.toOptional().orElseThrow(() -> new ServiceException(outcome.reason()));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new ServiceException("the service has ended");
    } catch (ExecutionException e) {
      throw new ServiceException("the service has failed: " + e.getCause());
    }
  }
}
