package org.robotui.ui;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.osgi.framework.BundleContext;
import org.osgi.framework.ServiceReference;

/**
 * Services that come and go while a view runs, taken by their handles: none of the bundles that bring them is started
 * before it is looked at. Safe for all threads.
 *
 * @param <S> the type of the services
 */
public final class ServiceHandles<S> {
  private final Function<ServiceReference<S>, Optional<S>> getter;
  private final List<S> always;
  private final Map<ServiceReference<S>, S> taken = new HashMap<>();

  /**
   * Takes services for a bundle.
   *
   * @param bundles the bundle that takes them
   */
  public ServiceHandles(BundleContext bundles) {
    this(handle -> Optional.ofNullable(bundles.getService(handle)), List.of());
  }

  private ServiceHandles(Function<ServiceReference<S>, Optional<S>> getter, List<S> always) {
    this.getter = getter;
    this.always = List.copyOf(always);
  }

  /**
   * Services that are always there, without a framework.
   *
   * @param <S> the type of the services
   * @param always the services
   * @return gives these, and none of handles
   */
  public static <S> ServiceHandles<S> of(List<S> always) {
    return new ServiceHandles<>(handle -> Optional.empty(), always);
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
      return Stream.concat(always.stream(), there.stream().flatMap(handle -> take(handle).stream())).toList();
    }
  }

  private Optional<S> take(ServiceReference<S> handle) {
    return Optional.ofNullable(taken.get(handle)).or(() -> {
      Optional<S> got = getter.apply(handle);
      got.ifPresent(service -> taken.put(handle, service));
      return got;
    });
  }
}
