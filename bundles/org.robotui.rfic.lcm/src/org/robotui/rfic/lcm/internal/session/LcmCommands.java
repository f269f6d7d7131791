package org.robotui.rfic.lcm.internal.session;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.robotui.api.RficContext;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.Offer;
import org.robotui.data.Data;
import org.robotui.data.command.MessageCommand;
import org.robotui.data.command.Motion;
import org.robotui.data.command.RelayMessage;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.RecordTree;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmState;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.rfic.lcm.internal.LcmSettings;
import org.robotui.rfic.lcm.internal.TypeCheck;
import org.robotui.rfic.lcm.internal.call.LcmPorts;
import org.robotui.rfic.lcm.internal.convert.CommandForm;
import org.robotui.rfic.lcm.internal.convert.CommandWriter;
import org.robotui.rfic.lcm.internal.convert.RecordFiller;
import org.robotui.rfic.lcm.internal.language.FaultException;

/** What goes to the robot. A message is sent now or not at all; nothing waits for a connection. */
final class LcmCommands implements CommandSink<MessageCommand>, AutoCloseable {
  private static final String ENCODING = "lcm";
  private static final double SECOND = 1e9;
  /** How long a stop at the end may take; a server that hangs keeps whoever sends to it until the link is closed. */
  private static final Duration STOP = Duration.ofMillis(300);

  private final Lcm lcm;
  private final TypeLibrary types;
  private final LcmChannels channels;
  private final Pulse pulse;
  private final ThreadFactory threads;
  private final List<Offer> offers = new ArrayList<>();
  private final List<String> problems = new ArrayList<>();
  private final Set<String> moving = new HashSet<>();
  /** What we drive now, by channel, each with what stops it. */
  private final Map<String, Runnable> driven = new ConcurrentHashMap<>();
  private volatile boolean closed;

  LcmCommands(RficContext context, Lcm lcm, LcmSettings settings, TypeLibrary types, LcmChannels channels,
      Pulse pulse) {
    this.lcm = lcm;
    this.types = types;
    this.channels = channels;
    this.pulse = pulse;
    this.threads = context.threads();
    settings.commands().forEach(c -> offer(context, c, c.form()));
    offers.add(context.offers().command(LcmPorts.PUBLISH, this));
    offers.add(context.offers().command(LcmPorts.RELAY, this::relay));
  }

  private <D extends Data> void offer(RficContext context, LcmSettings.Command command, CommandForm<D> form) {
    String channel = command.mapping().channel();
    try {
      CommandWriter<D> writer = TypeCheck.writer(command, form, types);
      if (Motion.class.isAssignableFrom(form.data())) {
        moving.add(channel);
      }
      offers.add(context.offers().command(
          new CommandPort<>(channel, form.data(), Arity.MANY,
              channel + ", " + writer.type().name() + ": " + form.help()),
          c -> send(channel, writer, c)));
    } catch (FaultException e) {
      problems.add(e.getMessage());
    }
  }

  /** Which commands cannot be sent as configured. */
  String problem() {
    return String.join("; ", problems);
  }

  private <D extends Data> Sent send(String channel, CommandWriter<D> writer, D command) {
    boolean stops = command instanceof Motion<?> motion && motion.equals(motion.stopped());
    long silence = stops ? 0 : pulse.silentFor(System.nanoTime());
    if (closed) {
      return new Sent.Refused("the connection to " + lcm.url() + " is being closed");
    }
    if (silence > 0) {
      return new Sent.Refused(String.format(Locale.ROOT,
          "the robot has not been heard for %.1f s; nothing is sent into a network that may keep it",
          silence / SECOND));
    }
    try {
      Sent sent = publish(channel, writer.write(command, SessionClock.now()));
      if (sent instanceof Sent.Out) {
        note(channel, writer, command, stops);
      }
      return sent;
    } catch (IllegalArgumentException e) {
      return new Sent.Refused("this is no command for " + channel + ": " + e.getMessage());
    }
  }

  private <D extends Data> void note(String channel, CommandWriter<D> writer, D command, boolean stops) {
    if (stops) {
      driven.remove(channel);
    } else if (command instanceof Motion<?> motion) {
      driven.put(channel, () -> stop(channel, writer, motion));
    }
  }

