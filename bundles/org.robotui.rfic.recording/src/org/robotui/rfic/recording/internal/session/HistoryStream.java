package org.robotui.rfic.recording.internal.session;

import org.robotui.api.replay.HistoryTaker;
import org.robotui.message.data.Adapter;
import org.robotui.message.data.FrameNames;
import org.robotui.message.payload.ReceptionRule;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.HistoryConversion;
import org.robotui.message.topic.TopicListener;
import org.robotui.recording.RecordedMessage;

/**
 * A port that can be read whole.
 *
 * @param port its name
 * @param rule which channels go to it
 * @param conversion makes values of their messages
 * @param <M> the Java value of a message
 */
record HistoryStream<M>(String port, ReceptionRule<M> rule, HistoryConversion<M> conversion) {
  /** As an adapter reads a topic. */
  static <M> HistoryStream<M> of(Adapter<M, ?> adapter, String topic, String port, FrameNames names) {
    return new HistoryStream<>(port, new ReceptionRule<>(topic, adapter.type(), adapter.form()),
        HistoryConversion.of(adapter, port, () -> names));
  }

  /** Reads it once, for one taker. */
  Run<M> run(TopicTable table, String file, HistoryTaker taker) {
    return new Run<>(this, table, file, taker);
  }

  /** How many messages it has. */
  long count(TopicTable table) {
    return table.all().filter(each -> rule.takes(each.topic(), each.format())).mapToLong(PlayedChannel::count).sum();
  }

  /** One reading, on one thread; a reception of its own, so that nothing of what is played is touched. */
  static final class Run<M> implements TopicListener<M> {
    private final HistoryStream<M> stream;
    private final HistoryTaker taker;
    private final Reception<M> reception;
    private long time;

    private Run(HistoryStream<M> stream, TopicTable table, String file, HistoryTaker taker) {
      this.stream = stream;
      this.taker = taker;
      this.reception = new Reception<>(stream.rule(), table, file, stream.port(), this, ended -> {});
    }

    Reception<M> reception() {
      return reception;
    }

    void give(RecordedMessage message) {
      time = message.logTime();
      reception.deliver(message, System.nanoTime());
    }

    @Override
    public void received(M message, Arrival arrival) {
      try {
        stream.conversion().convert(message, arrival, time).ifPresent(taker::take);
      } catch (IllegalArgumentException | ArithmeticException e) {
        unreadable(String.valueOf(e.getMessage()), arrival);
      }
    }

    @Override
    public void unreadable(String reason, Arrival arrival) {
      taker.unreadable(stream.port(), reason);
    }
  }
}
