package org.robotui.rfic.player.internal.link;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.player.layout.Layouts;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.rfic.player.internal.PlayerSettings;
import org.robotui.rfic.player.internal.device.DeviceFeed;

/**
 * Keeps the devices equal to what the server lists. Used by the one thread that follows them, but for reading and
 * closing.
 */
public final class Devices implements AutoCloseable {
  /** More are no robot's; what lies beyond is named in the link. */
  private static final int MOST = 512;
  private static final List<String> BASES = List.of("position2d:", "position3d:");

  private final PlayerSettings settings;
  private final Layouts layouts;
  private final Function<DeviceAddress, DeviceFeed> feeds;
  private final Map<String, DeviceFeed> byName = new LinkedHashMap<>();
  private volatile Map<String, DeviceFeed> snapshot = Map.of();
  private volatile String base = "";
  private String tooMany = "";
  private boolean closed;

  Devices(PlayerSettings settings, Layouts layouts, Function<DeviceAddress, DeviceFeed> feeds) {
    this.settings = settings;
    this.layouts = layouts;
    this.feeds = feeds;
  }

  /** Those that are there now, by name. */
  public Map<String, DeviceFeed> all() {
    return snapshot;
  }

  /** One of them. */
  public Optional<DeviceFeed> find(String name) {
    return Optional.ofNullable(snapshot.get(name));
  }

  boolean isBase(String name) {
    return name.equals(base);
  }

  /** A device that somebody looks at stays when the server has it no more: it is missing, and may return. */
  synchronized void follow(List<DeviceAddress> listed) {
    if (closed) {
      return;
    }
    Map<String, DeviceAddress> now = new LinkedHashMap<>();
    listed.stream().filter(d -> settings.uses(layouts.nameOf(d))).limit(MOST)
        .forEach(d -> now.putIfAbsent(layouts.nameOf(d), d));
    now.remove(layouts.nameOf(org.robotui.player.wire.DeviceId.SERVER.at(0, 0)));
    tooMany =
        listed.size() > MOST ? "the server lists " + listed.size() + " devices; the first " + MOST + " are used" : "";
    base = settings.base().orElseGet(() -> firstBase(now.keySet().stream().sorted().toList()));
    byName.values().removeIf(feed -> {
      boolean gone = !now.containsKey(feed.name()) && !feed.wanted();
      if (gone) {
        feed.close();
      }
      return gone;
    });
    byName.forEach((name, feed) -> feed.present(now.containsKey(name)));
    now.forEach((name, address) -> byName.computeIfAbsent(name, n -> feeds.apply(address)));
    snapshot = Map.copyOf(byName);
  }

  private static String firstBase(List<String> names) {
    return BASES.stream().flatMap(kind -> names.stream().filter(n -> n.startsWith(kind))).findFirst().orElse("");
  }

  /** What is wanted but does not work, empty where all is well. */
  synchronized String problem() {
    String missingBase = settings.base().isPresent() && !byName.isEmpty() && !byName.containsKey(base)
        ? "the server has no " + base + ", which 'base' names"
        : "";
    return Stream.concat(Stream.of(tooMany, missingBase), byName.values().stream().map(DeviceFeed::problem).sorted())
        .filter(p -> !p.isEmpty()).collect(Collectors.joining("; "));
  }

  @Override
  public synchronized void close() {
    closed = true;
    byName.values().forEach(DeviceFeed::close);
    byName.clear();
    snapshot = Map.of();
  }
}
