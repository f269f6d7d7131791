package org.robotui.player;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.robotui.player.wire.PlayerMessage;

/**
 * A recorded connection as turns: what the client said, and what the server said then, until the client's next message.
 *
 * @param turns in their order
 */
record Recording(List<Turn> turns) {

  /** One message of the client and what followed it. */
  record Turn(PlayerMessage said, List<PlayerMessage> followed) {}

  private record Timed(double time, boolean fromClient, PlayerMessage message) {}

  private record Segment(double time, boolean fromClient, int length) {}

  static Recording of(String connection) {
    List<Segment> segments =
        new String(Captures.bytes(connection + ".timeline.csv"), StandardCharsets.US_ASCII).lines().skip(1)
            .map(line -> line.split(","))
            .map(row -> new Segment(Double.parseDouble(row[0]), row[1].equals("c2s"), Integer.parseInt(row[2])))
            .toList();
    // at the same instant the answer stands behind its question
    List<Timed> all = Stream.concat(timed(Captures.fromClient(connection), 0, true, segments).stream(),
        timed(Captures.fromServer(connection), PlayerMessage.BANNER_BYTES, false, segments).stream())
        .sorted((a, b) -> Double.compare(a.time, b.time)).toList();
    List<Turn> turns = new ArrayList<>();
    for (Timed each : all) {
      if (each.fromClient) {
        turns.add(new Turn(each.message, new ArrayList<>()));
      } else {
        turns.getLast().followed.add(each.message);
      }
    }
    return new Recording(turns);
  }

  /** A message is as old as the segment with its last byte. */
  private static List<Timed> timed(List<PlayerMessage> messages, int start, boolean fromClient,
      List<Segment> segments) {
    List<Segment> own = segments.stream().filter(each -> each.fromClient == fromClient).toList();
    List<Timed> timed = new ArrayList<>();
    long end = start;
    long covered = 0;
    int segment = -1;
    for (PlayerMessage message : messages) {
      end += PlayerMessage.HEADER_BYTES + message.payload().remaining();
      while (covered < end) {
        segment++;
        covered += own.get(segment).length;
      }
      timed.add(new Timed(own.get(segment).time, fromClient, message));
    }
    return timed;
  }
}
