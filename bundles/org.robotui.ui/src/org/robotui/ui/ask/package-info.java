/**
 * What views that ask robots by a form have in common: listing what can be asked, filling in, asking, and what came
 * back. Models are for a view's tick and its background; panes are for the display thread.
 */
@org.osgi.annotation.versioning.Version("2.1.0")
package org.robotui.ui.ask;
