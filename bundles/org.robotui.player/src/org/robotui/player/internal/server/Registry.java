package org.robotui.player.internal.server;

import java.nio.ByteBuffer;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.net.log.LogThrottle;
import org.robotui.player.server.Answer;
import org.robotui.player.server.DeviceHandler;
import org.robotui.player.wire.DeviceId;
import org.robotui.player.wire.PlayerMessage;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The devices of a server and who has them open. */
public final class Registry {

  private static final Logger LOG = LoggerFactory.getLogger(Registry.class);

  /**
   * Clients by each time that they have opened it: who has opened it twice is sent all data twice, as by real servers,
   * and has to close it twice.
   */
  private record Entry(String driver, DeviceHandler handler, List<ClientSession> clients) {}

  private final Map<DeviceId, Entry> devices =
      new ConcurrentSkipListMap<>(Comparator.comparingInt(DeviceId::interfaceCode).thenComparingInt(DeviceId::index));
  private final LogThrottle failures = new LogThrottle();

  /** Adds a device that is not there yet. */
  public void add(DeviceId id, String driver, DeviceHandler handler) {
    if (devices.putIfAbsent(id, new Entry(driver, handler, new CopyOnWriteArrayList<>())) != null) {
      throw new IllegalArgumentException("there is a device " + id + " already");
    }
  }

  /** Sends data to all who have the device open. */
  public void publish(DeviceId id, int subtype, ByteBuffer payload, double stamp) {
    devices.get(id).clients.forEach(client -> client.data(id, subtype, payload, stamp));
  }

  /** How often it is open. */
  public int clients(DeviceId id) {
    return devices.get(id).clients.size();
  }

  List<DeviceId> all() {
    return List.copyOf(devices.keySet());
  }

  boolean has(DeviceId id) {
    return devices.containsKey(id);
  }

  Optional<String> driver(DeviceId id) {
    return Optional.ofNullable(devices.get(id)).map(Entry::driver);
  }

  boolean isOpen(DeviceId id, ClientSession client) {
    return Optional.ofNullable(devices.get(id)).filter(entry -> entry.clients.contains(client)).isPresent();
  }

  void open(DeviceId id, ClientSession client) {
    Entry entry = devices.get(id);
    entry.clients.add(client);
    tell(id, entry);
  }

  void close(DeviceId id, ClientSession client) {
    Entry entry = devices.get(id);
    if (entry.clients.remove(client)) {
      tell(id, entry);
    }
  }

  void closeAll(ClientSession client) {
    devices.forEach((id, entry) -> {
      if (entry.clients.removeIf(each -> each == client)) {
        tell(id, entry);
      }
    });
  }

  void command(PlayerMessage command) {
    try {
      devices.get(command.device().id()).handler.onCommand(command);
    } catch (RuntimeException e) {
      failed(command.device().id(), e);
    }
  }

  Answer request(PlayerMessage request) {
    try {
      return devices.get(request.device().id()).handler.onRequest(request);
    } catch (RuntimeException e) {
      failed(request.device().id(), e);
      return Answer.refused();
    }
  }

  private void tell(DeviceId id, Entry entry) {
    try {
      entry.handler.onClients(entry.clients.size());
    } catch (RuntimeException e) {
      failed(id, e);
    }
  }

  private void failed(DeviceId id, RuntimeException e) {
    if (failures.admit()) {
      LOG.error("the handler of {} failed ({} so far)", id, failures.count(), e);
    }
  }
}
