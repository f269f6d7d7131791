package org.robotui.rfic.ros2.internal.graph;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.robotui.api.RficContext;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Offer;
import org.robotui.api.session.LinkChanges;
import org.robotui.api.session.RobotSession;
import org.robotui.message.topic.ActionCalls;
import org.robotui.message.topic.DescriptionTopics;
import org.robotui.message.topic.RobotTopics;
import org.robotui.message.topic.ServedActions;
import org.robotui.message.topic.ServedServices;
import org.robotui.message.topic.TopicPorts;
import org.robotui.rfic.ros2.internal.Ros2Settings;
import org.robotui.rfic.ros2.internal.call.DescriptionParameters;
import org.robotui.rfic.ros2.internal.call.NodeParameters;
import org.robotui.rfic.ros2.internal.call.Ros2ActionHosting;
import org.robotui.rfic.ros2.internal.call.Ros2ActionRoute;
import org.robotui.rfic.ros2.internal.call.Ros2Browser;
import org.robotui.rfic.ros2.internal.call.Ros2Hosting;
import org.robotui.rfic.ros2.internal.call.Ros2Services;
import org.robotui.rfic.ros2.internal.convert.TypeLookups;
import org.robotui.ros2.Ros2Context;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Types.TypedAction;
import org.robotui.ros2.graph.GraphState;
import org.robotui.rtps.Discovery;
import org.robotui.rtps.GuidPrefix;

/** One node of ours in the domain of the robot, and all that is offered through it. */
public final class Ros2Session implements RobotSession {
  private static final Duration LOOK = Duration.ofMillis(1000);
  private static final Duration CLOCK = Duration.ofMillis(50);
  private static final String TIME = "/clock";

  private final Ros2Settings settings;
  private final Ros2Context ros;
  private final SharedDomain domain;
  private final DomainChanges changes;
  private final LinkChanges link;
  private final Ros2Node node;
  private final TypeLookups lookups;
  private final Ros2TopicClient client;
  private final RobotTopics topics;
  private final DescriptionTopics description;
  private final ServedServices served;
  private final ServedActions<TypedAction> servedActions;
  private final ActionCalls actions;
  private final NodeParameters parameters;
  private final DescriptionParameters described;
  private final List<Offer> offers = new ArrayList<>();
  private final CountDownLatch closed = new CountDownLatch(1);

  /**
   * Opens a node.
   *
   * @param context what core gives
   * @param settings how the robot is found
   * @param ros takes part in its domain; closed after this
   * @param domain what interfaces of this process share there
   */
  public Ros2Session(RficContext context, Ros2Settings settings, Ros2Context ros, SharedDomain domain) {
    this.settings = settings;
    this.ros = ros;
    this.domain = domain;
    this.link = new LinkChanges(context.link());
    this.changes = new DomainChanges(ros);
    this.node = ros.node(domain.nodeName(settings.node()));
    this.lookups = new TypeLookups(ros.types(), context.threads());
    this.client = new Ros2TopicClient(node, lookups);
    this.topics = new RobotTopics(context, settings.topics(), client, domain.transforms());
    this.description = new DescriptionTopics(context, settings.topics(), settings.packages(), client);
    this.served = new ServedServices(new Ros2Hosting(node), settings.topics());
    this.servedActions = new ServedActions<>(new Ros2ActionHosting(node), settings.topics());
    this.actions = new ActionCalls(action -> Ros2ActionRoute.open(node, action, context.threads()));
    this.parameters = new NodeParameters(node);
    this.described =
        new DescriptionParameters(node, parameters, settings.topics(), description, context.threads());
    offers.add(context.offers().call(TopicPorts.SERVICES, new Ros2Services(node)));
    offers.add(context.offers().call(TopicPorts.SERVE, served));
    offers.add(context.offers().call(TopicPorts.SERVE_ACTION, servedActions));
    offers.add(context.offers().call(TopicPorts.ACTIONS, actions));
    offers.add(context.offers().browse(TopicPorts.GRAPH, new Ros2Browser(node, parameters)));
  }

  /** Follows the graph until the robot interface is closed. */
  @Override
  public Optional<String> follow(BooleanSupplier stop) throws InterruptedException {
    long nextLook = System.nanoTime();
    do {
      if (changes.since() || System.nanoTime() >= nextLook) {
        look();
        nextLook = System.nanoTime() + LOOK.toNanos();
      }
      topics.tick();
      served.tick();
      servedActions.tick();
      description.tick();
      parameters.tick();
    } while (!stop.getAsBoolean() && !closed.await(CLOCK.toMillis(), TimeUnit.MILLISECONDS));
    return Optional.empty();
  }

  private void look() {
    GraphState state = ros.graph().state();
    DomainView view = new DomainView(state, settings, domain::isOurs);
    domain.seen(view.namespaces());
    node.clock().simulated(view.published(TIME).isPresent());
    client.seen(state);
    topics.follow(description.follow(view.topics()));
    if (!changes.over()) {
      described.look();
    }
    Set<GuidPrefix> robot = view.robot();
    if (heard(robot)) {
      topics.pulse().answered(System.nanoTime());
    }
    if (!changes.over()) {
      link.report(robot.isEmpty() ? away() : there());
    }
  }

  /** Whether any program of the robot has said something just now, if only that it is there. */
  private boolean heard(Set<GuidPrefix> robot) {
    Discovery discovery = ros.participant().discovery();
    long since = System.nanoTime() - LOOK.toNanos();
    return robot.stream().flatMap(each -> discovery.heardNanos(each).stream().boxed()).anyMatch(at -> at - since > 0);
  }

  private LinkState there() {
    String problem = topics.problem();
    return problem.isEmpty() ? new LinkState.Connected(settings.peer())
        : new LinkState.Degraded(settings.peer(), problem);
  }

  private LinkState away() {
    String where = settings.topics().namespace();
    String who = where.equals("/") ? "no program of a robot" : "no program of a robot in the namespace " + where;
    String lost = changes.lost().map(reason -> "; the last one: " + reason).orElse("");
    return new LinkState.Failed(who + " is heard: " + settings.peer() + lost, LOOK);
  }

  /** A stop goes out first. The node says farewell, and its participant where it was the last. */
  @Override
  public void close() {
    changes.close();
    topics.stop();
    closed.countDown();
    offers.forEach(Offer::close);
    served.close();
    servedActions.close();
    actions.close();
    lookups.close();
    described.close();
    parameters.close();
    description.close();
    topics.close();
    node.close();
  }
}
