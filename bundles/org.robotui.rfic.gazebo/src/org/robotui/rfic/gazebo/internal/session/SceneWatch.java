package org.robotui.rfic.gazebo.internal.session;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.robotui.api.port.Arity;
import org.robotui.api.RficContext;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.marker.MarkerSet;
import org.robotui.data.record.DynamicRecord;
import org.robotui.gazebo.OfferedService;
import org.robotui.net.call.Outcome;
import org.robotui.net.thread.Workers;
import org.robotui.rfic.gazebo.internal.call.GazeboServices;
import org.robotui.rfic.gazebo.internal.scene.KnownScene;
import org.robotui.rfic.gazebo.internal.scene.SceneMarkers;

/**
 * Asks a world what stands in it: when it comes, and again when it moves something that was not in it then. For the
 * thread of the session; the question waits on a thread of its own.
 */
final class SceneWatch implements AutoCloseable {
  private static final StreamPort<MarkerSet> PORT =
      new StreamPort<>("scene", MarkerSet.class, Arity.MANY, "What stands in the world.");
  private static final String NAME = "/scene/info";
  private static final Duration PATIENCE = Duration.ofSeconds(5);
  private static final long PAUSE = Duration.ofSeconds(2).toNanos();

  private final RficContext context;
  private final KnownScene scene;
  private final GazeboServices services;
  private final Supplier<WorldTable> table;
  private final Workers workers;
  private final Publication<MarkerSet> publication;
  private final AtomicReference<Optional<DynamicRecord>> answer = new AtomicReference<>(Optional.empty());
  private volatile Optional<OfferedService> known = Optional.empty();
  private volatile boolean asking;
  private volatile Optional<Thread> asker = Optional.empty();
  private long next = System.nanoTime();

  SceneWatch(RficContext context, KnownScene scene, GazeboServices services, Supplier<WorldTable> table) {
    this.context = context;
    this.scene = scene;
    this.services = services;
    this.table = table;
    this.workers = new Workers(context.threads());
    this.publication = context.offers().stream(PORT, Demand.IGNORED);
  }

  /** Asks where it is time, and takes the answer. */
  void tick(long now) {
    answer.getAndSet(Optional.empty()).ifPresent(this::take);
    Optional<OfferedService> there = table.get().graph().services().stream()
        .filter(each -> each.name().name().startsWith("/world/") && each.name().name().endsWith(NAME)).findFirst();
    boolean other = !there.equals(known);
    if (!asking && now - next >= 0 && there.isPresent() && (other || scene.takeAsked())) {
      next = now + PAUSE;
      asking = true;
      known = there;
      workers.start("gazebo scene", () -> ask(there.get()));
    }
  }

  private void ask(OfferedService service) {
    asker = Optional.of(Thread.currentThread());
    try {
      Outcome<DynamicRecord> said = services.ask(service, Map.of(), PATIENCE);
      answer.set(said.toOptional());
      if (said.toOptional().isEmpty()) {
        known = Optional.empty();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      asker = Optional.empty();
      asking = false;
    }
  }

  private void take(DynamicRecord said) {
    String world = known.map(each -> each.name().name().split("/")[2]).orElse("world");
    scene.take(world, said);
    publication.publish(SceneMarkers.of(context.robot(), scene), Optional.empty());
  }

  @Override
  public void close() {
    asker.ifPresent(Thread::interrupt);
    workers.join(System.nanoTime() + PATIENCE.toNanos() / PATIENCE.toSeconds());
    publication.close();
  }
}
