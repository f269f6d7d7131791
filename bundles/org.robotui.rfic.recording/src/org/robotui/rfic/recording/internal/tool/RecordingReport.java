package org.robotui.rfic.recording.internal.tool;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;

/** What is in a recording, for people and for programs. */
final class RecordingReport {

  private RecordingReport() {}

  static Set<String> encodings(RecordingReader recording) {
    return recording.channels().stream().map(RecordedChannel::messageEncoding).collect(Collectors.toSet());
  }

  static String text(RecordingReader recording) {
    StringBuilder text = new StringBuilder();
    text.append(recording.file()).append(": ").append(recording.format())
        .append(recording.isIndexed() ? "" : ", without an index that can be used").append('\n');
    recording.span()
        .ifPresent(span -> text.append(LogTime.instant(span.start())).append(" to ").append(LogTime.instant(span.end()))
            .append(String.format(Locale.ROOT, ", %.3f s%n", (span.end() - span.start()) * 1e-9)));
    text.append(total(recording)).append(" messages\n");
    for (RecordedChannel channel : recording.channels()) {
      text.append(String.format(Locale.ROOT, "%12d  %s  %s  %s%n", count(recording, channel), channel.topic(),
          channel.schema().name(), channel.messageEncoding()));
    }
    recording.attachments().forEach(file -> text.append("file ").append(file.name()).append(", ")
        .append(file.size()).append(" bytes\n"));
    recording.metadata().forEach(note -> text.append("note ").append(note.name()).append(' ')
        .append(note.values()).append('\n'));
    recording.damages().forEach(damage -> text.append(damage).append('\n'));
    return text.toString();
  }

  /** One line. Times are numbers of nanoseconds, as strings: many programs have no integers of 64 bits. */
  static String json(RecordingReader recording, Optional<Long> read) {
    JsonLine line = new JsonLine();
    line.open('{').name("file").text(recording.file().toString()).name("format").text(recording.format())
        .name("indexed").word(Boolean.toString(recording.isIndexed()));
    recording.span().ifPresent(span -> span(line, span));
    line.name("messages").word(Long.toString(total(recording)));
    read.ifPresent(messages -> line.name("read").word(messages.toString()));
    line.name("channels").open('[');
    recording.channels().forEach(channel -> channel(line, recording, channel));
    line.close(']').name("attachments").open('[');
    recording.attachments().forEach(file -> line.open('{').name("name").text(file.name()).name("mediaType")
        .text(file.mediaType()).name("size").word(Long.toString(file.size())).close('}'));
    line.close(']').name("metadata").open('[');
    recording.metadata().forEach(note -> texts(line.open('{').name("name").text(note.name()).name("values"),
        note.values()).close('}'));
    line.close(']').name("damages").open('[');
    recording.damages().forEach(damage -> line.open('{').name("offset").word(Long.toString(damage.offset()))
        .name("problem").text(damage.problem()).close('}'));
    return line.close(']').close('}') + "\n";
  }

  private static void span(JsonLine line, RecordingInterval span) {
    line.name("start").text(Long.toString(span.start())).name("end").text(Long.toString(span.end()));
  }

  private static void channel(JsonLine line, RecordingReader recording, RecordedChannel channel) {
    line.open('{').name("topic").text(channel.topic()).name("type").text(channel.schema().name()).name("encoding")
        .text(channel.messageEncoding()).name("schemaEncoding").text(channel.schema().encoding()).name("messages")
        .word(Long.toString(count(recording, channel)));
    texts(line.name("metadata"), channel.metadata()).close('}');
  }

  private static JsonLine texts(JsonLine line, Map<String, String> texts) {
    line.open('{');
    texts.forEach((name, value) -> line.name(name).text(value));
    return line.close('}');
  }

  private static long total(RecordingReader recording) {
    return recording.messageCounts().values().stream().mapToLong(Long::longValue).sum();
  }

  private static long count(RecordingReader recording, RecordedChannel channel) {
    return recording.messageCounts().getOrDefault(channel.id(), 0L);
  }
}
