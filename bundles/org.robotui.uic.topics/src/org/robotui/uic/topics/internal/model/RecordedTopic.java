package org.robotui.uic.topics.internal.model;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import org.robotui.api.port.Input;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.replay.StreamHistory;
import org.robotui.api.replay.TimeRange;
import org.robotui.data.Data;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;

/**
 * Lists the messages of one topic of a recording around the position of the timeline. Of a message only what is in a
 * row is kept, and the content of the one that is shown. Files are read on a worker, one task at a time; all else is
 * the tick's.
 */
final class RecordedTopic {
  /** Of longer messages the first bytes are shown. */
  static final int MOST_BYTES = 1 << 16;
  private static final String LIVE = "All messages are listed for recordings only; Echo lists those that arrive.";

  private final Input<Data> input;
  private final Executor worker;
  private Optional<SourceId> source = Optional.empty();
  private Optional<StreamHistory> history = Optional.empty();
  private volatile MessageRows rows = MessageRows.NONE;
  private volatile Optional<MessageContent> content = Optional.empty();
  private volatile String failure = "";
  private volatile boolean busy;
  private MessageListing listing = MessageListing.NOTHING;

  RecordedTopic(Input<Data> input, Executor worker) {
    this.input = input;
    this.worker = worker;
  }

  /** What is listed now; the same object where nothing has changed. */
  MessageListing follow(Optional<SourceId> wanted, String obstacle) {
    Optional<StreamHistory> found = wanted.flatMap(input::history);
    if (!wanted.equals(source) || !found.equals(history)) {
      source = wanted;
      history = found;
      rows = MessageRows.NONE;
      content = Optional.empty();
      failure = "";
    }
    MessageListing next = listing(wanted, obstacle);
    listing = next.equals(listing) ? listing : next;
    return listing;
  }

  private MessageListing listing(Optional<SourceId> wanted, String obstacle) {
    if (wanted.isEmpty() || history.isEmpty()) {
      return obstacle.isEmpty() && wanted.isEmpty() ? MessageListing.NOTHING
          : MessageListing.obstacle(obstacle.isEmpty() ? LIVE : obstacle);
    }
    StreamHistory all = history.get();
    long position = all.timeline().state().position() - all.offset();
    Optional<TimedMessage> current = rows.holds(position) ? rows.at(position) : Optional.empty();
    read(all, wanted.get().port(), position, current);
    if (!failure.isEmpty()) {
      return MessageListing.obstacle(failure);
    }
    Optional<MessageContent> shown = content.filter(each -> current.filter(each.message()::equals).isPresent());
    return new MessageListing(history, "", rows.rows(), current, shown);
  }

  /** Has what is missing read. */
  private void read(StreamHistory all, String port, long position, Optional<TimedMessage> current) {
    boolean moved = !rows.holds(position);
    boolean opens = current.isPresent() && content.map(MessageContent::message).filter(current.get()::equals).isEmpty();
    if (busy || !failure.isEmpty() || !moved && !opens) {
      return;
    }
    busy = true;
    worker.execute(() -> {
      try {
        if (moved) {
          rows = MessageRows.read(all, port, position);
        } else {
          content = content(all, port, current.orElseThrow());
        }
      } catch (IOException e) {
        failure = "The recording cannot be read: " + e.getMessage();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      } finally {
        busy = false;
      }
    });
  }

  private static Optional<MessageContent> content(StreamHistory all, String port, TimedMessage message)
      throws IOException, InterruptedException {
    long start = message.time() - (message.place() == 0 ? message.gap().orElse(0) : 0);
    List<RecordedValue> values = new ArrayList<>();
    all.read(Set.of(port), new TimeRange(start, message.time()), values::add);
    long same = values.stream().filter(each -> each.time() == message.time()).count();
    int at = (int) (values.size() - same + message.place());
    if (at >= values.size()) {
      return Optional.empty();
    }
    DynamicRecord record = record(values.get(at));
    Optional<Bytes> bytes = values.get(at).raw().map(RawMessage::bytes);
    return Optional.of(new MessageContent(message, record, bytes.map(RecordedTopic::first),
        bytes.map(Bytes::size).orElse(0),
        at == 0 ? Optional.empty() : Optional.of(FieldChanges.of(record(values.get(at - 1)), record))));
  }

  private static DynamicRecord record(RecordedValue value) {
    return value.raw().flatMap(RawMessage::record).orElseGet(() -> DataRecord.of(value.value()));
  }

  private static Bytes first(Bytes all) {
    byte[] copy = new byte[Math.min(MOST_BYTES, all.size())];
    all.copyTo(0, copy, 0, copy.length);
    return Bytes.of(copy);
  }
}
