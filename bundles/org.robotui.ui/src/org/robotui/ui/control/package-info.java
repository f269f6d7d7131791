/**
 * Flat controls in the colours of the theme, for what widgets of the platform would draw in colours of their own.
 */
@org.osgi.annotation.versioning.Version("1.10.0")
package org.robotui.ui.control;