  private <D extends Data> void stop(String channel, CommandWriter<D> writer, Motion<?> motion) {
    publish(channel, writer.write(writer.form().data().cast(motion.stopped()), SessionClock.now()));
  }

  private Sent publish(String channel, ByteBuffer message) {
    if (!(lcm.state() instanceof LcmState.Connected)) {
      return new Sent.Refused("there is no connection to " + lcm.url());
    }
    try {
      lcm.publish(channel, message);
      return new Sent.Out();
    } catch (IOException | IllegalArgumentException e) {
      return new Sent.Refused(String.valueOf(e.getMessage()));
    }
  }

  @Override
  public Sent send(MessageCommand command) {
    return say(command.topic(), command.type(), own -> encoded(own, command.fields()));
  }

  /** A channel has the type of what is heard there; else that of the message, as two robots may share their types. */
  private Sent relay(RelayMessage said) {
    Sent sent = relayed(said);
    said.answer().told(sent instanceof Sent.Refused refused ? Optional.of(refused.reason()) : Optional.empty());
    return sent;
  }

  private Sent relayed(RelayMessage said) {
    Optional<DynamicRecord> record =
        said.value() instanceof DynamicRecord known ? Optional.of(known) : said.original().record().get();
    Optional<String> type = Optional.of(said.type()).filter(t -> !t.isEmpty())
        .or(() -> channels.find(said.topic()).flatMap(Channel::type).map(LcmType::name))
        .or(() -> record.map(DynamicRecord::schema)).filter(name -> types.type(name).isPresent());
    if (record.isEmpty() || type.isEmpty()) {
      return new Sent.Refused("no type of LCM carries " + said.value().getClass().getSimpleName()
          + " by itself: give the bridge the type of " + said.topic() + " with 'type', and its fields with 'fields'");
    }
    return say(said.topic(), type.get(),
        own -> asItCame(said, own).orElseGet(() -> encoded(own, RecordTree.of(record.get()))));
  }

  /** The bytes begin with what tells whether the type is the same. */
  private static Optional<ByteBuffer> asItCame(RelayMessage said, LcmType own) {
    return said.original().wire().filter(wire -> wire.encoding().equals(ENCODING))
        .map(wire -> wire.bytes().buffer(ByteOrder.BIG_ENDIAN))
        .filter(bytes -> bytes.remaining() >= Long.BYTES && bytes.getLong(bytes.position()) == own.fingerprint());
  }

  private ByteBuffer encoded(LcmType type, Map<String, Object> fields) {
    return type.encode(new RecordFiller(types).fill(type, fields));
  }

  private Sent say(String channel, String typeName, Function<LcmType, ByteBuffer> bytes) {
    Optional<LcmType> type = types.type(typeName);
    if (type.isEmpty()) {
      return new Sent.Refused("no .lcm file declares the type " + typeName);
    }
    Optional<String> other =
        channels.find(channel).flatMap(Channel::type).map(LcmType::name).filter(t -> !t.equals(typeName));
    if (other.isPresent()) {
      return new Sent.Refused(channel + " carries " + other.get() + ", not " + typeName);
    }
    return moving.contains(channel)
        ? new Sent.Refused(channel + " moves the robot; drive it with a view that limits and ends the motion")
        : say(channel, type.get(), bytes);
  }

  private Sent say(String channel, LcmType type, Function<LcmType, ByteBuffer> bytes) {
    try {
      return publish(channel, bytes.apply(type));
    } catch (IllegalArgumentException | ArithmeticException e) {
      return new Sent.Refused(type.name() + " is not filled in like this: " + e.getMessage());
    }
  }

  /** Stops what we drive, where core has not done so; what others drive is left alone. */
  @Override
  public void close() {
    closed = true;
    offers.forEach(Offer::close);
    if (!driven.isEmpty()) {
      CompletableFuture.runAsync(this::stopDriven, work -> threads.newThread(work).start())
          .completeOnTimeout(null, STOP.toMillis(), TimeUnit.MILLISECONDS).join();
    }
  }

  private void stopDriven() {
    driven.keySet().forEach(channel -> Optional.ofNullable(driven.remove(channel)).ifPresent(Runnable::run));
  }
}
