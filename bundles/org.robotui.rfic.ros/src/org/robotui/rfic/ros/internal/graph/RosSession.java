package org.robotui.rfic.ros.internal.graph;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import org.robotui.api.RficContext;
import org.robotui.api.port.Offer;
import org.robotui.api.session.RobotSession;
import org.robotui.message.MessageRegistry;
import org.robotui.message.topic.ActionCalls;
import org.robotui.message.topic.DescriptionPort;
import org.robotui.message.topic.RobotTopics;
import org.robotui.message.topic.ServedActions;
import org.robotui.message.topic.ServedServices;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicGraph;
import org.robotui.message.topic.TopicPorts;
import org.robotui.net.call.Outcome;
import org.robotui.rfic.ros.internal.RosSettings;
import org.robotui.rfic.ros.internal.call.RosActionHosting;
import org.robotui.rfic.ros.internal.call.RosActionRoute;
import org.robotui.rfic.ros.internal.call.RosBrowser;
import org.robotui.rfic.ros.internal.call.RosHosting;
import org.robotui.rfic.ros.internal.call.RosServices;
import org.robotui.rfic.ros.internal.call.RosTunables;
import org.robotui.rfic.ros.internal.convert.RecordDecoder;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.action.ActionWire;

/** One open node, and all that is offered through it. */
public final class RosSession implements RobotSession {
  private static final Duration LOOK = Duration.ofMillis(1000);
  /** Of several interfaces at one master, one asks for all; each looks as often as it would alone. */
  private static final Duration FRESH = Duration.ofMillis(900);
  private static final Duration CLOCK = Duration.ofMillis(50);

  private final RficContext context;
  private final SharedMaster master;
  private final LinkVerdict verdict;
  private final RosNode node;
  private final RobotTopics topics;
  private final DescriptionPort description;
  private final Offer services;
  private final ServedServices served;
  private final Offer serve;
  private final ServedActions<ActionWire> servedActions;
  private final Offer serveAction;
  private final ActionCalls actions;
  private final Offer goals;
  private final RosTunables tunables;
  private final Offer graph;

  /**
   * Opens a node.
   *
   * @param context what core gives
   * @param settings how the robot is reached
   * @param registry knows message definitions
   * @param masters what interfaces share that speak to one master
   * @param care what else the node is given
   * @throws IOException where no node can be opened on this machine
   */
  public RosSession(RficContext context, RosSettings settings, MessageRegistry registry, SharedMasters masters,
      UnaryOperator<NodeOptions> care)
      throws IOException {
    this.context = context;
    this.master = masters.of(settings.master());
    this.verdict = new LinkVerdict(settings.master().toString(), LOOK);
    LinkWatch watch = new LinkWatch();
    NodeOptions options = NodeOptions.standard(context.threads()).withLinks(watch).withRecords(context.stateFolder());
    this.node = RosNode.open(settings.environment(), GraphName.anonymous(settings.node()), care.apply(options));
    TopicClient client = new RosTopicClient(node, new RecordDecoder(registry), watch);
    this.topics = new RobotTopics(context, settings.topics(), client, master.transforms());
    this.description = DescriptionFeed.open(context, node.parameters(), settings.topics(),
        Optional.ofNullable(System.getenv("ROS_PACKAGE_PATH")).orElse(""));
    this.services = context.offers().call(TopicPorts.SERVICES, new RosServices(node, registry));
    this.served = new ServedServices(new RosHosting(node, registry), settings.topics());
    this.serve = context.offers().call(TopicPorts.SERVE, served);
    this.servedActions = new ServedActions<>(new RosActionHosting(node, registry), settings.topics());
    this.serveAction = context.offers().call(TopicPorts.SERVE_ACTION, servedActions);
    this.actions = new ActionCalls(action -> RosActionRoute.open(node, action, registry, context.threads()));
    this.goals = context.offers().call(TopicPorts.ACTIONS, actions);
    this.tunables = new RosTunables(node);
    this.graph = context.offers().browse(TopicPorts.GRAPH, new RosBrowser(node, registry, tunables));
  }

  /** Follows the graph until the node is ended from outside. */
  @Override
  public Optional<String> follow(BooleanSupplier stop) throws InterruptedException {
    CompletableFuture<String> ended = node.whenClosed().toCompletableFuture();
    long nextLook = System.nanoTime();
    while (!stop.getAsBoolean()) {
      if (System.nanoTime() >= nextLook) {
        look();
        nextLook = System.nanoTime() + LOOK.toNanos();
      }
      topics.tick();
      served.tick();
      servedActions.tick();
      description.tick();
      tunables.tick();
      try {
        return Optional.of("our node was ended: " + ended.get(CLOCK.toMillis(), TimeUnit.MILLISECONDS));
      } catch (TimeoutException e) {
        // the usual case: the node lives on
      } catch (ExecutionException e) {
        return Optional.of("our node was ended: " + e.getCause());
      }
    }
    return Optional.empty();
  }

  private void look() {
    switch (master.graph(() -> SharedGraph.ask(node), System.nanoTime(), FRESH.toNanos())) {
      case Outcome.Done<SharedGraph> d -> seen(GraphSnapshot.of(d.value(), node.name().text()));
      case Outcome<SharedGraph> other -> verdict.unanswered(other, topics.flowing()).ifPresent(context.link()::report);
    }
  }

  private void seen(TopicGraph snapshot) {
    topics.pulse().answered(System.nanoTime());
    topics.follow(snapshot);
    context.link().report(verdict.answered(topics.problem()));
  }

  /**
   * The master hears of it early: of many robots that are closed at once, each takes its time. But a stop must have
   * gone out by then.
   */
  @Override
  public void close() {
    topics.stop();
    node.leave();
    services.close();
    serve.close();
    served.close();
    serveAction.close();
    servedActions.close();
    goals.close();
    actions.close();
    tunables.close();
    graph.close();
    topics.close();
    description.close();
    node.close();
  }
}
