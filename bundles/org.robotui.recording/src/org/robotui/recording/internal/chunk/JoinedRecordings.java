package org.robotui.recording.internal.chunk;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordingDamage;
import org.robotui.recording.RecordingException;

/** Several recordings as one, of which the same channel of each is one. */
public final class JoinedRecordings implements ChunkSource {

  private record Place(OpenedRecording part, ChunkRef chunk, Map<Integer, Integer> numbers) {}

  private final List<Place> places = new ArrayList<>();
  private final Map<RecordedAttachment, OpenedRecording> files = new IdentityHashMap<>();
  private final Map<List<Object>, Integer> known = new HashMap<>();
  private final FileIndex index = new FileIndex();
  private final List<OpenedRecording> parts;
  private final DamageList damages;
  private final Optional<MessageUnpacking> unpacking;

  private JoinedRecordings(List<OpenedRecording> parts, DamageList damages, Optional<MessageUnpacking> unpacking) {
    this.parts = parts;
    this.damages = damages;
    this.unpacking = unpacking;
    parts.forEach(this::add);
  }

  /**
   * @param damages what is wrong with all of it, beside what is wrong with the parts
   * @param unpacking of each message, where they are compressed one by one
   */
  public static OpenedRecording join(Path path, String format, List<OpenedRecording> parts, DamageList damages,
      Optional<MessageUnpacking> unpacking) {
    JoinedRecordings joined = new JoinedRecordings(List.copyOf(parts), damages, unpacking);
    return new OpenedRecording(path, format, parts.stream().allMatch(OpenedRecording::indexed), joined.index, joined,
        joined::damages, () -> parts.forEach(each -> each.end().run()));
  }

  private void add(OpenedRecording part) {
    Map<Integer, Integer> numbers = new HashMap<>();
    Map<List<Object>, Integer> alike = new HashMap<>();
    for (RecordedChannel each : part.index().channels().values()) {
      List<Object> key = List.of(each.topic(), each.messageEncoding(), each.schema());
      int which = alike.merge(key, 1, Integer::sum); // two of one recording stay two
      int number = known.computeIfAbsent(List.of(key, which), any -> known.size());
      numbers.put(each.id(), number);
      index.channels().putIfAbsent(number,
          new RecordedChannel(number, each.topic(), each.messageEncoding(), each.schema(), each.metadata()));
    }
    part.index().counts().forEach((channel, count) -> {
      if (numbers.containsKey(channel)) {
        index.counts().merge(numbers.get(channel), count, Long::sum);
      }
    });
    for (ChunkRef chunk : part.index().chunks()) {
      index.chunks().add(chunk.renumbered(places.size(), numbers));
      places.add(new Place(part, chunk, numbers));
    }
    part.index().attachments().forEach(file -> files.put(file, part));
    index.attachments().addAll(part.index().attachments());
    index.metadata().addAll(part.index().metadata());
  }

  private List<RecordingDamage> damages() {
    List<RecordingDamage> all = new ArrayList<>(damages.all());
    for (OpenedRecording part : parts) {
      String name = part.path().getFileName().toString();
      part.damages().get()
          .forEach(each -> all.add(new RecordingDamage(each.offset(), each.problem() + " (in " + name + ")")));
    }
    return all;
  }

  @Override
  public LoadedChunk load(ChunkRef ref) throws RecordingException {
    Place place = places.get((int) ref.offset());
    LoadedChunk chunk = place.part().source().load(place.chunk());
    return unpacking.isPresent() ? unpacking.get().unpacked(chunk, place.numbers(), damages)
        : chunk.renumbered(place.numbers());
  }

  @Override
  public ByteBuffer content(RecordedAttachment attachment) throws RecordingException {
    OpenedRecording part = files.get(attachment);
    if (part == null) {
      throw new RecordingException(parts.getFirst().path(), attachment.offset(),
          "there is no file " + attachment.name());
    }
    return part.source().content(attachment);
  }
}
