package org.robotui.ui;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.osgi.framework.BundleContext;
import org.osgi.framework.ServiceReference;

/**
 * Services that come and go while a view runs, taken by their handles: none of the bundles that bring them is started
 * before it is looked at. Safe for all threads.
 *
 * @param <S> the type of the services
 */
public final class ServiceHandles<S> {
  private final BundleContext bundles;
  private final Map<ServiceReference<S>, S> taken = new HashMap<>();

  /**
   * Takes services for a bundle.
   *
   * @param bundles the bundle that takes them
   */
  public ServiceHandles(BundleContext bundles) {
    this.bundles = bundles;
  }

  /**
   * The services of handles; a bundle that is just going gives none.
   *
   * @param there the handles that are there now
   * @return their services in the same order
   */
  public List<S> take(List<ServiceReference<S>> there) {
    synchronized (taken) {
      if (taken.size() > there.size()) {
        taken.keySet().retainAll(there);
      }
      return there.stream().flatMap(handle -> take(handle).stream()).toList();
    }
  }

  private Optional<S> take(ServiceReference<S> handle) {
    return Optional.ofNullable(taken.get(handle)).or(() -> {
      Optional<S> got = Optional.ofNullable(bundles.getService(handle));
      got.ifPresent(service -> taken.put(handle, service));
      return got;
    });
  }
}
