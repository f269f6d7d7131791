package org.robotui.ros.reconfigure;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.robotui.message.RecordCodec;
import org.robotui.net.call.Outcome;
import org.robotui.ros.GraphName;
import org.robotui.ros.RosNode;
import org.robotui.ros.ServiceClient;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.msgs.StandardServices;
import org.robotui.ros.msgs.dynamic_reconfigure.Config;
import org.robotui.ros.msgs.dynamic_reconfigure.ConfigDescription;
import org.robotui.ros.msgs.dynamic_reconfigure.ReconfigureRequest;
import org.robotui.ros.msgs.dynamic_reconfigure.ReconfigureResponse;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The two topics and the service of a server, from the client's side. */
final class ReconfigureLinks implements ReconfigureClient {

  private static final Logger LOG = LoggerFactory.getLogger(ReconfigureLinks.class);

  private final GraphName server;
  private final ReconfigureListener listener;
  private final Subscriber descriptions;
  private final Subscriber updates;
  private final ServiceClient<ReconfigureRequest, ReconfigureResponse> service;
  private final CountDownLatch described = new CountDownLatch(1);
  private final CountDownLatch told = new CountDownLatch(1);
  private volatile Optional<ServerDescription> description = Optional.empty();
  private volatile Optional<ConfigValues> values = Optional.empty();

  ReconfigureLinks(RosNode node, GraphName name, ReconfigureListener listener) {
    this.listener = listener;
    server = node.names().resolve(name.text());
    SubscriberOptions standard = SubscriberOptions.standard();
    descriptions = node.subscriber(server + "/parameter_descriptions", RecordCodec.of(ConfigDescription.class),
        standard, (message, from) -> describe(message));
    updates = node.subscriber(server + "/parameter_updates", RecordCodec.of(Config.class), standard,
        (message, from) -> update(Configs.values(message)));
    service = node.serviceClient(server + "/set_parameters", StandardServices.RECONFIGURE, false);
  }

  private void describe(ConfigDescription message) {
    Optional<ServerDescription> read = Configs.description(message);
    if (read.isEmpty()) {
      LOG.warn("{} describes more than {} parameters: ignored", server, Configs.MAX_PARAMETERS);
      return;
    }
    description = read;
    described.countDown();
    listener.onDescription(read.get());
  }

  private void update(ConfigValues now) {
    values = Optional.of(now);
    told.countDown();
    listener.onValues(now);
  }

  @Override
  public Optional<ServerDescription> description() {
    return description;
  }

  @Override
  public Optional<ConfigValues> values() {
    return values;
  }

  @Override
  public boolean await(Duration patience) {
    long deadline = System.nanoTime() + patience.toNanos();
    try {
      return described.await(patience.toNanos(), TimeUnit.NANOSECONDS)
          && told.await(deadline - System.nanoTime(), TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  @Override
  public Outcome<ConfigValues> set(Map<String, ?> changes, Duration timeout) {
    Optional<ServerDescription> known = description;
    if (known.isEmpty()) {
      return new Outcome.Refused<>(server + " did not describe its parameters yet");
    }
    List<String> problems = new ArrayList<>();
    Map<String, ConfigValue> wanted = new LinkedHashMap<>();
    changes.forEach((name, value) -> read(known.get(), name, value, wanted, problems));
    if (!problems.isEmpty()) {
      return new Outcome.Refused<>(server + ": " + String.join("; ", problems));
    }
    return service.call(new ReconfigureRequest(Configs.message(wanted)), timeout)
        .map(response -> Configs.values(response.config()));
  }

  private static void read(ServerDescription known, String name, Object value, Map<String, ConfigValue> wanted,
      List<String> problems) {
    known.parameter(name).ifPresentOrElse(
        parameter -> ConfigValue.of(parameter.kind(), value).ifPresentOrElse(
            fitting -> wanted.put(name, fitting),
            () -> problems.add("'" + value + "' is no " + parameter.kind() + " for " + name)),
        () -> problems.add("there is no parameter " + name));
  }

  @Override
  public void close() {
    descriptions.close();
    updates.close();
    service.close();
  }
}
