package org.robotui.ros2.internal.graph;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.robotui.message.CdrReader;
import org.robotui.message.CdrWriter;
import org.robotui.message.MessageException;
import org.robotui.rtps.Guid;

/**
 * The bytes of {@code rmw_dds_common/msg/ParticipantEntitiesInfo}. Its identifiers have 16 bytes since Iron and had 24
 * before, of which the last eight are zero; nothing but the length of a message tells which it is.
 */
public final class EntitiesCodec {

  /** How long identifiers are since Iron. */
  public static final int GID_BYTES = Guid.BYTES;

  /** How long identifiers are in Humble and before. */
  public static final int OLD_GID_BYTES = 24;

  private static final int MOST_BYTES = 4 << 20;
  private static final int MAX_NODES = 1000;
  private static final int MAX_NAME = 256;

  private EntitiesCodec() {}

  /**
   * What a participant said, and how long its identifiers are.
   *
   * @param entities what it said
   * @param gidBytes 16 or 24
   */
  public record Decoded(Entities entities, int gidBytes) {}

  /**
   * Reads a message.
   *
   * @param in the whole message
   * @return what it says
   * @throws MessageException if the bytes are no such message
   */
  public static Decoded decode(ByteBuffer in) throws MessageException {
    if (in.remaining() > MOST_BYTES) {
      throw new MessageException("a message of " + in.remaining() + " bytes about nodes", "", 0);
    }
    try {
      return new Decoded(decode(in, GID_BYTES), GID_BYTES);
    } catch (MessageException recent) {
      try {
        return new Decoded(decode(in, OLD_GID_BYTES), OLD_GID_BYTES);
      } catch (MessageException old) {
        throw recent;
      }
    }
  }

  private static Entities decode(ByteBuffer in, int gidBytes) throws MessageException {
    CdrReader reader = new CdrReader(in);
    Guid participant = gid(reader, gidBytes);
    int count = reader.count("node_entities_info_seq", 2 * (Integer.BYTES + 1));
    if (count > MAX_NODES) {
      throw new MessageException("a participant with " + count + " nodes", "node_entities_info_seq", 0);
    }
    List<Entities.Node> nodes = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      nodes.add(new Entities.Node(name(reader, "node_namespace"), name(reader, "node_name"),
          gids(reader, "reader_gid_seq", gidBytes), gids(reader, "writer_gid_seq", gidBytes)));
    }
    reader.end();
    return new Entities(participant, List.copyOf(nodes));
  }

  private static String name(CdrReader reader, String field) throws MessageException {
    String text = reader.string(field);
    if (text.length() > MAX_NAME) {
      throw new MessageException("a name of " + text.length() + " characters", field, 0);
    }
    return text;
  }

  private static List<Guid> gids(CdrReader reader, String field, int gidBytes) throws MessageException {
    int count = reader.count(field, gidBytes);
    List<Guid> all = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      all.add(gid(reader, gidBytes));
    }
    return List.copyOf(all);
  }

  private static Guid gid(CdrReader reader, int gidBytes) throws MessageException {
    return Guid.of(reader.bytes("data", gidBytes, 1));
  }

  /**
   * Writes a message.
   *
   * @param entities what it says
   * @param gidBytes 16 or 24
   * @return the whole message
   */
  public static ByteBuffer encode(Entities entities, int gidBytes) {
    CdrWriter out = new CdrWriter();
    gid(out, entities.participant(), gidBytes);
    out.array(entities.nodes().size());
    for (Entities.Node node : entities.nodes()) {
      out.string(node.namespace()).string(node.name());
      out.array(node.readers().size());
      node.readers().forEach(each -> gid(out, each, gidBytes));
      out.array(node.writers().size());
      node.writers().forEach(each -> gid(out, each, gidBytes));
    }
    return out.view();
  }

  private static void gid(CdrWriter out, Guid guid, int gidBytes) {
    out.bytes(guid.bytes(), 0, Guid.BYTES);
    out.bytes(new byte[gidBytes - Guid.BYTES], 0, gidBytes - Guid.BYTES);
  }
}
