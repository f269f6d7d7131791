package org.robotui.rfic.smartsoft.internal.feed;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentSkipListMap;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.DefinitionException;
import org.robotui.smartsoft.naming.NamedService;
import org.robotui.smartsoft.naming.ServiceName;
import org.robotui.smartsoft.naming.SmartPattern;
import org.robotui.smartsoft.object.CommType;

/**
 * The services that a naming service knows, and the ports of those whose objects come by themselves. Used by the thread
 * that follows, but for reading and closing. A port stays when its service goes: components come back.
 */
public final class SmartServices implements AutoCloseable {
  /** More are no robot's. */
  private static final int MOST = 512;

  private final SmartShared shared;
  private final NamingDirectory directory;
  private final FeedPlan plan;
  private final Map<String, ServiceFeed> feeds = new ConcurrentSkipListMap<>();
  private final Map<String, SmartOutlet<DynamicRecord>> unknown = new ConcurrentSkipListMap<>();
  private volatile Map<String, NamedService> known = Map.of();
  private boolean closed; // guarded by this

  public SmartServices(SmartShared shared, NamingDirectory directory) {
    this.shared = shared;
    this.directory = directory;
    this.plan = new FeedPlan(shared);
  }

  /** Looks what there is now; blocks. */
  public void discover() throws IOException {
    Map<String, NamedService> found = new TreeMap<>();
    for (NamedService each : directory.list()) {
      if (each.name().known().isPresent() && found.size() < MOST) {
        found.putIfAbsent(each.name().path(), each);
      }
    }
    known = Map.copyOf(found);
    found.forEach((path, service) -> add(path, service.name()));
    feeds.forEach((path, feed) -> feed.at(Optional.ofNullable(found.get(path))));
  }

  private synchronized void add(String path, ServiceName name) {
    SmartPattern pattern = name.known().orElseThrow();
    boolean comes = pattern == SmartPattern.PUSH || pattern == SmartPattern.EVENT;
    if (closed || !comes || feeds.containsKey(path) || unknown.containsKey(path)
        || feeds.size() + unknown.size() >= MOST) {
      return;
    }
    try {
      CommType comesOf = described(name.types().getLast());
      feeds.put(path, pattern == SmartPattern.PUSH ? plan.push(name, comesOf)
          : plan.event(name, described(name.types().getFirst()), comesOf));
    } catch (DefinitionException e) {
      unknown.put(path, plan.unknown(name, e.getMessage()));
    }
  }

  /** The type of a name; says what to do where there is no description of it. */
  public CommType described(String type) throws DefinitionException {
    Optional<CommType> found = shared.types().find(type);
    int colons = Math.max(0, type.indexOf("::"));
    return found.orElseThrow(() -> new DefinitionException(type, "its objects are not described; put "
        + type.substring(0, colons) + ".idl into a folder and name that with 'objects'"));
  }

  /** Connects to what is wanted, and to no more; may block. */
  public void tick() {
    List<ServiceFeed> all = new ArrayList<>(feeds.values());
    boolean carry = shared.tree().wanted() || all.stream().anyMatch(ServiceFeed::placedAndWanted);
    for (ServiceFeed feed : all) {
      feed.tick(feed.wanted() || carry && feed.type().name().equals(FeedPlan.BASE_STATE));
    }
  }

  /** Services that are entered now, by component and service. */
  public Map<String, NamedService> known() {
    return known;
  }

  /** A service. */
  public Optional<NamedService> find(String path) {
    return Optional.ofNullable(known.get(path));
  }

  /** Those that are used in a way, with objects of a type in the first place. */
  public Map<String, NamedService> of(SmartPattern pattern, String type) {
    Map<String, NamedService> found = new HashMap<>();
    known.forEach((path, service) -> {
      if (service.name().known().equals(Optional.of(pattern)) && service.name().types().getFirst().equals(type)) {
        found.put(path, service);
      }
    });
    return new TreeMap<>(found);
  }

  /** Whether anything of a robot is there. */
  public boolean isEmpty() {
    return known.isEmpty();
  }

  /** Whether a component is linked, whatever the naming service does. */
  public boolean isAlive() {
    return feeds.values().stream().anyMatch(ServiceFeed::isAlive);
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
    }
    feeds.values().forEach(ServiceFeed::finish);
    feeds.values().forEach(ServiceFeed::close);
    unknown.values().forEach(SmartOutlet::close);
  }
}
