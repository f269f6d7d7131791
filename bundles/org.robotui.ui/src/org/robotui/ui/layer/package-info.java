/**
 * How a bundle brings a kind of layer into maps: a {@link org.robotui.ui.layer.LayerType} as an OSGi service. The map
 * and the GPS view take what comes and goes while they run; displays of scenes in space are brought in the same manner.
 *
 * <p>A layer is prepared on the worker of its view and painted on the display thread; what passes between is immutable.
 */
@org.osgi.annotation.versioning.Version("1.3.0")
package org.robotui.ui.layer;
