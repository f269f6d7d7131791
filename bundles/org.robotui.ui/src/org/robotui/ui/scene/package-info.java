/**
 * Scenes in the plane: a viewport between metres and pixels, a painter in world coordinates, and entities, the building
 * blocks of maps. World axes are those of the fixed frame: x right, y up, angles counter-clockwise.
 *
 * <p>Entities are prepared on a view's worker and painted on the display thread; what passes between is immutable.
 */
@org.osgi.annotation.versioning.Version("2.2.0")
package org.robotui.ui.scene;
