package org.robotui.rfic.lcm.internal.session;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.robotui.api.RficContext;
import org.robotui.api.port.RawDefinition;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.RawOrigin;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.RecordException;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.lcm.type.TypeText;
import org.robotui.message.lcm.RecordView;
import org.robotui.message.lcm.UnknownMessage;

/** One channel. Messages come from one thread; what is asked of it comes from any. */
final class Channel implements AutoCloseable {
  private static final String ENCODING = "lcm";

  private final String name;
  private final RficContext context;
  private final TypeLibrary types;
  private final SessionClock clock;
  private final Tally tally = new Tally();
  private final List<Feed<?>> feeds;
  private final boolean mapped;
  private volatile Optional<LcmType> type = Optional.empty();
  private volatile String fingerprint = "";
  private volatile String remedy = "";
  private boolean typed;

  Channel(String name, List<MappedFeed<?>> mapped, RficContext context, TypeLibrary types, SessionClock clock) {
    this.name = name;
    this.context = context;
    this.types = types;
    this.clock = clock;
    this.feeds = new ArrayList<>(mapped);
    this.mapped = !mapped.isEmpty();
  }

  String name() {
    return name;
  }

  /** A message came. */
  synchronized void accept(LcmMessage message) {
    tally.heard(message);
    String found = UnknownMessage.fingerprint(message.data());
    if (!typed || !found.equals(fingerprint)) {
      retyped(found);
    }
    if (feeds.stream().anyMatch(Feed::wanted)) {
      give(message);
    }
  }

  private void give(LcmMessage message) {
    if (type.isEmpty()) {
      RawMessage raw =
          raw("unknown " + fingerprint, message, RawMessage.Reader.NONE, Optional::empty);
      feeds.stream().filter(Feed::wanted).forEach(f -> f.unknown(message, raw));
      return;
    }
    try {
      LcmRecord record = type.get().decode(message.data());
      Optional<DynamicRecord> view = Optional.of(new RecordView(record));
      LcmType of = type.get();
      RawMessage raw = raw(of.name(), message, bytes -> view, () -> Optional.of(definition(of)));
      feeds.stream().filter(Feed::wanted).forEach(f -> f.decoded(record, message, raw));
    } catch (RecordException e) {
      feeds.stream().filter(Feed::wanted).forEach(f -> f.lost(message, e.getMessage()));
    }
  }

  private RawMessage raw(String schema, LcmMessage message, RawMessage.Reader reader,
      Supplier<Optional<RawDefinition>> definition) {
    return new RawMessage(schema, ENCODING, Bytes.wrap(message.data()), reader,
        new RawOrigin(name, message.sender(), false, definition));
  }

  private RawDefinition definition(LcmType of) {
    byte[] text = TypeText.of(of, types).getBytes(StandardCharsets.UTF_8);
    return new RawDefinition(of.name(), ENCODING, Bytes.of(text));
  }

  /** The sender means another type than before, or has just begun. */
  private void retyped(String found) {
    typed = true;
    fingerprint = found;
    type = types(found).stream().findFirst();
    remedy = type.isPresent() ? "" : remedyFor(found);
    if (!mapped) {
      feeds.forEach(Feed::close);
      feeds.clear();
      feeds.add(new RecordFeed(context, name, name + ", " + typeName(), clock));
    }
    feeds.forEach(f -> f.typed(type, remedy));
  }

  private List<LcmType> types(String found) {
    return found.isEmpty() ? List.of() : types.withFingerprint(Long.parseUnsignedLong(found.substring(2), 16));
  }

  private String remedyFor(String found) {
    String files = types.types().isEmpty() ? "write after types: where the .lcm files of the robot are"
        : "add the .lcm file that its sender was built with to those after types:";
    return found.isEmpty() ? "its messages are shorter than the fingerprint of a type"
        : "none of the " + types.types().size() + " known types has the fingerprint " + found + "; " + files;
  }

  /** The type of its messages, or its fingerprint. */
  String typeName() {
    return type.map(LcmType::name).orElse(fingerprint.isEmpty() ? "bytes" : "unknown type " + fingerprint);
  }

  Optional<LcmType> type() {
    return type;
  }

  String fingerprint() {
    return fingerprint;
  }

  String remedy() {
    return remedy;
  }

  Tally.Heard heard() {
    return tally.heard();
  }

  /** What is wanted of it but cannot be given. */
  synchronized String problem() {
    return feeds.stream().filter(Feed::wanted).map(Feed::problem).filter(p -> !p.isEmpty())
        .collect(Collectors.joining("; "));
  }

  /** Whether nobody would miss it. */
  synchronized boolean isIdle() {
    return !mapped && feeds.stream().noneMatch(Feed::wanted);
  }

  @Override
  public synchronized void close() {
    feeds.forEach(Feed::close);
  }
}
