package org.robotui.rfic.carmen.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.robotui.api.RficContext;
import org.robotui.api.link.LinkState;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.Offer;
import org.robotui.api.session.LinkChanges;
import org.robotui.api.session.PlacedFrames;
import org.robotui.api.session.RobotFrames;
import org.robotui.api.session.RobotSession;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.module.IpcModule;
import org.robotui.carmen.module.ParamClient;
import org.robotui.rfic.carmen.internal.call.CarmenBrowser;
import org.robotui.rfic.carmen.internal.call.CarmenCalls;
import org.robotui.rfic.carmen.internal.call.CarmenPorts;
import org.robotui.rfic.carmen.internal.feed.Commanding;
import org.robotui.rfic.carmen.internal.feed.Feeds;
import org.robotui.rfic.carmen.internal.feed.Shared;

/** One module at a central, and all that is offered through it. */
final class CarmenSession implements RobotSession {
  private static final long LOOK_MILLIS = 50;
  private static final long DISCOVER_NANOS = Duration.ofMillis(1000).toNanos();

  private final CarmenSettings settings;
  private final IpcModule module;
  private final PlacedFrames tree;
  private final Pulse pulse = new Pulse();
  private final Feeds feeds;
  private final Commanding commands;
  private final Offer services;
  private final Offer graph;
  private final LinkChanges link;
  private long discoveredAt = System.nanoTime() - DISCOVER_NANOS; // only on the thread that follows

  CarmenSession(RficContext context, CarmenSettings settings, IpcModule module, IpcForms forms) {
    this.settings = settings;
    this.module = module;
    this.link = new LinkChanges(context.link());
    RobotFrames frames = settings.frames().of(context.robot());
    this.tree = new PlacedFrames(context, "carmen", frames.base());
    Shared shared = new Shared(context, settings, module, forms, frames, tree, pulse);
    this.feeds = new Feeds(shared);
    this.commands = new Commanding(shared, feeds);
    this.services = context.offers().call(CarmenPorts.SERVICES, new CarmenCalls(module, feeds));
    this.graph =
        context.offers().browse(CarmenPorts.GRAPH, new CarmenBrowser(feeds, new ParamClient(module, forms)));
  }

  /** Looks every second what the central knows, which tells as well whether it is still there. */
  @Override
  public Optional<String> follow(BooleanSupplier over) throws IOException, InterruptedException {
    while (!over.getAsBoolean()) {
      Optional<String> end = module.over();
      if (end.isPresent()) {
        return end.map(Advice::with);
      }
      look();
      Thread.sleep(LOOK_MILLIS);
    }
    return Optional.empty();
  }

  private void look() {
    long now = System.nanoTime();
    try {
      if (now - discoveredAt >= DISCOVER_NANOS) {
        feeds.discover();
        pulse.answered(System.nanoTime());
        feeds.tick();
        commands.look();
        discoveredAt = now;
      }
      feeds.tick();
      link.report(feeds.isEmpty()
          ? new LinkState.Degraded(settings.peer(),
              "the central is there, but no program of a robot; start base, or simulator and robot")
          : new LinkState.Connected(settings.peer()));
    } catch (IOException e) {
      if (module.over().isEmpty()) {
        link.report(
            new LinkState.Degraded(settings.peer(), Advice.with(e.getMessage()) + "; what is shown may be old"));
      }
    }
  }

  /** Stops what we drive, says goodbye to the central and ends; bounded also where it hangs. */
  @Override
  public void close() {
    commands.close();
    services.close();
    graph.close();
    feeds.close();
    module.close();
    tree.close();
  }
}
