package org.robotui.rfic.lcm.internal.session;

import java.util.Map;
import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.config.Placed;
import org.robotui.api.port.RawMessage;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.TransformSet;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.rfic.lcm.internal.LcmSettings;
import org.robotui.rfic.lcm.internal.convert.Reception;
import org.robotui.rfic.lcm.internal.convert.Shape;
import org.robotui.rfic.lcm.internal.language.FaultException;
import org.robotui.rfic.lcm.internal.language.Mapping;
import org.robotui.rfic.lcm.internal.language.Source;
import org.robotui.rfic.lcm.internal.language.Values;

/**
 * A channel as data of a type that views know, as the configuration says. It is offered from the beginning, so that
 * connections do not wait for the first message.
 *
 * @param <D> the data
 */
final class MappedFeed<D extends Data> extends Feed<D> {
  private final Mapping mapping;
  private final Shape<D> shape;
  private final Optional<Placed> wantedType;
  private final RficContext context;
  private final TypeLibrary types;
  private final SessionClock clock;
  private Optional<Map<String, Source>> bound = Optional.empty();
  private volatile String problem = "";

  MappedFeed(RficContext context, LcmSettings.Stream stream, Shape<D> shape, TypeLibrary types, SessionClock clock) {
    super(context, stream.port(), shape.data(), stream.mapping().channel() + " as " + shape.form().word());
    this.mapping = stream.mapping();
    this.shape = shape;
    this.wantedType = stream.type();
    this.context = context;
    this.types = types;
    this.clock = clock;
  }

  /** Offers what a configuration says. */
  static MappedFeed<?> of(RficContext context, LcmSettings.Stream stream, TypeLibrary types, SessionClock clock) {
    return new MappedFeed<>(context, stream, stream.shape(), types, clock);
  }

  String channel() {
    return mapping.channel();
  }

  @Override
  boolean wanted() {
    return super.wanted() || shape.data() == TransformSet.class;
  }

  @Override
  void typed(Optional<LcmType> type, String remedy) {
    try {
      bound = Optional.empty();
      bound = type.isEmpty() ? Optional.empty() : Optional.of(bind(type.get()));
      problem = type.isEmpty() ? mapping.channel() + ": " + remedy : "";
    } catch (FaultException e) {
      problem = e.getMessage();
    }
    publication().failed(problem);
  }

  private Map<String, Source> bind(LcmType type) throws FaultException {
    if (wantedType.isPresent() && !wantedType.get().value().equals(type.name())) {
      throw new FaultException(
          wantedType.get().fault(mapping.channel() + " carries " + type.name() + ", not " + wantedType.get().value()));
    }
    return mapping.bind(type, types);
  }

  @Override
  String problem() {
    return problem;
  }

  @Override
  void decoded(LcmRecord record, LcmMessage message, RawMessage raw) {
    if (bound.isEmpty()) {
      return; // the problem was told
    }
    try {
      Values values = new Values(record, bound.get());
      Optional<Stamp> stamp = clock.stamp(values.nanos("stamp"));
      Reception reception =
          new Reception(context.robot(), message.channel(), stamp.orElseGet(() -> clock.received(message)),
              set -> context.frames().add(set, message.channel() + " of " + message.sender()));
      publish(shape.make().of(values, reception), stamp, message, raw);
    } catch (IllegalArgumentException | ArithmeticException | IndexOutOfBoundsException e) {
      lost(message, "as " + shape.form().word() + ", " + e.getMessage());
    }
  }

  @Override
  void unknown(LcmMessage message, RawMessage raw) {
    // there is nothing to be mapped, which was told
  }
}
