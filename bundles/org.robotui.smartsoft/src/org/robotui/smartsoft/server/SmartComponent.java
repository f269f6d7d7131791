package org.robotui.smartsoft.server;

import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.smartsoft.naming.NamingClient;
import org.robotui.smartsoft.naming.ServiceName;
import org.robotui.smartsoft.naming.SmartPattern;

/** A component: servers that are entered at a naming service under one name. Safe for all threads. */
public final class SmartComponent implements Closeable {

  private final String name;
  private final NamingClient naming;
  private final Map<ServiceName, PatternServer> services = new ConcurrentHashMap<>();

  /**
   * Of a name.
   *
   * @param name of the component
   * @param naming is closed with the component
   */
  public SmartComponent(String name, NamingClient naming) {
    this.name = name;
    this.naming = naming;
  }

  /**
   * Enters a service.
   *
   * @param pattern how it is used
   * @param service its name within the component
   * @param types the names of its communication objects
   * @param server is closed with the component
   * @param <S> the kind of server
   * @return the server
   * @throws IOException where it cannot be entered; the server is closed then
   */
  public <S extends PatternServer> S offer(SmartPattern pattern, String service, List<String> types, S server)
      throws IOException {
    ServiceName entered = new ServiceName(name, pattern.word(), service, types);
    try {
      naming.bind(entered, server.address());
      services.put(entered, server);
      return server;
    } catch (IOException e) {
      server.close();
      throw e;
    }
  }

  /** Removes its services from the naming service, and ends them. */
  @Override
  public void close() {
    List<PatternServer> all = new ArrayList<>(services.values());
    for (ServiceName each : services.keySet()) {
      if (!naming.isOver()) {
        remove(each);
      }
    }
    services.clear();
    all.forEach(PatternServer::close);
    naming.close();
  }

  private void remove(ServiceName each) {
    try {
      naming.unbind(each);
    } catch (IOException e) {
      naming.close(); // one that hangs is not asked again
    }
  }
}
