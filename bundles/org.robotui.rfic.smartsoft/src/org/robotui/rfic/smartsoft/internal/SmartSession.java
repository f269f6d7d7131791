package org.robotui.rfic.smartsoft.internal;

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
import org.robotui.rfic.smartsoft.internal.call.SmartBrowser;
import org.robotui.rfic.smartsoft.internal.call.SmartCalls;
import org.robotui.rfic.smartsoft.internal.call.SmartPorts;
import org.robotui.rfic.smartsoft.internal.feed.NamingDirectory;
import org.robotui.rfic.smartsoft.internal.feed.SmartServices;
import org.robotui.rfic.smartsoft.internal.feed.SmartCommanding;
import org.robotui.rfic.smartsoft.internal.feed.SmartNavigation;
import org.robotui.rfic.smartsoft.internal.feed.SmartShared;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.wire.LinkOptions;

/** The components that a naming service knows. It goes on without that one as long as a component is linked. */
final class SmartSession implements RobotSession {
  private static final long LOOK_MILLIS = 50;
  private static final long DISCOVER_NANOS = Duration.ofMillis(1000).toNanos();

  private final SmartSettings settings;
  private final NamingDirectory directory;
  private final PlacedFrames tree;
  private final Pulse pulse = new Pulse();
  private final SmartServices services;
  private final SmartNavigation navigation;
  private final SmartCommanding commands;
  private final Offer calls;
  private final Offer graph;
  private final LinkChanges link;
  private long discoveredAt = System.nanoTime() - DISCOVER_NANOS; // only on the thread that follows
  private Optional<String> unheard = Optional.empty(); // only on the thread that follows

  SmartSession(RficContext context, SmartSettings settings, NamingDirectory directory, CommTypes types,
      LinkOptions links) {
    this.settings = settings;
    this.directory = directory;
    this.link = new LinkChanges(context.link());
    RobotFrames frames = settings.frames().of(context.robot());
    this.tree = new PlacedFrames(context, "smartsoft", frames.base());
    SmartShared shared = new SmartShared(context, settings, links, types, frames, tree, pulse);
    this.services = new SmartServices(shared, directory);
    this.navigation = new SmartNavigation(shared, services);
    this.commands = new SmartCommanding(shared, services, navigation::halt);
    this.calls = context.offers().call(SmartPorts.SERVICES, new SmartCalls(services, links));
    this.graph = context.offers().browse(SmartPorts.GRAPH, new SmartBrowser(services, types, links));
  }

  /** Looks every second what the naming service knows. */
  @Override
  public Optional<String> follow(BooleanSupplier over) throws InterruptedException {
    while (!over.getAsBoolean()) {
      look();
      if (unheard.isPresent() && !services.isAlive() && !commands.isAlive()) {
        return unheard.map(SmartAdvice::with);
      }
      Thread.sleep(LOOK_MILLIS);
    }
    return Optional.empty();
  }

  private void look() {
    long now = System.nanoTime();
    if (now - discoveredAt >= DISCOVER_NANOS) {
      discover();
      commands.look();
      navigation.look();
      discoveredAt = now;
    }
    services.tick();
    link.report(state());
  }

  private void discover() {
    try {
      services.discover();
      pulse.answered(System.nanoTime());
      unheard = Optional.empty();
    } catch (IOException e) {
      unheard = Optional.of(String.valueOf(e.getMessage()));
    }
  }

  private LinkState state() {
    if (unheard.isPresent()) {
      return new LinkState.Degraded(settings.peer(), SmartAdvice.with(unheard.get())
          + "; components that are linked go on, others are not found");
    }
    return services.isEmpty()
        ? new LinkState.Degraded(settings.peer(),
            "the naming service is there, but no component; start those of the robot")
        : new LinkState.Connected(settings.peer());
  }

  /** Stops what we drive, says goodbye to all components and ends; bounded also where they hang. */
  @Override
  public void close() {
    directory.close();
    navigation.close();
    commands.close();
    calls.close();
    graph.close();
    services.close();
    tree.close();
  }
}
