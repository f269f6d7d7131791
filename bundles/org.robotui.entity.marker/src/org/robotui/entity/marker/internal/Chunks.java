package org.robotui.entity.marker.internal;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The solids of all markers, by what they have in common. */
final class Chunks {
  private final Map<Group, List<Chunk>> byGroup = new HashMap<>();
  private final Map<Chunk.Key, Chunk> all = new LinkedHashMap<>();
  private long made;

  Collection<Chunk> all() {
    return all.values();
  }

  /** Adds the pieces of a marker whose spot is known. */
  void add(Held held, Spot spot) {
    List<MarkerShapes.Piece> pieces = held.look().pieces();
    boolean translucent = held.marker().color().alpha() < 1;
    for (int i = 0; i < pieces.size(); i++) {
      Group group = new Group(held.id().source(), held.id().key().namespace(), spot, pieces.get(i).form(), translucent);
      Chunk chunk = room(group);
      chunk.add(held, i);
      held.chunks().add(chunk);
    }
  }

  private Chunk room(Group group) {
    List<Chunk> chunks = byGroup.computeIfAbsent(group, g -> new ArrayList<>());
    return chunks.stream().filter(c -> !c.full()).findFirst().orElseGet(() -> {
      Chunk chunk = new Chunk(made++, group);
      chunks.add(chunk);
      all.put(chunk.key(), chunk);
      return chunk;
    });
  }

  void remove(Held held) {
    for (Chunk chunk : held.chunks()) {
      chunk.remove(held);
      if (chunk.empty() && all.remove(chunk.key()) != null) {
        forget(chunk);
      }
    }
    held.chunks().clear();
  }

  private void forget(Chunk chunk) {
    List<Chunk> chunks = byGroup.get(chunk.group());
    chunks.remove(chunk);
    if (chunks.isEmpty()) {
      byGroup.remove(chunk.group());
    }
  }

  void clear() {
    byGroup.clear();
    all.clear();
  }
}
