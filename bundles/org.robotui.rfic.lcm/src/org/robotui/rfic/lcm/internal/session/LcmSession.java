package org.robotui.rfic.lcm.internal.session;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.net.SocketFactory;
import org.robotui.api.RficContext;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.Offer;
import org.robotui.api.session.LinkChanges;
import org.robotui.api.session.RobotSession;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmState;
import org.robotui.lcm.LcmStatistics;
import org.robotui.lcm.SubscriptionOptions;
import org.robotui.lcm.type.TypeException;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.rfic.lcm.internal.LcmSettings;
import org.robotui.rfic.lcm.internal.call.LcmPorts;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One open connection, and all that is offered through it. */
public final class LcmSession implements RobotSession {
  private static final Logger LOG = LoggerFactory.getLogger(LcmSession.class);
  private static final Duration LOOK = Duration.ofMillis(200);
  /** The thread that receives must not wait for what becomes of messages. */
  private static final SubscriptionOptions QUEUE = SubscriptionOptions.queued(4000);

  private final RficContext context;
  private final TypeLibrary types;
  private final LcmChannels channels;
  private final LinkWatch watch;
  private final Pulse pulse = new Pulse();
  private final Lcm lcm;
  private final LcmCommands commands;
  private final Offer browse;
  /** Where commands go: these channels bring our own messages back, which are no sign of the robot. */
  private final Set<String> commanded;
  private final BooleanSupplier typesChanged;
  private boolean remedyTold;

  /**
   * Opens a connection in the background.
   *
   * @param context what core gives
   * @param settings what is to be offered
   * @param types all types
   * @param sockets makes connections to a server
   * @param typesChanged whether the session is to end, as types have to be read anew
   */
  public LcmSession(RficContext context, LcmSettings settings, TypeLibrary types, SocketFactory sockets,
      BooleanSupplier typesChanged) {
    this.context = context;
    this.types = types;
    this.typesChanged = typesChanged;
    boolean isFile = settings.url().provider().equals("file");
    boolean writes = isFile && !settings.url().options().getOrDefault("mode", "r").equals("r");
    this.commanded =
        settings.commands().stream().map(c -> c.mapping().channel()).collect(Collectors.toUnmodifiableSet());
    this.watch = new LinkWatch(settings.url().toString(), writes, System.nanoTime());
    this.channels = new LcmChannels(context, settings, types, new SessionClock(context, isFile && !writes));
    this.lcm = Lcm.open(settings.url(), LcmOptions.standard(context.threads()).withSockets(sockets));
    lcm.subscribe(".*", QUEUE, this::received);
    this.commands = new LcmCommands(context, lcm, settings, types, channels, pulse);
    this.browse = context.offers().browse(LcmPorts.CHANNELS, new ChannelBrowser(channels, types, lcm));
  }

  private void received(LcmMessage message) {
    if (!commanded.contains(message.channel())) {
      watch.heard(message.received());
      pulse.heard(message.received());
    }
    channels.accept(message);
  }

  /** Watches the connection until the robot interface ends, or types have changed. */
  @Override
  public Optional<String> follow(BooleanSupplier over) throws InterruptedException {
    LinkChanges link = new LinkChanges(context.link());
    while (!over.getAsBoolean()) {
      if (typesChanged.getAsBoolean()) {
        LOG.info("{}: .lcm files have changed and are read anew", context.instance());
        return Optional.empty();
      }
      LcmStatistics statistics = lcm.statistics();
      link.report(watch.state(lcm.state(), statistics, problem(), System.nanoTime()));
      tellRemedy(statistics);
      Thread.sleep(LOOK);
    }
    return Optional.empty();
  }

  private String problem() {
    List<String> problems = new ArrayList<>();
    types.problems().stream().limit(1).map(TypeException::getMessage).forEach(problems::add);
    Stream.of(commands.problem(), channels.problem()).filter(p -> !p.isEmpty()).forEach(problems::add);
    return String.join("; ", problems);
  }

  private void tellRemedy(LcmStatistics statistics) {
    String remedy = LinkWatch.bufferRemedy(statistics);
    if (!remedyTold && !remedy.isEmpty() && lcm.state() instanceof LcmState.Connected) {
      remedyTold = true;
      LOG.info("{}: {}, or long messages may be lost when they come fast", context.instance(), remedy);
    }
  }

  @Override
  public void close() {
    commands.close();
    browse.close();
    lcm.close();
    channels.close();
  }
}
