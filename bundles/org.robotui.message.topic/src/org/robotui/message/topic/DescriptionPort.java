package org.robotui.message.topic;

import java.util.List;
import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.joint.RobotDescription;

/**
 * What the robot is made of, as a stream: offered while it is known, and said again when it changes. Any thread notes
 * what came; the one that follows the graph offers and publishes.
 */
public final class DescriptionPort implements AutoCloseable {
  /** The name by which robots of ROS give it, and that of the port. */
  public static final String NAME = "robot_description";
  /** What the name of the semantic part ends with. */
  public static final String SEMANTIC = "_semantic";

  private final RficContext context;
  private final String source;
  private final String port;
  private final String help;
  private final List<String> roots;
  private volatile String urdf = "";
  private volatile String srdf = "";
  private Optional<Publication<RobotDescription>> publication = Optional.empty();
  private Optional<RobotDescription> told = Optional.empty();
  private boolean closed;

  /**
   * Knows nothing yet.
   *
   * @param context what core gives
   * @param settings names the port
   * @param what where it comes from, for users, such as {@code the parameter}
   * @param roots folders in which packages are looked for that it names
   */
  public DescriptionPort(RficContext context, TopicSettings settings, String what, List<String> roots) {
    this.context = context;
    this.source = settings.topic(NAME);
    this.port = settings.portName(source);
    this.help = what + " " + source;
    this.roots = List.copyOf(roots);
  }

  /**
   * Where it comes from.
   *
   * @return the robot's name of it
   */
  public String source() {
    return source;
  }

  /**
   * Takes the model.
   *
   * @param text URDF; empty where the robot has none any more
   */
  public void model(String text) {
    urdf = bounded(text);
  }

  /**
   * Takes the semantic part.
   *
   * @param text SRDF; empty where the robot has none any more
   */
  public void semantics(String text) {
    srdf = bounded(text);
  }

  private static String bounded(String text) {
    return text.isBlank() || text.length() > RobotDescription.LONGEST ? "" : text;
  }

  /** Offers and publishes what came since. */
  public synchronized void tick() {
    Optional<RobotDescription> now = now();
    if (closed || now.equals(told)) {
      return;
    }
    told = now;
    if (now.isEmpty()) {
      withdraw();
      return;
    }
    if (publication.isEmpty()) {
      publication = Optional.of(context.offers().stream(
          new StreamPort<>(port, RobotDescription.class, Arity.MANY, help), Demand.IGNORED));
    }
    publication.get().publish(now.get(), Optional.empty());
  }

  private Optional<RobotDescription> now() {
    String model = urdf;
    return model.isEmpty() ? Optional.empty()
        : Optional.of(new RobotDescription(context.robot(), source, model, srdf, roots));
  }

  private void withdraw() {
    publication.ifPresent(Publication::close);
    publication = Optional.empty();
  }

  /** Withdraws the offer. */
  @Override
  public synchronized void close() {
    closed = true;
    withdraw();
  }
}
