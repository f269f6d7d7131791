package org.robotui.rfic.lcm.internal.session;

import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.port.RawMessage;
import org.robotui.data.record.DynamicRecord;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.LcmValue;
import org.robotui.message.lcm.RecordView;
import org.robotui.message.lcm.UnknownMessage;

/** A channel as records with the fields of its type, or as bytes where the type is not known. */
final class RecordFeed extends Feed<DynamicRecord> {
  private static final String STAMP = "utime";
  private static final long NANOS_PER_MICRO = 1000;

  private final SessionClock clock;
  private String remedy = "";

  RecordFeed(RficContext context, String channel, String help, SessionClock clock) {
    super(context, channel, DynamicRecord.class, help);
    this.clock = clock;
  }

  @Override
  void typed(Optional<LcmType> type, String toDo) {
    remedy = toDo;
  }

  @Override
  String problem() {
    return "";
  }

  @Override
  void decoded(LcmRecord record, LcmMessage message, RawMessage raw) {
    publish(new RecordView(record), clock.stamp(stamp(record)), message, raw);
  }

  /** What nearly all LCM types begin with. */
  private static Optional<Long> stamp(LcmRecord record) {
    return record.member(STAMP).filter(LcmValue.Whole.class::isInstance).map(v -> ((LcmValue.Whole) v).value())
        .filter(v -> Math.abs(v) < Long.MAX_VALUE / NANOS_PER_MICRO).map(v -> v * NANOS_PER_MICRO);
  }

  @Override
  void unknown(LcmMessage message, RawMessage raw) {
    publish(UnknownMessage.of(message.data(), remedy), Optional.empty(), message, raw);
  }
}
