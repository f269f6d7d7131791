package org.robotui.core.internal.host;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.robotui.api.ComponentType;
import org.robotui.api.host.ReuseReport;
import org.robotui.api.host.ReuseReport.Kind;
import org.robotui.api.host.ReuseReport.Row;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.life.Plan;
import org.robotui.core.internal.life.Registry;
import org.robotui.core.internal.watch.BundleNames;

/**
 * Counts which bundles are used by which RUICs: those of their component types, and all of ours that these are wired
 * to.
 */
final class Reuse {
  private static final String OURS = "org.robotui.";
  private static final String ENTITY = "org.robotui.entity.";
  /** They bring all types together, and are used whatever runs. */
  private static final Set<String> CORE = Set.of("org.robotui.core", "org.robotui.workbench", "org.robotui.headless");

  private record Known(Kind kind, String name) {}

  private final Registry registry;
  private final BundleNames bundles;
  private final Map<String, Known> known = new LinkedHashMap<>();
  private final Map<String, List<String>> users = new LinkedHashMap<>();
  private final List<String> ruics = new ArrayList<>();

  Reuse(Registry registry, BundleNames bundles) {
    this.registry = registry;
    this.bundles = bundles;
  }

  /** Counts what a RUIC uses. */
  void add(RuicConfig ruic, Plan plan) {
    ruics.add(ruic.name());
    Set<String> own = new TreeSet<>();
    plan.type().ifPresent(t -> note(Kind.RUIC, t, own));
    ruic.rfics().stream().map(ComponentConfig::type).flatMap(id -> registry.rfic(id).stream())
        .forEach(t -> note(Kind.RFIC, t, own));
    plan.uics().stream().map(ComponentConfig::type).flatMap(id -> registry.uic(id).stream())
        .forEach(t -> note(Kind.UIC, t, own));
    withAllBelow(own).forEach(b -> users.computeIfAbsent(b, k -> new ArrayList<>()).add(ruic.name()));
  }

  private void note(Kind kind, ComponentType type, Set<String> own) {
    registry.bundleOf(type).ifPresent(bundle -> {
      known.putIfAbsent(bundle, new Known(kind, type.label()));
      own.add(bundle);
    });
  }

  private Set<String> withAllBelow(Set<String> own) {
    Set<String> all = new TreeSet<>(own);
    Deque<String> open = new ArrayDeque<>(own);
    while (!open.isEmpty()) {
      bundles.usedBy(open.pop()).stream().filter(b -> b.startsWith(OURS) && !CORE.contains(b) && all.add(b))
          .forEach(open::push);
    }
    return all;
  }

  ReuseReport report() {
    List<Row> rows = users.entrySet().stream().map(e -> row(e.getKey(), e.getValue()))
        .sorted(Comparator.comparing(Row::kind).thenComparing(Row::bundle)).toList();
    return new ReuseReport(ruics, rows);
  }

  private Row row(String bundle, List<String> by) {
    Known what = Optional.ofNullable(known.get(bundle)).orElseGet(() -> new Known(
        bundle.startsWith(ENTITY) ? Kind.ENTITY : Kind.BASE,
        bundle.substring(bundle.startsWith(ENTITY) ? ENTITY.length() : OURS.length())));
    return new Row(what.kind(), bundle, what.name(), by);
  }
}
