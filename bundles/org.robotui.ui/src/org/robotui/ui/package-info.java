/**
 * How views appear in a window: the SWT contract of a view, the theme, and the vocabulary of states that all views
 * share.
 *
 * <p>Views take colours and fonts from the {@link org.robotui.ui.Theme} only, so that every view looks right in every
 * theme.
 */
@org.osgi.annotation.versioning.Version("2.5.0")
package org.robotui.ui;
