package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.robotui.api.ComponentType;
import org.robotui.api.RficType;
import org.robotui.api.RuicType;
import org.robotui.api.UicType;
import org.robotui.api.UicType.Surface;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.host.Installed;
import org.robotui.api.host.Installed.Kind;
import org.robotui.core.internal.config.model.TypeLookup;

/** The component types that are installed now. Safe for all threads. */
public final class Registry implements TypeLookup {
  private final TypeTable<RficType> rfics = new TypeTable<>();
  private final TypeTable<UicType> uics = new TypeTable<>();
  private final TypeTable<RuicType> ruics = new TypeTable<>();
  private final List<Supplier<CompletableFuture<Void>>> listeners = new CopyOnWriteArrayList<>();

  /** A type has appeared in a bundle. */
  public void add(RficType type, String bundle) {
    rfics.add(type, bundle);
    changed();
  }

  /** A type has appeared in a bundle. */
  public void add(UicType type, String bundle) {
    uics.add(type, bundle);
    changed();
  }

  /** A type has appeared in a bundle. */
  public void add(RuicType type, String bundle) {
    ruics.add(type, bundle);
    changed();
  }

  /** A type has vanished with its bundle. Completes when nothing that it made is in use any more. */
  public CompletableFuture<Void> remove(ComponentType type) {
    rfics.remove(type);
    uics.remove(type);
    ruics.remove(type);
    return changed();
  }

  private CompletableFuture<Void> changed() {
    synchronized (this) {
      notifyAll();
    }
    return CompletableFuture.allOf(listeners.stream().map(Supplier::get).toArray(CompletableFuture<?>[]::new));
  }

  /** Has somebody told of changes, on the thread that made them; what it gives completes when it has taken them up. */
  public void listen(Supplier<CompletableFuture<Void>> listener) {
    listeners.add(listener);
  }

  /** Waits until something holds that depends on the types, or the time is over. */
  public synchronized void await(BooleanSupplier condition, Duration limit) throws InterruptedException {
    long end = System.nanoTime() + limit.toNanos();
    long left = limit.toNanos();
    while (!condition.getAsBoolean() && left > 0) {
      wait(Math.max(1, left / 1_000_000));
      left = end - System.nanoTime();
    }
  }

  /** Names bundle and class of something made by a type, for messages. */
  public String origin(ComponentType type, Object instance) {
    return "bundle " + bundle(type).orElse("unknown") + ", class " + instance.getClass().getName();
  }

  /** All types, by kind and id. */
  public List<Installed> installed() {
    List<Installed> all = new ArrayList<>();
    rfics.ids().forEach(id -> rfic(id).ifPresent(t -> all.add(installed(Kind.RFIC, t, Optional.empty(), List.of()))));
    uics.ids()
        .forEach(id -> uic(id).ifPresent(t -> all.add(installed(Kind.UIC, t, Optional.of(t.surface()), List.of()))));
    ruics.ids().forEach(id -> ruic(id).ifPresent(t -> all.add(installed(Kind.RUIC, t, Optional.empty(), views(t)))));
    return List.copyOf(all);
  }

  private Installed installed(Kind kind, ComponentType type, Optional<Surface> surface, List<String> views) {
    return new Installed(kind, type.descriptor(), bundle(type).orElse("unknown"), surface, views);
  }

  /** With nothing set; a type that needs something has to be asked with it. */
  private static List<String> views(RuicType type) {
    boolean needs = type.schema().settings().stream().anyMatch(Setting::required);
    return needs ? List.of() : type.uics(usual(type.schema())).stream().map(RuicType.UicSpec::type).toList();
  }

  private static Settings usual(Schema schema) {
    Map<String, Object> values = new HashMap<>();
    schema.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    return new Settings(schema, values);
  }

  /** The bundle of a type, also of one that has gone. */
  public Optional<String> bundleOf(ComponentType type) {
    return bundle(type);
  }

  /** The bundle of a type, also of one that has gone. */
  Optional<String> bundle(ComponentType type) {
    return rfics.bundle(type).or(() -> uics.bundle(type)).or(() -> ruics.bundle(type));
  }

  /** Why there is no such type of robot interface. */
  public String missingRfic(String id) {
    return missing(id, rfics.formerBundle(id), rfics.ids());
  }

  /** Why there is no such type of view. */
  public String missingUic(String id) {
    return missing(id, uics.formerBundle(id), uics.ids());
  }

  /** The types of views that are installed, by id. */
  public List<UicType> uics() {
    return uicIds().stream().flatMap(id -> uic(id).stream()).toList();
  }

  /** Why there is no such type of RUIC. */
  public String missingRuic(String id) {
    return missing(id, ruics.formerBundle(id), ruics.ids());
  }

  private static String missing(String id, Optional<String> bundle, List<String> installed) {
    String known = installed.isEmpty() ? "none is" : "installed are " + String.join(", ", installed);
    return "type '" + id + "' is not "
        + bundle.map(b -> "there; install or start bundle " + b).orElse("installed; " + known);
  }

  @Override
  public Optional<RficType> rfic(String id) {
    return rfics.find(id);
  }

  @Override
  public Optional<UicType> uic(String id) {
    return uics.find(id);
  }

  @Override
  public Optional<RuicType> ruic(String id) {
    return ruics.find(id);
  }

  @Override
  public List<String> rficIds() {
    return rfics.ids();
  }

  @Override
  public List<String> uicIds() {
    return uics.ids();
  }

  @Override
  public List<String> ruicIds() {
    return ruics.ids();
  }
}
