package org.robotui.rfic.rosbridge.internal.session;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.ServiceSchema;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.net.call.Outcome;
import org.robotui.rosbridge.RosApi;

/**
 * What types of messages and services look like. A rosapi of ROS 2 is asked only what does not end it: before version
 * 2.3.0 it ends on any question for the fields of a type since Iron, where messages of Python have a slot that is no
 * field. Every question blocks. Safe for all threads.
 */
public final class BridgeDefinitions {
  /** Came with version 2.3.0, as did the remedy. */
  private static final String REMEDIED = "/rosapi/action_goal_details";
  private static final Set<String> BEFORE_IRON =
      Set.of("crystal", "dashing", "eloquent", "foxy", "galactic", "humble");
  /** What stands in the place of a definition that could not be read. */
  private static final String FAILED = "# failed";

  private final RosApi api;
  private final RosDefinitions known;
  private final Map<String, String> texts = new ConcurrentHashMap<>();
  private volatile Optional<Boolean> safe = Optional.empty();

  /**
   * The definitions of a service.
   *
   * @param request the full text of its request
   * @param response the full text of its response
   */
  public record ServiceText(String request, String response) {}

  @FunctionalInterface
  private interface Question {
    Outcome<String> ask(String type) throws InterruptedException;
  }

  BridgeDefinitions(RosApi api, RosDefinitions known) {
    this.api = api;
    this.known = known;
  }

  /**
   * The definition of a type of messages: what the robot says; where it says nothing, what is known here.
   *
   * @param type its name as the bridge writes it
   * @return its full text with the types that it refers to, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<String> message(String type) throws InterruptedException {
    if (!RosDefinitions.isOfThreeParts(type)) {
      return orKnown(api.message(type), type);
    }
    Optional<String> sent = sent(type);
    return sent.isPresent() ? new Outcome.Done<>(sent.get()) : orKnown(asked(api::message, type), type);
  }

  private Outcome<String> orKnown(Outcome<String> answer, String type) {
    return answer.toOptional().or(() -> known.find(type).map(schema -> schema.info().definition()))
        .<Outcome<String>>map(Outcome.Done::new).orElse(answer);
  }

  /** From the one question that gives the definitions of all topics, which is asked again for a type that is new. */
  private Optional<String> sent(String type) throws InterruptedException {
    if (!texts.containsKey(type)) {
      api.definitions().toOptional().ifPresent(texts::putAll);
    }
    return Optional.ofNullable(texts.get(type)).filter(text -> !text.startsWith(FAILED));
  }

  /**
   * The definition of a type of services. One of ROS 2 that is known here is not asked for.
   *
   * @param type its name as the bridge writes it
   * @return its texts, or why there is no answer
   * @throws InterruptedException if the thread was interrupted
   */
  public Outcome<ServiceText> service(String type) throws InterruptedException {
    Optional<ServiceText> here = RosDefinitions.isOfThreeParts(type) ? knownService(type) : Optional.empty();
    if (here.isPresent()) {
      return new Outcome.Done<>(here.get());
    }
    Outcome<String> request = asked(api::request, type);
    Outcome<String> response = request.toOptional().isEmpty() ? request : asked(api::response, type);
    return response.toOptional().isEmpty() ? new Outcome.Failed<>(response.reason())
        : new Outcome.Done<>(new ServiceText(request.toOptional().get(), response.toOptional().get()));
  }

  private Optional<ServiceText> knownService(String type) {
    return known.ros2Service(type) instanceof SchemaLookup.Found<ServiceSchema> found
        ? Optional.of(new ServiceText(text(found.schema().request()), text(found.schema().response())))
        : Optional.empty();
  }

  private static String text(MessageSchema schema) {
    return schema.info().definition();
  }

  private Outcome<String> asked(Question question, String type) throws InterruptedException {
    return !RosDefinitions.isOfThreeParts(type) || isSafe() ? question.ask(type)
        : new Outcome.Failed<>(
            type + " is not known here, and the robot's rosapi, which is older than 2.3.0, would end "
                + "if it were asked; update rosbridge_suite there, or put the definition where ROS_PACKAGE_PATH or "
                + "AMENT_PREFIX_PATH of this machine leads");
  }

  /** Whether rosapi outlives a question for fields. Where it does not say, it is taken for one that does not. */
  private boolean isSafe() throws InterruptedException {
    if (safe.isEmpty()) {
      Optional<List<String>> services = api.services().toOptional();
      if (services.isEmpty()) {
        return false;
      }
      safe = Optional.of(services.get().contains(REMEDIED)
          || api.distribution().toOptional().filter(BEFORE_IRON::contains).isPresent());
    }
    return safe.get();
  }
}
