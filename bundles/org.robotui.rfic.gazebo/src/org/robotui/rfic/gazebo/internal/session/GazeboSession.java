package org.robotui.rfic.gazebo.internal.session;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import org.robotui.api.RficContext;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Offer;
import org.robotui.api.session.LinkChanges;
import org.robotui.api.session.RobotSession;
import org.robotui.api.session.SessionScope;
import org.robotui.gazebo.GazeboNode;
import org.robotui.gazebo.types.GazeboTypes;
import org.robotui.message.topic.RobotTopics;
import org.robotui.message.topic.SharedTopics;
import org.robotui.message.topic.TopicPorts;
import org.robotui.rfic.gazebo.internal.GazeboSettings;
import org.robotui.rfic.gazebo.internal.call.GazeboBrowser;
import org.robotui.rfic.gazebo.internal.call.GazeboServices;
import org.robotui.rfic.gazebo.internal.scene.KnownScene;
import org.robotui.web.LinkTurns;

/** A node of ours in a partition, while somebody else is there, and all that is offered through it. */
public final class GazeboSession implements RobotSession {
  private static final Duration LOOK = Duration.ofMillis(500);
  private static final Duration INTRODUCTION = Duration.ofSeconds(4);

  private final GazeboSettings settings;
  private final SharedTopics.Group shared;
  private final LinkChanges link;
  private final GazeboTopics world;
  private final RobotTopics topics;
  private final SceneWatch scene;
  private final List<Offer> offers;
  private final CompletableFuture<String> ended = new CompletableFuture<>();
  private final long opened = System.nanoTime();
  private boolean met;
  private long heard;
  private long nextLook = opened;

  private GazeboSession(RficContext context, GazeboSettings settings, SharedTopics.Group shared,
      GazeboNode node, NodeNews news) {
    this.settings = settings;
    this.shared = shared;
    this.link = new LinkChanges(context.link());
    TypeFormats formats = new TypeFormats(GazeboTypes.of(settings.variables()));
    KnownScene known = new KnownScene();
    this.world = new GazeboTopics(node, news, formats, known);
    this.topics = new RobotTopics(context, settings.topics(), world, shared.transforms());
    GazeboServices services = new GazeboServices(node, formats, world::table);
    this.scene = new SceneWatch(context, known, services, world::table);
    this.offers = List.of(context.offers().call(TopicPorts.SERVICES, services),
        context.offers().browse(TopicPorts.GRAPH, new GazeboBrowser(world, formats, services)));
  }

  /**
   * Begins.
   *
   * @param context what core gives
   * @param settings how the simulator is found
   * @param shared what interfaces share that are in the partition
   * @param scope keeps the node until the session has been closed
   * @return the session
   * @throws IOException where the addresses cannot be used
   */
  public static RobotSession open(RficContext context, GazeboSettings settings, SharedTopics.Group shared,
      SessionScope scope) throws IOException {
    NodeNews news = new NodeNews();
    GazeboNode node = scope.closing(GazeboNode.open(settings.options(context.threads()), news), GazeboNode::close);
    return new GazeboSession(context, settings, shared, node, news);
  }

  @Override
  public Optional<String> follow(BooleanSupplier over) throws InterruptedException {
    return LinkTurns.take(ended, over, this::turn);
  }

  /** Looks at all once; answers why the session is over, if it is. */
  private Optional<String> turn() {
    long now = System.nanoTime();
    boolean changed = world.tick();
    boolean there = world.table().isInhabited();
    if (!there && (met || now - opened > INTRODUCTION.toNanos())) {
      return Optional.of(met ? "nobody is heard any more" : "nobody publishes or answers there");
    }
    if (there) {
      met = true;
      look(changed, now);
      link.report(state());
    }
    return Optional.empty();
  }

  private void look(boolean changed, long now) {
    if (world.time().heardNanos() != heard) {
      heard = world.time().heardNanos();
      topics.pulse().heard(heard);
    }
    if (changed || now - nextLook >= 0) {
      nextLook = now + LOOK.toNanos();
      shared.seen(world.table().published().keySet());
      topics.follow(world.table().ports(settings.topics()));
    }
    topics.tick();
    scene.tick(now);
  }

  private LinkState state() {
    String problem = topics.problem();
    return problem.isEmpty() ? new LinkState.Connected(settings.peer())
        : new LinkState.Degraded(settings.peer(), problem);
  }

  @Override
  public void close() {
    ended.complete("");
    topics.stop();
    offers.forEach(Offer::close);
    scene.close();
    topics.close();
    world.close();
  }
}
