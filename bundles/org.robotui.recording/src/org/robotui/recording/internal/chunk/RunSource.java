package org.robotui.recording.internal.chunk;

import java.nio.ByteBuffer;
import java.util.List;
import org.robotui.recording.MessageRuns;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingException;

/** Chunks of a format that others know. */
public final class RunSource implements ChunkSource {

  private final MessageRuns runs;

  private RunSource(MessageRuns runs) {
    this.runs = runs;
  }

  public static OpenedRecording open(MessageRuns runs) {
    FileIndex index = new FileIndex();
    runs.channels().forEach(each -> index.channels().put(each.id(), each));
    List<MessageRuns.Run> all = runs.runs();
    for (int i = 0; i < all.size(); i++) {
      MessageRuns.Run run = all.get(i);
      run.counts().forEach((channel, count) -> index.counts().merge(channel, count, Long::sum));
      index.chunks().add(ChunkRef.of(i, 0, run.start(), run.end(),
          run.counts().values().stream().mapToLong(Long::longValue).sum(),
          run.counts().keySet().stream().mapToInt(Integer::intValue).toArray()));
    }
    return new OpenedRecording(runs.file(), runs.format(), false, index, new RunSource(runs), runs::damages,
        runs::close);
  }

  @Override
  public LoadedChunk load(ChunkRef chunk) throws RecordingException {
    List<RecordedMessage> messages = runs.read((int) chunk.offset());
    EntryTable entries = new EntryTable();
    byte[] bytes = new byte[messages.stream().mapToInt(each -> each.data().remaining()).reduce(0, Math::addExact)];
    int at = 0;
    for (RecordedMessage each : messages) {
      int length = each.data().remaining();
      each.data().duplicate().get(bytes, at, length);
      entries.add(each.channel().id(), each.logTime(), each.publishTime(), each.sequence(), at, length);
      at += length;
    }
    return entries.over(bytes);
  }

  @Override
  public ByteBuffer content(RecordedAttachment attachment) throws RecordingException {
    throw new RecordingException(runs.file(), attachment.offset(), runs.format() + " has no attachments");
  }
}
