package org.robotui.entity.robotmodel.internal;

import java.lang.ref.WeakReference;
import java.util.HashMap;
import java.util.Map;
import org.osgi.service.component.annotations.Component;

/**
 * Remembers the models that displays hold, so that a second display of a robot costs neither reading nor memory. One
 * with problems is read again, as its files may have been mended meanwhile. Safe for all threads.
 */
@Component(service = ModelShelf.class)
public final class ModelShelf {
  private final Map<LoadRequest, WeakReference<Loaded.Model>> held = new HashMap<>();

  /** The model; blocks while it is read. */
  Loaded load(LoadRequest request) {
    Loaded.Model known = known(request);
    Loaded loaded = known == null ? ModelLoader.load(request) : known;
    if (loaded instanceof Loaded.Model model && model.problems().isEmpty()) {
      keep(request, model);
    }
    return loaded;
  }

  private synchronized Loaded.Model known(LoadRequest request) {
    WeakReference<Loaded.Model> reference = held.get(request);
    return reference == null ? null : reference.get();
  }

  private synchronized void keep(LoadRequest request, Loaded.Model model) {
    held.values().removeIf(reference -> reference.refersTo(null));
    held.putIfAbsent(request, new WeakReference<>(model));
  }
}
